import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import { colourNow, type Colour } from '../kit/colours';
import { drawn, type Series } from '../kit/decimate';
import { prefixFor, tickTexts, unitText } from '../kit/format';
import type { Moment } from '../kit/moment';
import { kPaperWidth, whenPrinted } from '../kit/paper';
import type { View } from '../kit/view';

export interface Line {
  name: string;
  colour: Colour;
  series: Series;
  width?: number;
  dashed?: boolean;
  /** What stays as it is until the next sample. */
  stepped?: boolean;
}

export interface CurvesProps {
  label: string;
  unit: string;
  times: Float64Array;
  lines: Line[];
  view: View;
  height: number;
  /** Drawn as a band from −floor to floor. */
  floor?: number | null;
  /** Stretches of time to light up. */
  lit?: [number, number][];
  /** With numbers at the time axis. */
  withTime?: boolean;
  /** A moment to mark, for the replay. */
  moment?: Moment;
  /** A click goes there. */
  go?: (time: number) => void;
  hover?: (time: number | null) => void;
}

const kMotion = uPlot.sync('lacuna');

function band(u: uPlot, floor: number): void {
  const [top, bottom] = [u.valToPos(floor, 'y', true), u.valToPos(-floor, 'y', true)];
  u.ctx.fillStyle = colourNow('band');
  u.ctx.fillRect(u.bbox.left, top, u.bbox.width, bottom - top);
}

function light(u: uPlot, lit: [number, number][]): void {
  u.ctx.fillStyle = colourNow('lit');
  const right = u.bbox.left + u.bbox.width;
  for (const [from, to] of lit) {
    const left = Math.max(u.valToPos(from, 'x', true), u.bbox.left),
      end = Math.min(u.valToPos(to, 'x', true), right);
    if (end > left) u.ctx.fillRect(left, u.bbox.top, Math.max(end - left, 1), u.bbox.height);
  }
}

/** A line at the moment, above the canvas, so that nothing is drawn again while it moves. */
function follow(u: uPlot, moment: Moment, view: View): () => void {
  const line = document.createElement('div');
  line.className = 'moment';
  u.over.append(line);
  const place = () => {
    const [from, to] = view.range;
    const share = (moment.time - from) / (to - from);
    line.hidden = share < 0 || share > 1;
    line.style.left = `${100 * share}%`;
  };
  place();
  const stops = [moment.listen(place), view.listen(place)];
  return () => stops.forEach((stop) => stop());
}

function magnitude(lines: Line[], floor: number | null | undefined): number {
  return lines.reduce((most, line) => {
    const [low, high] = line.series.extremes(0, line.series.values.length);
    return Math.max(most, Math.abs(low) || 0, Math.abs(high) || 0);
  }, floor ?? 0);
}

function options(props: CurvesProps, width: number, now: () => CurvesProps): uPlot.Options {
  const prefix = prefixFor(magnitude(props.lines, props.floor), props.unit);
  const unit = prefix.symbol + unitText(props.unit);
  const axis = {
    stroke: () => colourNow('muted'),
    grid: { stroke: () => colourNow('grid'), width: 1 },
    ticks: { show: false },
    font: '11px system-ui, sans-serif',
    labelFont: '11px system-ui, sans-serif',
  };
  return {
    width,
    height: props.height,
    legend: { show: false },
    pxAlign: 0,
    cursor: {
      sync: { key: kMotion.key, setSeries: false },
      drag: { x: true, y: false, setScale: false },
      points: { show: false },
      y: false,
    },
    scales: {
      x: { time: false, auto: false, range: () => now().view.range },
      y: {
        range: (_, low, high) => {
          const floor = now().floor ?? 0;
          const [a, b] = [Math.min(low ?? 0, -floor), Math.max(high ?? 0, floor)];
          const margin = 0.06 * (b - a) || 0.1 * Math.abs(a) || 1;
          return floor > 0 ? [a - margin, b + margin] : [(low ?? 0) - margin, (high ?? 0) + margin];
        },
      },
    },
    axes: [
      {
        ...axis,
        size: props.withTime ? 16 : 4,
        label: props.withTime ? 'time / s' : undefined,
        labelSize: props.withTime ? 16 : 0,
        labelGap: 0,
        gap: 2,
        values: props.withTime ? (_, ticks) => tickTexts(ticks) : () => [],
      },
      {
        ...axis,
        size: 50,
        label: unit ? `${props.label} / ${unit}` : props.label,
        labelSize: 18,
        gap: 3,
        values: (_, ticks) => tickTexts(ticks, prefix.factor),
        space: 22,
      },
    ],
    series: [
      {},
      ...props.lines.map((line) => ({
        label: line.name,
        stroke: () => colourNow(line.colour),
        width: line.width ?? 1,
        points: { show: false },
        ...(line.dashed ? { dash: [6, 4] } : {}),
        ...(line.stepped ? { paths: uPlot.paths.stepped!({ align: 1 }) } : {}),
      })),
    ],
    hooks: {
      drawClear: [
        (u) => {
          const { floor, lit } = now();
          if (floor) band(u, floor);
          if (lit) light(u, lit);
        },
      ],
      setCursor: [
        (u) =>
          now().hover?.(u.cursor.idx === null || u.cursor.idx === undefined ? null : u.posToVal(u.cursor.left!, 'x')),
      ],
      setSelect: [
        (u) => {
          if (u.select.width < 4) return;
          now().view.set(u.posToVal(u.select.left, 'x'), u.posToVal(u.select.left + u.select.width, 'x'));
          u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
        },
      ],
    },
  };
}

