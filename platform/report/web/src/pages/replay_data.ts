import { Series } from '../kit/decimate';
import { objects, type Source } from '../data/source';
import { decodeTrace, kTraceColumns, type Trace } from '../data/trace';
import { motionFromReadings, motionOf } from '../robot/motion';
import { SensorKind, type Robot } from '../robot/spec';
import type { Actor } from '../robot/stage';
import { sampleAt } from '../kit/decimate';
import type { ChannelCurves, TrialCurves } from './compare_data';

/** Something that can be played: a trial of a run or of a comparison. */
export interface Piece {
  key: string;
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

const kComparisons = `SELECT DISTINCT experiment, revision, trial, comparison FROM latest_comparison
  WHERE EXISTS (SELECT * FROM trace WHERE trace.comparison = latest_comparison.comparison) ORDER BY comparison DESC, trial`;
const kSimulated = 'SELECT DISTINCT run, trial, experiment FROM page_replay ORDER BY run DESC, trial DESC';
const kTrials = `SELECT target_trial.run, target_trial.number AS trial, experiment.name AS experiment FROM target_trial
  JOIN eea_run ON eea_run.run = target_trial.run JOIN experiment ON experiment.id = eea_run.experiment
  WHERE NOT for_transfer AND target_trial.number < (SELECT count(*) FROM pass WHERE pass.run = eea_run.run AND ended)
  ORDER BY target_trial.run DESC, trial DESC`;

export async function loadPieces(source: Source): Promise<Piece[]> {
  const runs = objects<{ run: number; trial: number; experiment: string }>(await source.query(source.live ? kTrials : kSimulated));
  const compared = objects<{ experiment: string; revision: number; trial: string; comparison: number }>(await source.query(kComparisons));
  return [
    ...runs.map((one) => ({ key: `run ${one.run}/${one.trial}`, label: `${one.experiment} · run ${one.run} · trial ${one.trial}`, run: one.run, trial: one.trial })),
    ...compared.map((one) => ({ key: `comparison ${one.comparison}/${one.trial}`, label: `${one.experiment} · revision ${one.revision} · ${one.trial}`, comparison: one.comparison, trialName: one.trial })),
  ];
}

/** Whether a body's touch sensor reads contact. */
function touchOf(robot: Robot, readings: Trace | undefined): Actor['touching'] {
  const columns = new Map(robot.sensors.filter((one) => one.kind === SensorKind.touch).map((one) =>
    [one.element, readings?.values[readings.channels.findIndex((channel) => channel.name === one.name)]]));
  return (body, time) => {
    const column = columns.get(body);
    return column !== undefined && column[Math.min(sampleAt(readings!.times, time), column.length - 1)] > 0;
  };
}

function curvesOf(measured: Trace, predicted: Trace | undefined): TrialCurves {
  const channels = measured.channels.map((channel, c): ChannelCurves => {
    const p = predicted?.channels.findIndex((one) => one.name === channel.name) ?? -1;
    const values = p >= 0 ? predicted!.values[p] : null;
    return {
      ...channel, measured: new Series(measured.values[c]), predicted: values && new Series(values),
      residual: values && new Series(measured.values[c].map((value, i) => value - values[i])), floor: null,
    };
  });
  return { times: measured.times, channels, commands: [] };
}

async function playRun(source: Source, piece: Piece): Promise<Play> {
  await source.prepareReplay(piece.run!, piece.trial!);
  const [replay] = objects<{ id: number; robot: string; pass: number; model: number; target_robot: string }>(
    await source.query('SELECT id, robot, pass, model, target_robot FROM page_replay WHERE run = ? AND trial = ? ORDER BY pass DESC LIMIT 1', [piece.run!, piece.trial!]));
  if (!replay) throw new Error('the robots of this trial are not in this report');
  const found = await source.query(`SELECT trace.kind, ${kTraceColumns} FROM page_replay_trace AS trace WHERE replay = ?`, [replay.id]);
  const traces = new Map(found.rows.map(([kind, ...rest]) => [kind as string, decodeTrace(rest)]));
  const robot = JSON.parse(replay.robot) as Robot;
  const measured = traces.get('measured')!, predicted = traces.get('predicted');
  const target = traces.get('target');
  const targetRobot = target && (JSON.parse(replay.target_robot) as Robot);
  const model: Actor = { robot, motion: motionOf(traces.get('model')!), colour: 'predicted', opacity: target ? 0.6 : 0.9, touching: touchOf(robot, predicted) };
  return {
    actors: target ? [model, { robot: targetRobot!, motion: motionOf(target), colour: 'measured', opacity: 0.3, touching: touchOf(targetRobot!, measured) }] : [model],
    curves: curvesOf(measured, predicted),
    note: `Model ${replay.model}, the best of pass ${replay.pass}, ${target ? 'over the target (translucent), both simulated again' : 'simulated again'}.`,
  };
}

async function playComparison(source: Source, piece: Piece): Promise<Play> {
  const [row] = objects<{ robot_text: string }>(await source.query(
    'SELECT revision.robot_text FROM comparison JOIN revision ON revision.id = comparison.revision WHERE comparison.id = ?', [piece.comparison!]));
  const found = await source.query(`SELECT trace.kind, ${kTraceColumns} FROM trace JOIN trial ON trial.id = trace.trial
    WHERE trial.name = ?2 AND (trace.comparison = ?1 OR trace.kind = 'measured' AND trace.trial IN (SELECT trial FROM comparison_score WHERE comparison = ?1))`,
    [piece.comparison!, piece.trialName!]);
  const traces = new Map(found.rows.map(([kind, ...rest]) => [kind as string, decodeTrace(rest)]));
  const measured = traces.get('measured'), predicted = traces.get('predicted');
  if (!measured || !predicted) throw new Error('the samples of this trial are not here');
  const robot = JSON.parse(row.robot_text) as Robot;
  const motion = motionFromReadings(robot, predicted);
  if (!motion) return { actors: [], curves: curvesOf(measured, predicted), note: 'Not every joint has a position sensor, so the readings do not tell where the robot is; the curves do.' };
  const seen = motionFromReadings(robot, measured);
  return {
    actors: [
      { robot, motion, colour: 'predicted', opacity: seen ? 0.6 : 0.9 },
      ...(seen ? [{ robot, motion: seen, colour: 'measured' as const, opacity: 0.3 }] : []),
    ],
    curves: curvesOf(measured, predicted),
    note: seen ? 'The model as predicted over the robot as its joints were measured (translucent).' : 'The model as predicted.',
  };
}

export const loadPlay = (source: Source, piece: Piece) => (piece.run !== undefined ? playRun(source, piece) : playComparison(source, piece));
