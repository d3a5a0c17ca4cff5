import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { sampleAt } from '../kit/decimate';
import { quantity } from '../kit/format';
import type { Moment } from '../kit/moment';
import { View } from '../kit/view';
import type { ChannelCurves, TrialCurves } from '../pages/compare_data';
import { CommandPanels } from './command_curves';
import { Curves, type Line } from './curves';

interface Props {
  curves: TrialCurves;
  title: string;
  /** The setup of the trial. */
  setup?: string | null;
  lit: [number, number][];
  /** A channel to bring into sight, and the stretch of time to show at first. */
  channel?: string | null;
  stretch?: [number, number];
  keep: () => void;
  /** A moment that moves, and how to move it: for the replay, which has the arrow keys to itself. */
  moment?: Moment;
  go?: (time: number) => void;
}

/** Arrows pan, + and − zoom, 0 shows everything, unless something is being typed. */
function useKeys(view: View, arrows: boolean): void {
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (
        /^(INPUT|TEXTAREA|SELECT)$/.test((event.target as Element).tagName) ||
        event.ctrlKey ||
        event.metaKey ||
        event.altKey
      )
        return;
      const actions: Record<string, () => void> = {
        ...(arrows ? { ArrowLeft: () => view.pan(-0.2), ArrowRight: () => view.pan(0.2) } : {}),
        '+': () => view.zoom(0.5),
        '=': () => view.zoom(0.5),
        '-': () => view.zoom(2),
        '0': () => view.reset(),
      };
      if (!actions[event.key]) return;
      actions[event.key]();
      event.preventDefault();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, [view, arrows]);
}

function Readout({ channel, times, time }: { channel: ChannelCurves; times: Float64Array; time: number | null }) {
  if (time === null) return null;
  const i = Math.min(sampleAt(times, time), times.length - 1);
  const value = (series: { values: Float64Array } | null) =>
    series ? quantity(series.values[i], channel.unit, 4) : '—';
  return (
    <>
      {quantity(times[i], 's', 4)}: measured {value(channel.measured)}
      {channel.predicted && `, predicted ${value(channel.predicted)}, residual ${value(channel.residual)}`}
    </>
  );
}

const kBroad = 4; // px

/** One channel: measured and predicted, and below them their difference with the noise floor. */
function Channel({
  channel,
  last,
  props,
  view,
  time,
  hover,
}: {
  channel: ChannelCurves;
  last: boolean;
  props: Props;
  view: View;
  time: number | null;
  hover: (time: number | null) => void;
}) {
  const both = useMemo(
    (): Line[] => [
      // Broad, below the other: it is seen where the two coincide, too.
      channel.predicted
        ? { name: 'measured', colour: 'broad', series: channel.measured, width: kBroad }
        : { name: 'measured', colour: 'measured', series: channel.measured },
      ...(channel.predicted
        ? [{ name: 'predicted', colour: 'predicted' as const, series: channel.predicted, width: 1.5 }]
        : []),
    ],
    [channel],
  );
  const rest = useMemo(
    (): Line[] => (channel.residual ? [{ name: 'residual', colour: 'residual', series: channel.residual }] : []),
    [channel],
  );
  const common = {
    times: props.curves.times,
    view,
    unit: channel.unit,
    hover,
    lit: props.lit,
    moment: props.moment,
    go: props.go,
  };
  const box = useRef<HTMLDivElement>(null);
  const isChosen = props.channel === channel.name && props.curves.channels.length > 1;
  useEffect(() => {
    if (isChosen) box.current!.scrollIntoView({ block: 'nearest' });
  }, [isChosen]);
  return (
    <div class={`channel ${isChosen ? 'chosen' : ''}`} ref={box}>
      <div class="channel-head">
        <strong>{channel.name}</strong>
        <span class="readout">
          <Readout channel={channel} times={props.curves.times} time={time} />
        </span>
      </div>
      <Curves {...common} label={channel.name} lines={both} height={150} withTime={last && rest.length === 0} />
      {rest.length > 0 && (
        <Curves
          {...common}
          label="residual"
          lines={rest}
          height={last ? 132 : 104}
          floor={channel.floor}
          withTime={last}
        />
      )}
    </div>
  );
}

export function TrialCurvesPanel(props: Props) {
  const { times, channels, commands } = props.curves;
  const [first, last] = [times[0], times[times.length - 1]];
  const view = useMemo(() => new View(first, last, ...(props.stretch ?? [first, last])), [times]);
  const [from, to] = props.stretch ?? [first, last];
  const isFirst = useRef(true);
  useEffect(() => {
    if (!isFirst.current) view.set(from, to);
    isFirst.current = false;
  }, [from, to]);
  const hasPrediction = channels.some((one) => one.predicted);
  const [time, setTime] = useState<number | null>(null);
  useKeys(view, !props.moment);
  return (
    <figure class="figure trial-curves">
      <figcaption>
        <span class="figure-title">{props.title}</span>
        <span class="legend">
          <span class={`key ${hasPrediction ? 'ink-broad broad' : 'ink-measured'}`}>
            <i />
            measured
          </span>
          {hasPrediction && (
            <span class="key ink-predicted">
              <i />
              predicted
            </span>
          )}
          {channels.some((one) => one.residual) && (
            <span class="key ink-residual">
              <i />
              residual
            </span>
          )}
          {channels.some((one) => one.floor && one.residual) && (
            <span class="key swatch-floor">
              <i />± noise floor
            </span>
          )}
          {props.lit.length > 0 && (
            <span class="key swatch-lit">
              <i />
              chosen finding
            </span>
          )}
        </span>
        <button class="quiet" title="Zoom in (+)" aria-label="Zoom in" onClick={() => view.zoom(0.5)}>
          +
        </button>
        <button class="quiet" title="Zoom out (−)" aria-label="Zoom out" onClick={() => view.zoom(2)}>
          −
        </button>
        <button class="quiet" title="Show everything (0)" onClick={() => view.reset()}>
          all
        </button>
        <button
          class="quiet download"
          onClick={() => {
            view.complete();
            props.keep();
          }}
        >
          PNG
        </button>
      </figcaption>
      {props.setup && <p class="note">Setup of this trial: {props.setup}.</p>}
      {channels.map((channel, i) => (
        <Channel
          key={channel.name}
          channel={channel}
          last={i === channels.length - 1 && commands === null}
          props={props}
          view={view}
          time={time}
          hover={setTime}
        />
      ))}
      {commands && (
        <CommandPanels
          commands={commands}
          view={view}
          common={{ lit: props.lit, moment: props.moment, go: props.go }}
        />
      )}
      <p class="note keys">
        Drag to zoom, shift and drag to pan, ctrl and wheel to zoom, double click to show everything. Touch: one finger
        pans, two fingers zoom. Keys: ← → + − 0.
      </p>
    </figure>
  );
}
