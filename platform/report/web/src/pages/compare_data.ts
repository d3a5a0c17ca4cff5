import { Series } from '../kit/decimate';
import { times } from '../kit/format';
import { objects, type Source } from '../data/source';
import { decodeTrace, kTraceColumns } from '../data/trace';

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

/** One channel of a trial as drawn. */
export interface ChannelCurves {
  name: string;
  unit: string;
  measured: Series;
  predicted: Series | null;
  residual: Series | null;
  floor: number | null;
}

export interface TrialCurves {
  times: Float64Array;
  channels: ChannelCurves[];
  commands: ChannelCurves[];
}

const kTraces = `SELECT trace.kind, ${kTraceColumns} FROM trace
  JOIN trial ON trial.id = trace.trial
  JOIN comparison_score AS score ON score.trial = trial.id AND score.comparison = ?1
  WHERE trial.name = ?2 AND (trace.comparison = ?1 OR trace.comparison IS NULL AND trace.model IS NULL)
    AND trace.kind IN ('measured', 'predicted', 'commands')
  GROUP BY trace.id ORDER BY trace.id`;

const difference = (a: Float64Array, b: Float64Array) => a.map((value, i) => value - b[i]);

export async function loadCurves(source: Source, comparison: number, trial: string, scores: Score[]): Promise<TrialCurves | null> {
  const found = await source.query(kTraces, [comparison, trial]);
  const traces = new Map(found.rows.map(([kind, ...rest]) => [kind as string, decodeTrace(rest)]));
  const measured = traces.get('measured'), predicted = traces.get('predicted'), commands = traces.get('commands');
  if (!measured) return null;
  const channels = measured.channels.map((channel, c): ChannelCurves => {
    const p = predicted?.channels.findIndex((one) => one.name === channel.name) ?? -1;
    const values = p >= 0 ? predicted!.values[p] : null;
    return {
      ...channel,
      measured: new Series(measured.values[c]),
      predicted: values && new Series(values),
      residual: values && new Series(difference(measured.values[c], values)),
      floor: scores.find((one) => one.channel === channel.name)?.floor ?? null,
    };
  });
  const commandCurves = (commands && commands.times.length === measured.times.length ? commands.channels : []).map((channel, c) =>
    ({ ...channel, measured: new Series(commands!.values[c]), predicted: null, residual: null, floor: null }));
  return { times: measured.times, channels, commands: commandCurves };
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

/** Of the latest comparison of a revision that was asked where it fails. */
export async function loadWhere(source: Source, experiment: string, revision: number): Promise<Where> {
  const rows = objects<{ document: string }>(await source.query(`SELECT document FROM where_it_fails
    JOIN comparison ON comparison.id = where_it_fails.comparison JOIN revision ON revision.id = comparison.revision
    JOIN experiment ON experiment.id = revision.experiment
    WHERE experiment.name = ? AND revision.number = ? ORDER BY comparison.id DESC LIMIT 1`, [experiment, revision]));
  return rows.length === 0 ? { findings: [], where: null } : (JSON.parse(rows[0].document) as Where);
}

/** What can be pointed at: findings, then the regimes of error that are no finding of their own. */
export function pointed({ findings, where }: Where): Finding[] {
  const regimes = (where?.views ?? []).flatMap((view) => view.regimes
    .filter((one) => one.share_of_error > 0.05 && one.share_of_samples < 0.99 && one.stretches && !findings.some((finding) => finding.sentence.endsWith(one.sentence)))
    .map((one): Finding => ({
    kind: 'regime', view: view.view, share: one.share_of_error, stretches: one.stretches,
    sentence: `of the ${view.view === 'acceleration' ? 'unexplained acceleration' : 'squared error'} in ${Math.round(100 * one.share_of_samples)} % of the samples, ${times(one.times_floor)} the floor: ${one.sentence}`,
  })));
  return [...findings, ...regimes];
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
    channels: { channel: string; unit: string; share_of_error: number; independence: FeatureTest[]; selected: { feature: string; share: number; p: number }[] }[];
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
