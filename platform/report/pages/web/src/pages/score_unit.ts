import { useRows } from '../data/use';
import { unitText } from '../kit/format';

/** Unit of the error of a run's models. */
export interface ScoreUnit {
  /** "1" where channels of several units count together, or where the metric may have one of its own. */
  unit: string;
  /** The channels with their units: "angle (rad), torque (N·m)"; empty where they are not known. */
  channels: string;
}

interface ChannelRow {
  name: string;
  unit: string;
}

// Metrics whose score is in the unit of the channels.
const kInChannelUnits = ['mean_absolute_difference'];

export const kChannelsOfRun = `SELECT json_extract(channel.value, '$.name') AS name, json_extract(channel.value, '$.unit') AS unit
  FROM (SELECT trace.channels FROM target_trial JOIN trace ON trace.trial = target_trial.trial AND trace.kind = 'measured'
        WHERE target_trial.run = ? ORDER BY target_trial.number LIMIT 1) AS first, json_each(first.channels) AS channel`;

export function scoreUnit(metric: string, channels: ChannelRow[]): ScoreUnit {
  const units = [...new Set(channels.map((one) => one.unit))];
  const isOne = units.length === 1 && kInChannelUnits.includes(metric);
  return {
    unit: isOne ? units[0] : '1',
    channels: channels.map((one) => (unitText(one.unit) ? `${one.name} (${unitText(one.unit)})` : one.name)).join(', '),
  };
}

export function useScoreUnit({ run, metric }: { run: number; metric: string }): ScoreUnit {
  return scoreUnit(metric, useRows<ChannelRow>(kChannelsOfRun, [run]).value ?? []);
}
