import { useRef } from 'preact/hooks';
import { saveCsv, saveSvg } from '../kit/download';
import { plain } from '../kit/format';
import { labelLines } from '../kit/labels';
import { apartTicks, linearTicks } from '../kit/ticks';
import { useWidth } from './chart';
import { Figure } from './figure';

export interface ForestRow {
  name: string;
  value: number | null;
  lower: number | null;
  upper: number | null;
  /** Stands out as the answer. */
  chosen: boolean;
}

interface Props {
  title: string;
  rows: ForestRow[];
  label: string;
  /** What chance reaches. */
  chance: number | null;
  /** The scale is linear throughout, as for per cent. */
  linear?: boolean;
  note: string;
}

const kNarrow = 520; // px; the names stand above their rows
const kLetter = 6.6;
const kLine = 15;
const kMostLines = 8;
const kRowMargin = 11;
const kTick = 34; // a number
const kBottom = 40;

/** The scale is linear up to chance and logarithmic beyond, since gains go from −10 to 10 000. */
const squeeze = (value: number, unit: number) => Math.sign(value) * Math.log1p(Math.abs(value) / unit);

/** Where each row stands: its names, and the middle of its values. */
function placesOf(lines: string[][], isNarrow: boolean): { top: number; middle: number }[] {
  let y = 6;
  return lines.map((one) => {
    const top = y;
    const names = one.length * kLine;
    y += names + kRowMargin + (isNarrow ? kLine : 0);
    return { top, middle: isNarrow ? top + names + kLine / 2 + 2 : top + (names + kRowMargin) / 2 };
  });
}

/** Values with intervals, one a row. */
export function Forest({ title, rows, label, chance, linear, note }: Props) {
  const [box, width] = useWidth();
  const picture = useRef<SVGSVGElement>(null);
  const wide = Math.max(width, 240);
  const isNarrow = wide < kNarrow;
  const names = isNarrow ? 0 : Math.min(wide * 0.42, 300);
  const letters = Math.floor((isNarrow ? wide : names) / kLetter);
  const lines = labelLines(
    rows.map((row) => row.name),
    letters,
    kMostLines,
  );
  const places = placesOf(lines, isNarrow);
  const unit = linear ? 1e9 : Math.max(chance ?? 1, 1);
  const all = rows
    .flatMap((row) => [row.value, row.lower, row.upper])
    .concat([0, chance])
    .filter((one): one is number => one !== null && Number.isFinite(one));
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const [from, to] = [squeeze(low, unit), squeeze(high, unit)];
  const place = (value: number) =>
    names + 12 + ((wide - names - 30) * (squeeze(value, unit) - from)) / Math.max(to - from, 1e-9);
  const candidates = high > 20 * unit ? [-1e4, -1e3, -100, -10, 0, 10, 100, 1e3, 1e4, 1e5] : linearTicks(low, high, 5);
  const ticks = apartTicks(
    candidates.filter((one) => one >= low && one <= high),
    place,
    kTick,
    0,
  );
  const rowsEnd = places.length === 0 ? 6 : places[places.length - 1].middle + kLine;
  const height = rowsEnd + kBottom;
  return (
    <Figure
      title={title}
      note={note}
      downloads={[
        { label: 'SVG', run: () => saveSvg(picture.current!, title) },
        {
          label: 'CSV',
          run: () =>
            saveCsv(
              ['name', label, 'lower', 'upper'],
              rows.map((row) => [row.name, row.value, row.lower, row.upper]),
              title,
            ),
        },
      ]}
    >
      <div class="chart" ref={box}>
        {width > 0 && (
          <svg ref={picture} width={wide} height={height} role="img" aria-label={title}>
            <g class="grid">
              {ticks.map((tick) => (
                <line key={tick} x1={place(tick)} x2={place(tick)} y1={4} y2={rowsEnd} />
              ))}
            </g>
            <g class="ticks">
              {ticks.map((tick) => (
                <text key={tick} x={place(tick)} y={rowsEnd + 14} text-anchor="middle">
                  {plain(tick, 1)}
                </text>
              ))}
            </g>
            <text class="axis-title" x={(names + wide) / 2} y={height - 6} text-anchor="middle">
              {label}
            </text>
            {chance !== null && (
              <g class="ink-floor">
                <line class="line dashed" x1={place(chance)} x2={place(chance)} y1={4} y2={rowsEnd} />
              </g>
            )}
            {rows.map((row, i) => {
              const { top, middle } = places[i];
              return (
                <g key={i} class={row.chosen ? 'ink-predicted' : 'ink-floor'}>
                  <text class="row-name" text-anchor={isNarrow ? 'start' : 'end'}>
                    <title>{row.name}</title>
                    {lines[i].map((line, at) => (
                      <tspan key={at} x={names} y={top + (at + 0.8) * kLine + (isNarrow ? 0 : kRowMargin / 2)}>
                        {line}
                      </tspan>
                    ))}
                  </text>
                  {row.lower !== null && row.upper !== null && (
                    <line class="whisker thick" x1={place(row.lower)} x2={place(row.upper)} y1={middle} y2={middle} />
                  )}
                  {row.value !== null && <circle class="point" cx={place(row.value)} cy={middle} r={4.5} />}
                </g>
              );
            })}
          </svg>
        )}
      </div>
    </Figure>
  );
}
