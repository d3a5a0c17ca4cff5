import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Colour } from '../kit/colours';
import { saveCsv, saveSvg } from '../kit/download';
import { logTickTexts, prefixFor, quantity, tickTexts, unitText } from '../kit/format';
import { linearTicks, logTicks } from '../kit/ticks';
import { Figure } from './figure';
import { nameLines, roomForNames, TickName } from './tick_names';

export interface ChartSeries {
  name: string;
  /** The legend does not have it; the readout and the CSV file do. */
  unlisted?: boolean;
  kind: 'line' | 'points' | 'band' | 'both';
  x: number[];
  /** NaN: a gap. */
  y: number[];
  lower?: number[];
  upper?: number[];
  colour: Colour;
  dashed?: boolean;
  faint?: boolean;
  /** How many values each point is a mean of. */
  counts?: number[];
}

export interface Axis {
  label: string;
  unit: string;
  log?: boolean;
  /** Always within the picture. */
  include?: number[];
  whole?: boolean;
  names?: string[];
}

export interface ChartProps {
  title: string;
  x: Axis;
  y: Axis;
  series: ChartSeries[];
  /** Horizontal lines. */
  levels?: { name: string; at: number; colour: Colour }[];
  height?: number;
  note?: string;
  /** What the CSV file has instead of the points. */
  csv?: { columns: string[]; rows: unknown[][] };
  pick?: (series: number, index: number) => void;
  chosen?: { series: number; index: number };
}

const kTitle = 30; // px, from the left of a picture to the end of its title and what keeps it apart from numbers
const kLetter = 6.6;
const kMargin = { left: 62, right: 14, top: 8, bottom: 40 };

interface Scale {
  low: number;
  high: number;
  ticks: number[];
  place: (value: number) => number;
}

const kTickHeight = 14; // px of a number
const kTickWidth = 44;
const kNearest = 1e-307; // to 0, of a logarithmic axis
const kFarthest = 1e300; // a scale of 2e308 would overflow

/** Values that no scale holds are gaps. */
function withoutFarValues(series: ChartSeries[]): ChartSeries[] {
  const near = (values: number[]) => values.map((one) => (Math.abs(one) < kFarthest ? one : NaN));
  return series.map((one) => ({
    ...one,
    x: near(one.x),
    y: near(one.y),
    lower: one.lower && near(one.lower),
    upper: one.upper && near(one.upper),
  }));
}

function scaleOf(values: number[], axis: Axis, from: number, to: number): Scale {
  const finite = values.concat(axis.include ?? []).filter((one) => Number.isFinite(one) && (!axis.log || one > 0));
  let low = finite.reduce((a, b) => Math.min(a, b), Infinity),
    high = finite.reduce((a, b) => Math.max(a, b), -Infinity);
  if (low > high) [low, high] = axis.log ? [0.1, 1] : [0, 1];
  if (axis.log) {
    if (high / low < 1.5) [low, high] = [low / 1.5, high * 1.5];
    const margin = Math.exp(0.04 * (Math.log(high) - Math.log(low)));
    [low, high] = [Math.max(low / margin, kNearest), Math.min(high * margin, 1 / kNearest)];
    const length = Math.log(high) - Math.log(low);
    const place = (value: number) => from + ((to - from) * (Math.log(value) - Math.log(low))) / length;
    const room = from > to ? kTickHeight : kTickWidth;
    return { low, high, ticks: logTicks(low, high, room / Math.max(Math.abs(to - from), 1)), place };
  }
  if (high - low < 1e-12 * Math.max(Math.abs(low), Math.abs(high), 1e-300)) [low, high] = [low - 0.5, high + 0.5];
  const margin = axis.whole ? 0.3 : 0.04 * (high - low);
  const floor = low >= 0 && low - margin < 0 && !axis.whole ? 0 : low - margin;
  [low, high] = [floor, high + margin];
  if (axis.names)
    return {
      low,
      high,
      ticks: axis.names.map((_, i) => i),
      place: (value) => from + ((to - from) * (value - low)) / (high - low),
    };
  let ticks = linearTicks(low, high, Math.abs(to - from) / (axis.whole ? 44 : from > to ? 42 : 70));
  if (axis.whole) ticks = ticks.filter(Number.isInteger);
  return { low, high, ticks, place: (value) => from + ((to - from) * (value - low)) / (high - low) };
}

const path = (x: number[], y: number[]) => {
  let text = '',
    pen = false;
  for (let i = 0; i < x.length; ++i) {
    if (!Number.isFinite(x[i]) || !Number.isFinite(y[i])) {
      pen = false;
      continue;
    }
    text += `${pen ? 'L' : 'M'}${x[i].toFixed(1)} ${y[i].toFixed(1)}`;
    pen = true;
  }
  return text;
};

/** Whether there is anything to see of it. */
const hasData = (one: ChartSeries) =>
  one.kind === 'band'
    ? one.x.some((_, i) => Number.isFinite(one.lower?.[i]) && Number.isFinite(one.upper?.[i]))
    : one.y.some((y, i) => Number.isFinite(y) && Number.isFinite(one.x[i]));

