import { Series } from '../kit/decimate';
import { times } from '../kit/format';
import { objects, type Source } from '../data/source';
import { loadTraces, type Channel, type Trace } from '../data/trace';

export interface Score {
  experiment: string;
  revision: number;
  trial: string;
  held_out: number;
  channel: string;
  unit: string;
  rmse: number | null;
  floor: number | null;
  times_floor: number | null;
  normalised_rmse: number | null;
  max_error: number | null;
  max_error_time: number | null;
  comparison: number;
}

/** What was different on the rig in a trial; see schema/database.md, `trial_setups`. */
export interface TrialSetup {
  comparison: number;
  trial: string;
  setup: string;
  settings: string | null;
  own: string | null;
}

export const kSetups = `SELECT DISTINCT score.comparison, trial_setups.trial, setup, settings, own FROM trial_setups
  JOIN comparison_score AS score ON score.trial = trial_setups.id ORDER BY score.comparison, trial_setups.trial`;

/** "body.load.mass = 0.49 kg, sensor.angle.offset fitted to this trial only"; null where nothing was different. */
export function setupText(setups: TrialSetup[], comparison: number, trial: string): string | null {
  const found = setups.find((one) => one.comparison === comparison && one.trial === trial);
  if (!found) return null;
  const own = found.own === null ? [] : found.own.split(', ').map((address) => `${address} fitted to this trial only`);
  return [...(found.settings === null ? [] : [found.settings]), ...own].join(', ') || found.setup;
}

/** One channel of a trial as drawn. */
export interface ChannelCurves {
  name: string;
  unit: string;
  measured: Series;
  predicted: Series | null;
  residual: Series | null;
  floor: number | null;
}

/** A command; its samples have times of their own. */
export interface CommandCurves {
  name: string;
  unit: string;
  series: Series;
}

export interface TrialCurves {
  times: Float64Array;
  channels: ChannelCurves[];
  commands: { times: Float64Array; channels: CommandCurves[] } | null;
}

const kTraces = `SELECT trace.kind, trace.id FROM trace
  JOIN trial ON trial.id = trace.trial
  JOIN comparison_score AS score ON score.trial = trial.id AND score.comparison = ?1
  WHERE trial.name = ?2 AND (trace.comparison = ?1 OR trace.comparison IS NULL AND trace.model IS NULL)
    AND trace.kind IN ('measured', 'predicted', 'commands') AND trace.sample_count > 0
  GROUP BY trace.id ORDER BY trace.id`;

/** By kind; "measured", "predicted" and "commands" where they are known. */
export const tracesOf = (source: Source, comparison: number, trial: string) =>
  loadTraces(source, kTraces, [comparison, trial]);

function channelCurves(
  channel: Channel,
  values: Float64Array,
  predicted: Float64Array | null,
  floor: number | null,
): ChannelCurves {
  return {
    ...channel,
    measured: new Series(values),
    predicted: predicted && new Series(predicted),
    residual: predicted && new Series(values.map((value, i) => value - predicted[i])),
    floor,
  };
}

/** Measured beside predicted, with the commands. */
export function curvesOf(
  traces: Map<string, Trace>,
  floorOf: (channel: string) => number | null = () => null,
): TrialCurves | null {
  const measured = traces.get('measured'),
    predicted = traces.get('predicted'),
    commands = traces.get('commands');
  if (!measured) return null;
  return {
    times: measured.times,
    channels: measured.channels.map((channel, c) => {
      const p = predicted?.channels.findIndex((one) => one.name === channel.name) ?? -1;
      return channelCurves(channel, measured.values[c], p >= 0 ? predicted!.values[p] : null, floorOf(channel.name));
    }),
    commands: commands
      ? {
          times: commands.times,
          channels: commands.channels.map((channel, c) => ({ ...channel, series: new Series(commands.values[c]) })),
        }
      : null,
  };
}

