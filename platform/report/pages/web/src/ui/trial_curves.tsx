import { useEffect, useMemo, useState } from 'preact/hooks';
import { sampleAt } from '../kit/decimate';
import { quantity } from '../kit/format';
import type { Moment } from '../kit/moment';
import { View } from '../kit/view';
import type { ChannelCurves, TrialCurves } from '../pages/compare_data';
import { Curves, type Line } from './curves';

interface Props {
  curves: TrialCurves;
  title: string;
  /** What was different on the rig. */
  setup?: string | null;
  lit: [number, number][];
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
      {quantity(times[i], 's', 4)}: measured {value(channel.measured)}, predicted {value(channel.predicted)}, residual{' '}
      {value(channel.residual)}
    </>
  );
}

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
      { name: 'measured', colour: 'measured', series: channel.measured },
      ...(channel.predicted ? [{ name: 'predicted', colour: 'predicted' as const, series: channel.predicted }] : []),
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
  return (
    <div class="channel">
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
  const view = useMemo(() => new View(times[0], times[times.length - 1]), [times]);
  const [time, setTime] = useState<number | null>(null);
  useKeys(view, !props.moment);
  return (
    <figure class="figure trial-curves">
      <figcaption>
        <span class="figure-title">{props.title}</span>
        <span class="legend">
          <span class="key ink-measured">
            <i />
            measured
          </span>
          <span class="key ink-predicted">
            <i />
            predicted
          </span>
          <span class="key ink-residual">
            <i />
            residual
          </span>
          {channels.some((one) => one.floor) && (
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
      {props.setup && <p class="note">On the rig in this trial: {props.setup}.</p>}
      {channels.map((channel, i) => (
        <Channel
          key={channel.name}
          channel={channel}
          last={i === channels.length - 1 && commands.length === 0}
          props={props}
          view={view}
          time={time}
          hover={setTime}
        />
      ))}
      {commands.map((command, i) => (
        <CommandCurve key={command.name} command={command} last={i === commands.length - 1} props={props} view={view} />
      ))}
      <p class="note keys">
        Drag to zoom (with fingers: to pan, two zoom), shift and drag to pan, ctrl and wheel to zoom, double click for
        everything; keys ← → + − 0.
      </p>
    </figure>
  );
}

function CommandCurve({
  command,
  last,
  props,
  view,
}: {
  command: ChannelCurves;
  last: boolean;
  props: Props;
  view: View;
}) {
  const lines = useMemo((): Line[] => [{ name: 'command', colour: 'other', series: command.measured }], [command]);
  return (
    <div class="channel">
      <div class="channel-head">
        <strong>{command.name}</strong> <span class="muted">command</span>
      </div>
      <Curves
        times={props.curves.times}
        view={view}
        unit={command.unit}
        label={command.name}
        lines={lines}
        height={last ? 112 : 80}
        lit={props.lit}
        moment={props.moment}
        go={props.go}
        withTime={last}
      />
    </div>
  );
}