const bandPath = (x: number[], lower: number[], upper: number[]) => {
  const known = x.map((_, i) => i).filter((i) => Number.isFinite(lower[i]) && Number.isFinite(upper[i]));
  if (known.length === 0) return '';
  const there = known.map((i) => `${x[i].toFixed(1)} ${upper[i].toFixed(1)}`);
  const back = known.reverse().map((i) => `${x[i].toFixed(1)} ${lower[i].toFixed(1)}`);
  return `M${there.join('L')}L${back.join('L')}Z`;
};

/** The points, by the names of their places where these have names. */
function pointsOf({ series, x, y }: ChartProps): { columns: string[]; rows: unknown[][] } {
  const counted = series.some((one) => one.counts);
  return {
    columns: [
      'series',
      axisTitle(x, '') || 'name',
      axisTitle(y, ''),
      'lower',
      'upper',
      ...(counted ? ['mean_of'] : []),
    ],
    rows: series.flatMap((one) =>
      one.x.map((value, i) => [
        one.name,
        x.names ? x.names[Math.round(value)] : value,
        one.y[i],
        one.lower?.[i],
        one.upper?.[i],
        ...(counted ? [one.counts?.[i]] : []),
      ]),
    ),
  };
}

export function useWidth(): [preact.RefObject<HTMLDivElement>, number] {
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => setWidth(Math.floor(entry.contentRect.width)));
    observer.observe(box.current!);
    return () => observer.disconnect();
  }, []);
  return [box, width];
}

const axisTitle = (axis: Axis, symbol: string) => {
  const unit = symbol + unitText(axis.unit);
  return unit ? `${axis.label} / ${unit}` : axis.label;
};