/** Wheel zooms, shift and drag pans, a double click shows everything. */
function listenTo(u: uPlot, view: View, now: () => CurvesProps): void {
  u.over.addEventListener(
    'wheel',
    (event) => {
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        view.pan((event.deltaX || event.deltaY) / u.over.clientWidth);
      } else if (event.ctrlKey || event.altKey) {
        const left = event.clientX - u.over.getBoundingClientRect().left;
        view.zoom(event.deltaY > 0 ? 1.25 : 0.8, u.posToVal(left, 'x'));
      } else {
        return; // the page scrolls
      }
      event.preventDefault();
    },
    { passive: false },
  );
  u.over.addEventListener('click', (event) =>
    now().go?.(u.posToVal(event.clientX - u.over.getBoundingClientRect().left, 'x')),
  );
  u.over.addEventListener('dblclick', () => view.reset());
  u.over.addEventListener(
    'mousedown',
    (event) => {
      if (!event.shiftKey) return;
      event.stopImmediatePropagation();
      event.preventDefault();
      let last = event.clientX;
      const move = (now: MouseEvent) => {
        view.pan((last - now.clientX) / u.over.clientWidth);
        last = now.clientX;
      };
      addEventListener('mousemove', move);
      addEventListener('mouseup', () => removeEventListener('mousemove', move), { once: true });
    },
    { capture: true },
  );
}

/** One finger sideways pans, two zoom; up and down the page scrolls (style.css has the touch-action). */
function listenToFingers(u: uPlot, view: View): void {
  const places = (event: TouchEvent) => [...event.touches].map((one) => one.clientX).sort((a, b) => a - b);
  let last: number[] = [];
  u.over.addEventListener(
    'touchstart',
    (event) => {
      last = places(event);
    },
    { passive: true },
  );
  u.over.addEventListener(
    'touchmove',
    (event) => {
      const now = places(event);
      if (now.length === 1 && last.length === 1) view.pan((last[0] - now[0]) / u.over.clientWidth);
      if (now.length === 2 && last.length === 2 && now[1] - now[0] > 10) {
        const left = u.over.getBoundingClientRect().left;
        view.zoom((last[1] - last[0]) / (now[1] - now[0]), u.posToVal((now[0] + now[1]) / 2 - left, 'x'));
      }
      last = now;
    },
    { passive: true },
  );
}

/** Curves over time on a canvas. Several with one view move together. */
export function Curves(props: CurvesProps) {
  const box = useRef<HTMLDivElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const plot = useRef<uPlot | null>(null);

  useEffect(() => {
    const host = box.current!;
    let visible = true,
      stale = true;
    const u = new uPlot(
      options(props, Math.max(host.clientWidth, 120), () => latest.current),
      [[]] as never,
      host,
    );
    plot.current = u;
    listenTo(u, props.view, () => latest.current);
    listenToFingers(u, props.view);
    const unfollow = props.moment && follow(u, props.moment, props.view);
    const draw = (all = false) => {
      if (!visible && !all) {
        stale = true;
        return;
      }
      stale = false;
      const [from, to] = props.view.range;
      const data = drawn(
        props.times,
        props.lines.map((line) => line.series),
        from,
        to,
        Math.max(u.width - 70, 100),
      );
      u.batch(() => {
        u.setData(data as unknown as uPlot.AlignedData, false);
        u.setScale('x', { min: from, max: to });
      });
    };
    draw();
    const stop = props.view.listen(draw);
    const resize = (width: number) => {
      if (width <= 0 || width === u.width) return;
      u.setSize({ width, height: props.height });
      draw();
    };
    const sizes = new ResizeObserver(() => resize(host.clientWidth));
    sizes.observe(host);
    const sight = new IntersectionObserver(
      ([entry]) => {
        visible = entry.isIntersecting;
        if (visible && stale) draw();
      },
      { rootMargin: '100px' },
    );
    sight.observe(host);
    const repaint = () => u.redraw(false);
    addEventListener('lacuna-theme', repaint);
    const unprinted = whenPrinted(
      () => {
        resize(kPaperWidth);
        draw(true);
      },
      () => resize(host.clientWidth),
    );
    return () => {
      unprinted();
      removeEventListener('lacuna-theme', repaint);
      unfollow?.();
      stop();
      sizes.disconnect();
      sight.disconnect();
      u.destroy();
      plot.current = null;
    };
  }, [props.times, props.view, props.lines, props.height, props.unit, props.floor]);

  useEffect(() => {
    plot.current?.redraw(false);
  }, [props.lit]);

  return <div class="curves" ref={box} aria-label={`${props.label} over time`} role="img" />;
}
