import { objects, type Source } from '../data/source';
import { decodeTrace, kTraceColumns, type Trace } from '../data/trace';
import { motionFromReadings, motionOf } from '../robot/motion';
import { SensorKind, type Robot } from '../robot/spec';
import type { Actor } from '../robot/stage';
import { sampleAt } from '../kit/decimate';
import { curvesOf, tracesOf, type TrialCurves } from './compare_data';

/** Something that can be played: a trial of a run or of a comparison. */
export interface Piece {
  key: string;
  /** Of the run that wrote it, whatever file it is in. */
  identity: string;
  label: string;
  run?: number;
  trial?: number;
  comparison?: number;
  trialName?: string;
}

export interface Play {
  actors: Actor[];
  curves: TrialCurves;
  note: string;
}

const kComparisons = `SELECT DISTINCT experiment, revision, trial, comparison, run.identity FROM latest_comparison
  JOIN run ON run.number = comparison >> 40
  WHERE EXISTS (SELECT * FROM trace WHERE trace.comparison = latest_comparison.comparison) ORDER BY comparison DESC, trial`;
const kSimulated = `SELECT DISTINCT page_replay.run, page_replay.trial, page_replay.experiment, page_replay.identity,
    target_trial.for_transfer
  FROM page_replay LEFT JOIN target_trial ON target_trial.run = page_replay.run AND target_trial.number = page_replay.trial
  ORDER BY page_replay.run DESC, page_replay.trial DESC`;
// Every trial of the runs that have a model.
const kTrials = `SELECT target_trial.run, target_trial.number AS trial, experiment.name AS experiment, run.identity, for_transfer
  FROM target_trial JOIN eea_run ON eea_run.run = target_trial.run JOIN experiment ON experiment.id = eea_run.experiment
  JOIN run ON run.number = eea_run.run
  WHERE EXISTS (SELECT * FROM pass WHERE pass.run = eea_run.run AND ended AND best_model IS NOT NULL)
  ORDER BY target_trial.run DESC, trial DESC`;

interface OfRun {
  run: number;
  trial: number;
  experiment: string;
  identity: string;
  for_transfer: number | null;
}

interface OfComparison {
  experiment: string;
  revision: number;
  trial: string;
  comparison: number;
  identity: string;
}

export async function loadPieces(source: Source): Promise<Piece[]> {
  const runs = objects<OfRun>(await source.query(source.live ? kTrials : kSimulated));
  const compared = objects<OfComparison>(await source.query(kComparisons));
  return [
    ...runs.map((one) => ({
      key: `run ${one.run}/${one.trial}`,
      identity: one.identity,
      label: `run ${one.run} · trial ${one.trial}${one.for_transfer ? ' (transfer)' : ''} · ${one.experiment}`,
      run: one.run,
      trial: one.trial,
    })),
    ...compared.map((one) => ({
      key: `comparison ${one.comparison}/${one.trial}`,
      identity: one.identity,
      label: `revision ${one.revision} · ${one.trial} · ${one.experiment}`,
      comparison: one.comparison,
      trialName: one.trial,
    })),
  ];
}

/** Why there is nothing to play, and what would make something. */
export async function whyNothing(source: Source): Promise<string> {
  const [{ runs, passes, comparisons }] = objects<{ runs: number; passes: number; comparisons: number }>(
    await source.query(`SELECT EXISTS (SELECT * FROM eea_run) AS runs, EXISTS (SELECT * FROM pass WHERE ended) AS passes,
      EXISTS (SELECT * FROM comparison) AS comparisons`),
  );
  const sentences: string[] = [];
  if (passes && !source.live)
    sentences.push(
      'This report has no robot motion of runs: it was made with --no-robots, or a note above says why.',
    );
  else if (runs) sentences.push('No run has a finished pass yet.');
  if (comparisons)
    sentences.push(`The time series of comparisons are not in this ${source.live ? 'database' : 'report'}.`);
  if (!source.live && (passes || comparisons)) sentences.push('To see everything in the database: lacuna serve.');
  return sentences.join(' ') || 'There is no trial to replay. Make some with lacuna run or lacuna compare.';
}