export async function loadCurves(
  source: Source,
  comparison: number,
  trial: string,
  scores: Score[],
): Promise<TrialCurves | null> {
  return curvesOf(
    await tracesOf(source, comparison, trial),
    (channel) => scores.find((one) => one.channel === channel)?.floor ?? null,
  );
}

/** What `lacuna compare` found about where the model fails; see schema/database.md, `where_it_fails`. */
export interface Finding {
  kind: string;
  share: number;
  sentence: string;
  view: string;
  channel?: string;
  trial?: string;
  /** Trial, from, to (s): the stretches that it speaks of. */
  stretches?: { trial: string; spans: [number, number][] }[];
}

export interface Where {
  findings: Finding[];
  where: WhereDocument | null;
}

/** Of a comparison of a fitted model: the one that is shown or, where that was not asked where it fails, the latest of
 *  the same revision that was. */
export async function loadWhere(source: Source, experiment: string, revision: number, shown = -1): Promise<Where> {
  const rows = objects<{ document: string }>(
    await source.query(
      `SELECT document FROM where_it_fails
    JOIN comparison ON comparison.id = where_it_fails.comparison JOIN revision ON revision.id = comparison.revision
    JOIN experiment ON experiment.id = revision.experiment
    WHERE experiment.name = ? AND revision.number = ? AND comparison.kind = 'refitted'
    ORDER BY comparison.id = ? DESC, comparison.id DESC LIMIT 1`,
      [experiment, revision, shown],
    ),
  );
  return rows.length === 0 ? { findings: [], where: null } : (JSON.parse(rows[0].document) as Where);
}

const percent = (share: number) => `${Math.round(100 * share)} %`;

/** What can be pointed at: findings, then the regimes of error that are no finding of their own. */
export function pointed({ findings, where }: Where): Finding[] {
  const regimes = (where?.views ?? []).flatMap((view) =>
    view.regimes
      .filter(
        (one) =>
          one.share_of_error > 0.05 &&
          !(one.times_floor <= 1) &&
          one.share_of_samples < 0.99 &&
          one.stretches &&
          !findings.some((finding) => finding.sentence.endsWith(one.sentence)),
      )
      .map((one): Finding => ({
        kind: 'regime',
        view: view.view,
        share: one.share_of_error,
        stretches: one.stretches,
        sentence: `${percent(one.share_of_error)} of the squared ${view.view === 'acceleration' ? 'residual acceleration' : 'error'} is in ${percent(one.share_of_samples)} of the samples (${times(one.times_floor)} the floor): ${one.sentence}`,
      })),
  );
  return [...findings, ...regimes];
}

/** A regime of a view, which can be pointed at like a finding. */
export interface RegimeRow extends Finding {
  key: string;
  share_of_samples: number;
  times_floor: number;
}

/** All regimes of all views. */
export function regimesOf({ where }: Where): RegimeRow[] {
  return (where?.views ?? []).flatMap((view) =>
    view.regimes.map((one, i): RegimeRow => ({
      ...one,
      kind: 'regime',
      key: `${view.view}.${i}`,
      view: view.view,
      share: one.share_of_error,
    })),
  );
}

export interface Bin {
  from: number;
  to: number;
  feature: number;
  mean: number;
  band99: number;
  samples: number;
}

export interface FeatureTest {
  name: string;
  of: string;
  unit: string;
  testable: boolean;
  share: number;
  p: number;
  depends: boolean;
  bins: Bin[];
}

export interface WhereDocument {
  samples: number;
  views: {
    view: string;
    times_floor: number;
    channels: {
      channel: string;
      unit: string;
      share_of_error: number;
      independence: FeatureTest[];
      selected: { feature: string; share: number; p: number }[];
    }[];
    regimes: Regime[];
  }[];
}

export interface Regime {
  sentence: string;
  share_of_error: number;
  share_of_samples: number;
  times_floor: number;
  stretches?: Finding['stretches'];
}
