import { useRef } from 'preact/hooks';
import { saveCsv, saveSvg } from '../kit/download';
import { plain } from '../kit/format';
import { linearTicks } from '../kit/ticks';
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
  note: string;
}

const kRow = 26;
const kTallRow = 40; // with the name above
const kNarrow = 520; // px
const kBottom = 40;

/** The scale is linear up to chance and logarithmic beyond, since gains go from −10 to 10 000. */
const squeeze = (value: number, unit: number) => Math.sign(value) * Math.log1p(Math.abs(value) / unit);

/** Values with intervals, one a row. */
export function Forest({ title, rows, label, chance, note }: Props) {
  const [box, width] = useWidth();
  const picture = useRef<SVGSVGElement>(null);
  const wide = Math.max(width, 240);
  const isNarrow = wide < kNarrow;
  const names = isNarrow ? 0 : Math.min(wide * 0.42, 300);
  const letters = Math.floor((isNarrow ? wide : names) / 6.6);
  const rowHeight = isNarrow ? kTallRow : kRow;
  const unit = Math.max(chance ?? 1, 1);
  const all = rows
    .flatMap((row) => [row.value, row.lower, row.upper])
    .concat([0, chance])
    .filter((one): one is number => one !== null && Number.isFinite(one));
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const [from, to] = [squeeze(low, unit), squeeze(high, unit)];
  const place = (value: number) =>
    names + 12 + ((wide - names - 30) * (squeeze(value, unit) - from)) / Math.max(to - from, 1e-9);
  const candidates = high > 20 * unit ? [-1e4, -1e3, -100, -10, 0, 10, 100, 1e3, 1e4, 1e5] : linearTicks(low, high, 5);
  const ticks = candidates
    .filter((one) => one >= low && one <= high)
    .filter(
      (one, i, list) =>
        one === 0 || list.slice(0, i).every((other) => Math.abs(place(other) - place(one)) > 30 || other === one),
    );
  const height = rows.length * rowHeight + kBottom + 6;
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
                <line key={tick} x1={place(tick)} x2={place(tick)} y1={4} y2={height - kBottom} />
              ))}
            </g>
            <g class="ticks">
              {ticks.map((tick) => (
                <text key={tick} x={place(tick)} y={height - kBottom + 14} text-anchor="middle">
                  {plain(tick, 1)}
                </text>
              ))}
            </g>
            <text class="axis-title" x={(names + wide) / 2} y={height - 6} text-anchor="middle">
              {label}
            </text>
            {chance !== null && (
              <g class="ink-floor">
                <line class="line dashed" x1={place(chance)} x2={place(chance)} y1={4} y2={height - kBottom} />
              </g>
            )}
            {rows.map((row, i) => {
              const y = 6 + (i + 1) * rowHeight - kRow / 2;
              return (
                <g key={i} class={row.chosen ? 'ink-predicted' : 'ink-floor'}>
                  <text
                    class="row-name"
                    x={names}
                    y={isNarrow ? y - 12 : y + 4}
                    text-anchor={isNarrow ? 'start' : 'end'}
                  >
                    <title>{row.name}</title>
                    {row.name.length > letters ? `${row.name.slice(0, letters - 1)}…` : row.name}
                  </text>
                  {row.lower !== null && row.upper !== null && (
                    <line class="whisker thick" x1={place(row.lower)} x2={place(row.upper)} y1={y} y2={y} />
                  )}
                  {row.value !== null && <circle class="point" cx={place(row.value)} cy={y} r={4.5} />}
                </g>
              );
            })}
          </svg>
        )}
      </div>
    </Figure>
  );
}
