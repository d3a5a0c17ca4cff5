import { useRef } from 'preact/hooks';
import type { ForceCurve } from '../pages/diagnose_data';
import { saveCsv, saveSvg } from '../kit/download';
import { forceWord, plain, prefixFor, quantity, unitText } from '../kit/format';
import { Chart, useWidth } from './chart';
import { Figure } from './figure';

/** Blue to white to orange: below, at and above zero, apart for colour-blind people too. */
function heat(share: number): string {
  const [r, g, b] = share < 0 ? [0, 114, 178] : [213, 94, 0];
  const strength = Math.min(Math.abs(share), 1);
  const mix = (one: number) => Math.round(245 + (one - 245) * strength);
  return `rgb(${mix(r)}, ${mix(g)}, ${mix(b)})`;
}

/** Of the model as it is, or what no effect explains. */
type Kind = 'missing' | 'unexplained';

function titleOf(kind: Kind, name: string, unit: string): string {
  const word = forceWord(unit);
  return kind === 'missing' ? `Missing ${word} on ${name}` : `${word === 'torque' ? 'Torque' : 'Force'} on ${name}`;
}

/** The force that the residual shows: a curve a feature, and a map where it is known over velocity at several positions. */
export function ForceMap({ curves, kind }: { curves: ForceCurve[]; kind: Kind }) {
  const groups = grouped(curves);
  return (
    <>
      {groups.map(([name, members]) => {
        const placed = members.filter((one) => one.position !== undefined);
        return placed.length > 2 ? (
          <Heat key={name} title={`${titleOf('unexplained', name, placed[0].force_unit)} and position`} curves={placed} />
        ) : (
          <Curve key={name} title={titleOf(kind, name, members[0].force_unit)} curves={members} />
        );
      })}
    </>
  );
}

function grouped(curves: ForceCurve[]): [string, ForceCurve[]][] {
  const groups = new Map<string, ForceCurve[]>();
  for (const one of curves) {
    const name = `${one.joint} over ${one.of}`;
    groups.set(name, [...(groups.get(name) ?? []), one]);
  }
  return [...groups];
}

/** Position is over the velocity that it is the integral of. */
const positionUnit = (curve: ForceCurve) => curve.unit.replace(/\/s$/, '');

const withUnit = (label: string, unit: string) => (unitText(unit) ? `${label} / ${unitText(unit)}` : label);

const keep = (curves: ForceCurve[], title: string) =>
  saveCsv(
    ['joint', 'of', 'at', 'unit', 'position', 'position_unit', 'force', 'standard_error', 'by_answer', 'force_unit'],
    curves.flatMap((one) =>
      one.at.map((at, i) => [
        one.joint,
        one.of,
        at,
        one.unit,
        one.position,
        positionUnit(one),
        one.force[i],
        one.standard_error[i],
        one.by_answer?.[i] ?? null,
        one.force_unit,
      ]),
    ),
    title,
  );

function Curve({ title, curves }: { title: string; curves: ForceCurve[] }) {
  const first = curves[0];
  const colours = ['residual', 'predicted', 'truth'] as const;
  return (
    <Chart
      title={title}
      x={{ label: first.of, unit: first.unit }}
      y={{ label: forceWord(first.force_unit), unit: first.force_unit, include: [0] }}
      note={
        first.by_answer
          ? `${forceWord(first.force_unit) === 'torque' ? 'Torque' : 'Force'} that the model lacks with its present fitted values (nonparametric, ± 2 standard errors), and what the answer adds. If the curves differ, the answer has the wrong formula.`
          : `Nonparametric residual ${forceWord(first.force_unit)} that fits best, ± 2 standard errors.`
      }
      series={curves.flatMap((one, i) => [
        {
          name: '',
          kind: 'band' as const,
          colour: colours[i % 3],
          x: one.at,
          y: one.force,
          lower: one.force.map((f, k) => f - 2 * one.standard_error[k]),
          upper: one.force.map((f, k) => f + 2 * one.standard_error[k]),
        },
        {
          name: one.by_answer ? 'missing' : one.position === undefined ? one.of : `at position ${quantity(one.position, positionUnit(one))}`,
          kind: 'both' as const,
          colour: colours[i % 3],
          x: one.at,
          y: one.force,
        },
        ...(one.by_answer
          ? [{ name: 'answer', kind: 'line' as const, colour: 'predicted' as const, x: one.at, y: one.by_answer }]
          : []),
      ])}
    />
  );
}

function Heat({ title, curves }: { title: string; curves: ForceCurve[] }) {
  const [box, width] = useWidth();
  const picture = useRef<SVGSVGElement>(null);
  const rows = [...curves].sort((a, b) => (b.position ?? 0) - (a.position ?? 0));
  const columns = Math.max(...rows.map((one) => one.at.length));
  const most = Math.max(...rows.flatMap((one) => one.force.map(Math.abs)), 1e-300);
  const [left, bottom, cell] = [70, 44, 30];
  const wide = Math.max(width, 200),
    each = (wide - left - 10) / columns;
  const prefix = prefixFor(most, rows[0].force_unit);
  return (
    <Figure
      title={title}
      downloads={[
        { label: 'SVG', run: () => saveSvg(picture.current!, title) },
        { label: 'CSV', run: () => keep(curves, title) },
      ]}
      note={`Orange: positive; blue: negative. Full colour: ${quantity(most, rows[0].force_unit)}. Numbers in ${prefix.symbol}${unitText(rows[0].force_unit)}.`}
    >
      <div class="chart" ref={box}>
        {width > 0 && (
          <svg ref={picture} width={wide} height={rows.length * cell + bottom} role="img" aria-label={title}>
            {rows.map((row, r) => (
              <g key={r}>
                <text x={left - 6} y={r * cell + cell / 2 + 4} text-anchor="end">
                  {plain(row.position)}
                </text>
                {row.force.map((force, c) => (
                  <g key={c}>
                    <rect x={left + c * each} y={r * cell} width={each - 1} height={cell - 1} fill={heat(force / most)}>
                      <title>{`${quantity(force, row.force_unit)} ± ${quantity(row.standard_error[c], row.force_unit)}`}</title>
                    </rect>
                    {each > 34 && (
                      <text
                        class="on-heat"
                        x={left + (c + 0.5) * each}
                        y={r * cell + cell / 2 + 4}
                        text-anchor="middle"
                      >
                        {plain(force * prefix.factor, 2)}
                      </text>
                    )}
                  </g>
                ))}
              </g>
            ))}
            {rows[0].at.map(
              (at, c) =>
                c % Math.ceil(columns / 8) === 0 && (
                  <text key={c} x={left + (c + 0.5) * each} y={rows.length * cell + 14} text-anchor="middle">
                    {plain(at)}
                  </text>
                ),
            )}
            <text class="axis-title" x={(left + wide) / 2} y={rows.length * cell + 36} text-anchor="middle">
              {withUnit(rows[0].of, rows[0].unit)}
            </text>
            <text
              class="axis-title"
              text-anchor="middle"
              transform={`translate(12 ${(rows.length * cell) / 2}) rotate(-90)`}
            >
              {withUnit('position', positionUnit(rows[0]))}
            </text>
          </svg>
        )}
      </div>
    </Figure>
  );
}
