import { useMemo, useState } from 'preact/hooks';
import { seriesColour } from '../kit/colours';
import { sampleAt } from '../kit/decimate';
import { quantity } from '../kit/format';
import type { View } from '../kit/view';
import type { CommandCurves, TrialCurves } from '../pages/compare_data';
import { Curves, type CurvesProps, type Line } from './curves';

interface Props {
  commands: NonNullable<TrialCurves['commands']>;
  view: View;
  common: Pick<CurvesProps, 'lit' | 'moment' | 'go'>;
}

const kSparse = 400; // samples in sight, below which steps can be told from slopes

/** Commands over the time axis of the readings: those of one unit in one picture. */
export function CommandPanels({ commands, view, common }: Props) {
  const groups = useMemo(
    () =>
      [...new Set(commands.channels.map((one) => one.unit))].map((unit) =>
        commands.channels.filter((one) => one.unit === unit),
      ),
    [commands],
  );
  return (
    <>
      {groups.map((channels, i) => (
        <CommandPanel
          key={channels[0].unit}
          times={commands.times}
          channels={channels}
          last={i === groups.length - 1}
          view={view}
          common={common}
        />
      ))}
    </>
  );
}

interface PanelProps {
  times: Float64Array;
  channels: CommandCurves[];
  last: boolean;
  view: View;
  common: Props['common'];
}

function CommandPanel({ times, channels, last, view, common }: PanelProps) {
  const [time, setTime] = useState<number | null>(null);
  const lines = useMemo(
    (): Line[] =>
      channels.map((one, i) => ({
        name: one.name,
        colour: channels.length === 1 ? 'other' : seriesColour(i),
        series: one.series,
        stepped: times.length <= kSparse,
      })),
    [channels, times],
  );
  // The command that holds is that of the sample before.
  const at = time === null ? 0 : Math.max(sampleAt(times, time + 1e-12) - 1, 0);
  return (
    <div class="channel commands">
      <div class="channel-head legend">
        <strong>{channels.length === 1 ? 'command' : 'commands'}</strong>
        {lines.map((line) => (
          <span key={line.name} class={`key ink-${line.colour}`}>
            <i />
            {line.name}
            {time !== null && `: ${quantity(line.series.values[at], channels[0].unit, 4)}`}
          </span>
        ))}
      </div>
      <Curves
        {...common}
        times={times}
        view={view}
        unit={channels[0].unit}
        label={channels.length === 1 ? channels[0].name : 'command'}
        lines={lines}
        height={last ? 132 : 104}
        withTime={last}
        hover={setTime}
      />
    </div>
  );
}