/** A small picture of lines, points and bands, drawn as SVG. */
export function Chart(props: ChartProps) {
  const { title, height = 240 } = props;
  const levels = (props.levels ?? []).filter((one) => Number.isFinite(one.at));
  const series = useMemo(() => withoutFarValues(props.series), [props.series]);
  const [box, width] = useWidth();
  const picture = useRef<SVGSVGElement>(null);
  const [near, setNear] = useState<{ series: number; index: number } | null>(null);
  const wide = Math.max(width, 200);
  const prefix = (axis: Axis, scale: Scale) =>
    prefixFor(Math.max(Math.abs(scale.low), Math.abs(scale.high)), axis.unit);
  // Names turn by the room that they have, and how high the picture is follows; its left side follows the numbers there.
  const { turn, room } = roomForNames(props.x.names, wide - kMargin.left - kMargin.right);
  const bottom = kMargin.bottom + room;
  const y = useMemo(() => {
    const values = series.flatMap((one) => [
      ...(one.kind === 'band' ? [] : one.y),
      ...(one.lower ?? []),
      ...(one.upper ?? []),
    ]);
    return scaleOf([...values, ...levels.map((one) => one.at)], props.y, height - bottom, kMargin.top);
  }, [series, props.y, height, bottom]);
  const py = prefix(props.y, y);
  const yTexts = (props.y.log ? logTickTexts : tickTexts)(y.ticks, py.factor);
  const left = Math.max(kMargin.left, kTitle + kLetter * Math.max(0, ...yTexts.map((one) => one.length)));
  const x = useMemo(
    () =>
      scaleOf(
        series.flatMap((one) => one.x),
        props.x,
        left,
        wide - kMargin.right,
      ),
    [series, props.x, wide, left],
  );
  const px = prefix(props.x, x);
  const xTexts = props.x.names
    ? x.ticks.map((tick) => props.x.names![tick] ?? '')
    : (props.x.log ? logTickTexts : tickTexts)(x.ticks, px.factor);
  const xLines = props.x.names ? nameLines(xTexts) : xTexts.map((one) => [one]);
  // The end of a band or whisker: what a logarithmic axis does not reach lies below the picture.
  const end = (value: number) => (props.y.log && value <= 0 ? height - bottom : y.place(value));

  const find = (event: MouseEvent) => {
    const place = picture.current!.getBoundingClientRect();
    const at = [event.clientX - place.left, event.clientY - place.top];
    let best = 30 * 30,
      found: typeof near = null;
    series.forEach(
      (one, s) =>
        one.kind !== 'band' &&
        one.x.forEach((value, i) => {
          const away = (x.place(value) - at[0]) ** 2 + (y.place(one.y[i]) - at[1]) ** 2;
          if (away < best) {
            best = away;
            found = { series: s, index: i };
          }
        }),
    );
    setNear(found);
  };
  const shown = near && series[near.series] && near.index < series[near.series].x.length ? near : null;
  const tell = shown && series[shown.series];

  const downloads = [
    { label: 'SVG', run: () => saveSvg(picture.current!, title) },
    {
      label: 'CSV',
      run: () => {
        const { columns, rows } = props.csv ?? pointsOf({ ...props, series });
        saveCsv(columns, rows, title);
      },
    },
  ];
  return (
    <Figure title={title} note={props.note} downloads={downloads}>
      <div class="legend">
        {series
          .filter((one) => one.name !== '' && !one.unlisted && hasData(one))
          .map((one) => (
            <span key={one.name} class={`key ink-${one.colour} ${one.kind} ${one.dashed ? 'dashed' : ''}`}>
              <i />
              {one.name}
            </span>
          ))}
        {levels.map((one) => (
          <span key={one.name} class={`key ink-${one.colour} dashed`}>
            <i />
            {one.name}
          </span>
        ))}
        <span class="readout">
          {tell &&
            shown &&
            `${tell.name}${tell.name ? ': ' : ''}${props.x.names ? (props.x.names[Math.round(tell.x[shown.index])] ?? '') : quantity(tell.x[shown.index], props.x.unit)} → ${quantity(tell.y[shown.index], props.y.unit)}${tell.counts ? `, of ${tell.counts[shown.index]}` : ''}`}
        </span>
      </div>
      <div class="chart" ref={box}>
        {width > 0 && (
          <svg
            ref={picture}
            width={wide}
            height={height}
            role="img"
            aria-label={title}
            onMouseMove={find}
            onMouseLeave={() => setNear(null)}
            onClick={() => shown && props.pick?.(shown.series, shown.index)}
            class={props.pick ? 'pickable' : ''}
          >
            <g class="grid">
              {y.ticks.map((tick) => (
                <line key={tick} x1={left} x2={wide - kMargin.right} y1={y.place(tick)} y2={y.place(tick)} />
              ))}
            </g>
            <g class="ticks">
              {y.ticks.map((tick, i) => (
                <text key={tick} x={left - 6} y={y.place(tick) + 4} text-anchor="end">
                  {yTexts[i]}
                </text>
              ))}
              {x.ticks.map((tick, i) => (
                <TickName
                  key={tick}
                  name={xTexts[i]}
                  lines={xLines[i]}
                  x={x.place(tick)}
                  y={height - bottom + 16}
                  turn={turn}
                />
              ))}
              {x.ticks.map((tick) => (
                <line key={tick} x1={x.place(tick)} x2={x.place(tick)} y1={height - bottom} y2={height - bottom + 4} />
              ))}
            </g>
            <line class="axis" x1={left} x2={wide - kMargin.right} y1={height - bottom} y2={height - bottom} />
            <text class="axis-title" x={(left + wide - kMargin.right) / 2} y={height - 6} text-anchor="middle">
              {axisTitle(props.x, px.symbol)}
            </text>
            <text
              class="axis-title"
              text-anchor="middle"
              transform={`translate(12 ${(height - bottom + kMargin.top) / 2}) rotate(-90)`}
            >
              {axisTitle(props.y, py.symbol)}
            </text>
            {levels.map((one) => (
              <line
                key={one.name}
                class={`line dashed ink-${one.colour}`}
                x1={left}
                x2={wide - kMargin.right}
                y1={y.place(one.at)}
                y2={y.place(one.at)}
              />
            ))}
            {series.map((one, s) => {
              const xs = one.x.map(x.place),
                ys = one.y.map(y.place);
              return (
                <g key={s} class={`ink-${one.colour} ${one.faint ? 'faint' : ''}`}>
                  {one.lower && one.upper && one.kind !== 'points' && one.kind !== 'both' && (
                    <path class="band" d={bandPath(xs, one.lower.map(end), one.upper.map(end))} />
                  )}
                  {one.lower &&
                    one.upper &&
                    (one.kind === 'points' || one.kind === 'both') &&
                    xs.map(
                      (at, i) =>
                        Number.isFinite(one.lower![i]) &&
                        Number.isFinite(one.upper![i]) && (
                          <line
                            key={i}
                            class="whisker"
                            x1={at}
                            x2={at}
                            y1={end(one.lower![i])}
                            y2={end(one.upper![i])}
                          />
                        ),
                    )}
                  {(one.kind === 'line' || one.kind === 'both') && (
                    <path class={`line ${one.dashed ? 'dashed' : ''}`} d={path(xs, ys)} />
                  )}
                  {(one.kind === 'points' || one.kind === 'both') &&
                    xs.map(
                      (at, i) =>
                        Number.isFinite(ys[i]) && (
                          <circle key={i} class="point" cx={at} cy={ys[i]} r={one.x.length > 300 ? 1.6 : 3.2} />
                        ),
                    )}
                </g>
              );
            })}
            {[shown, props.chosen].map(
              (one, i) =>
                one &&
                series[one.series] && (
                  <circle
                    key={i}
                    class="ring"
                    cx={x.place(series[one.series].x[one.index])}
                    cy={y.place(series[one.series].y[one.index])}
                    r={6}
                  />
                ),
            )}
          </svg>
        )}
      </div>
    </Figure>
  );
}