/** Whether a body touches the ground: as it was simulated, else as its touch sensor reads it. */
function touchOf(robot: Robot, contacts: Trace | undefined, readings: Trace | undefined): Actor['touching'] {
  const trace = contacts ?? readings;
  const watched = contacts
    ? robot.bodies.map((one) => ({ body: one.name, channel: one.name }))
    : robot.sensors
        .filter((one) => one.kind === SensorKind.touch)
        .map((one) => ({ body: one.element, channel: one.name }));
  const columns = new Map(
    watched.map(({ body, channel }) => [body, trace?.values[trace.channels.findIndex((one) => one.name === channel)]]),
  );
  if (![...columns.values()].some((one) => one !== undefined)) return undefined;
  return (body, time) => {
    const column = columns.get(body);
    return column !== undefined && column[Math.min(sampleAt(trace!.times, time), column.length - 1)] > 0;
  };
}

interface ReplayRow {
  robot: string;
  pass: number;
  model: number;
  target_robot: string;
}

async function playRun(source: Source, piece: Piece): Promise<Play> {
  const key = await source.prepareReplay(piece.run!, piece.trial!);
  if (key === null) throw new Error('this report does not contain the robots of this trial');
  const [replay] = objects<ReplayRow>(
    await source.query('SELECT robot, pass, model, target_robot FROM page_replay WHERE id = ?', [key]),
  );
  const found = await source.query(
    `SELECT trace.kind, ${kTraceColumns} FROM page_replay_trace AS trace WHERE replay = ?`,
    [key],
  );
  const traces = new Map(found.rows.map(([kind, ...rest]) => [kind as string, decodeTrace(rest)]));
  const target = traces.get('target');
  const actor = (robot: Robot, motion: Trace, contacts: string, readings: string) => ({
    robot,
    motion: motionOf(motion),
    touching: touchOf(robot, traces.get(contacts), traces.get(readings)),
  });
  const model = actor(JSON.parse(replay.robot) as Robot, traces.get('model')!, 'model contacts', 'predicted');
  return {
    actors: [
      { ...model, colour: 'predicted', opacity: target ? 0.6 : 0.9 },
      ...(target
        ? [
            {
              ...actor(JSON.parse(replay.target_robot) as Robot, target, 'target contacts', 'measured'),
              colour: 'measured' as const,
              opacity: 0.3,
            },
          ]
        : []),
    ],
    curves: curvesOf(traces)!,
    note: `Model ${replay.model}, the best of pass ${replay.pass}${target ? ', and the target (translucent)' : ''}, simulated again.`,
  };
}

async function playComparison(source: Source, piece: Piece): Promise<Play> {
  const [row] = objects<{ robot_text: string }>(
    await source.query(
      'SELECT revision.robot_text FROM comparison JOIN revision ON revision.id = comparison.revision WHERE comparison.id = ?',
      [piece.comparison!],
    ),
  );
  const traces = await tracesOf(source, piece.comparison!, piece.trialName!);
  const measured = traces.get('measured'),
    predicted = traces.get('predicted');
  if (!measured || !predicted) throw new Error('the samples of this trial are not stored here');
  traces.delete('commands');
  const curves = curvesOf(traces)!;
  const robot = JSON.parse(row.robot_text) as Robot;
  const motion = motionFromReadings(robot, predicted);
  if (!motion)
    return {
      actors: [],
      curves,
      note: 'Not every joint has a position sensor, so the measured pose is not known. See the curves instead.',
    };
  const seen = motionFromReadings(robot, measured);
  return {
    actors: [
      { robot, motion, colour: 'predicted', opacity: seen ? 0.6 : 0.9 },
      ...(seen ? [{ robot, motion: seen, colour: 'measured' as const, opacity: 0.3 }] : []),
    ],
    curves,
    note: seen
      ? 'Predicted motion, and the measured motion (translucent).'
      : 'Predicted motion.',
  };
}

export const loadPlay = (source: Source, piece: Piece) =>
  piece.run !== undefined ? playRun(source, piece) : playComparison(source, piece);
