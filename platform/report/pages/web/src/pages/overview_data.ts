import { objects, type Source } from '../data/source';
import { times } from '../kit/format';
import { shellWord } from '../kit/shell';
import { filterSentence, firstIsAnswer, readDocument, type DiagnosisDocument } from './diagnose_data';
import { kRuns, type Run } from './run_data';

export interface RevisionRow {
  experiment: string;
  number: number;
  change: string;
}

export interface ErrorRow {
  experiment: string;
  revision: number;
  channel: string;
  unit: string;
  fit_rmse: number | null;
  held_out_rmse: number | null;
  times_floor: number | null;
}

/** What follows from the last comparison of a revision (`where_it_fails.document`, `advice`). */
export interface Advice {
  experiment: string;
  revision: number;
  result: string;
  /** What to do, or a command to type; empty where nothing follows. */
  next: string;
  /** Whether noise and the initial-state uncertainty explain the error of all trials. */
  is_explained: number;
}

/** What a database has of an experiment. */
export interface Overview {
  name: string;
  /** To type in a command. */
  file: string;
  revisions: RevisionRow[];
  errors: ErrorRow[];
  advice: Advice[];
  /** The newest one. */
  diagnosis: { id: number; revision: number; document: DiagnosisDocument } | null;
  runs: Run[];
}

const kExperiments = `SELECT experiment.name, max(run.number) AS last_run,
    (SELECT file FROM experiment_text WHERE experiment_text.experiment = experiment.id ORDER BY id DESC LIMIT 1) AS file
  FROM experiment LEFT JOIN experiment_text ON experiment_text.experiment = experiment.id
  LEFT JOIN run ON run.experiment_text = experiment_text.id
  GROUP BY experiment.id ORDER BY last_run DESC, experiment.id DESC`;
const kDiagnoses = `SELECT max(diagnosis.id) AS id, experiment.name AS experiment, revision.number AS revision, document
  FROM diagnosis JOIN revision ON revision.id = diagnosis.revision JOIN experiment ON experiment.id = revision.experiment
  GROUP BY experiment.id`;

// Of the last comparison of each revision that asked where the model fails; databases of before have none.
const kAdvice = `SELECT experiment.name AS experiment, revision.number AS revision,
    json_extract(document, '$.advice.result') AS result, json_extract(document, '$.advice.next') AS next,
    json_extract(document, '$.advice.is_explained') AS is_explained
  FROM where_it_fails JOIN comparison ON comparison.id = where_it_fails.comparison
  JOIN revision ON revision.id = comparison.revision JOIN experiment ON experiment.id = revision.experiment
  WHERE json_extract(document, '$.advice') IS NOT NULL AND comparison.kind = 'refitted' AND comparison.id IN (
    SELECT max(comparison.id) FROM where_it_fails JOIN comparison ON comparison.id = where_it_fails.comparison
    WHERE comparison.kind = 'refitted' GROUP BY comparison.revision)`;

/** All experiments, those that a command worked on last first. */
export async function loadOverview(source: Source): Promise<Overview[]> {
  const rows = async <Row>(sql: string) => objects<Row>(await source.query(sql));
  const [experiments, revisions, errors, advice, diagnoses, runs] = await Promise.all([
    rows<{ name: string; file: string | null }>(kExperiments),
    rows<RevisionRow>('SELECT experiment, number, change FROM revisions ORDER BY experiment, number'),
    rows<ErrorRow>('SELECT * FROM error_by_revision ORDER BY experiment, revision, channel'),
    rows<Advice>(kAdvice),
    rows<{ id: number; experiment: string; revision: number; document: string }>(kDiagnoses),
    rows<Run>(kRuns),
  ]);
  return experiments.map(({ name, file }) => {
    const own = <Row extends { experiment: string }>(all: Row[]) => all.filter((one) => one.experiment === name);
    const [diagnosis] = own(diagnoses);
    return {
      name,
      file: (file ?? 'FILE').replace(/^.*\//, ''),
      revisions: own(revisions),
      errors: own(errors),
      advice: own(advice),
      diagnosis: diagnosis ? { ...diagnosis, document: readDocument(diagnosis.document) } : null,
      runs: own(runs),
    };
  });
}

export interface Step {
  sentence: string;
  command?: string;
}

const kAtTheFloor = 1.2; // as report/text/advice_text.cpp has it

/** Where nothing is missing on the fit files, the channel whose held-out error is farthest above the floor; else null. */
export function heldOutAbove(errors: ErrorRow[]): ErrorRow | null {
  // `times_floor` is that of the held-out files where there are some.
  const above = errors.filter((one) => one.held_out_rmse !== null && (one.times_floor ?? 0) > kAtTheFloor);
  return above.length === 0 ? null : above.reduce((a, b) => (b.times_floor! > a.times_floor! ? b : a));
}

const heldOutStep = (one: ErrorRow, file: string): Step => ({
  sentence: `Nothing is missing on the fit files, but the held-out error of ${one.channel} is ${times(one.times_floor)} the noise floor. Possible causes: (1) the initial state is uncertain; (2) this motion excites an effect that the fit files do not excite; (3) the rig or its load was different in this recording. The last line of lacuna compare says whether (1) explains the error.`,
  command: `lacuna compare ${file}`,
});

function stepAfterDiagnosis(document: DiagnosisDocument, errors: ErrorRow[], isExplained: boolean, file: string): Step {
  const answer = document.ranking[0]?.effects ?? [];
  if (document.stopped)
    return {
      sentence: 'The time limit stopped the search. To continue, repeat the command.',
      command: `lacuna diagnose ${file}`,
    };
  const heldOut = isExplained ? null : heldOutAbove(errors);
  if (document.verdict === 'nothing_missing' && document.effect_filter.length > 0)
    return { sentence: filterSentence(document), command: `lacuna diagnose ${file}` };
  if (document.verdict === 'nothing_missing')
    return heldOut ? heldOutStep(heldOut, file) : { sentence: 'Nothing to add: the loop ends here.' };
  const misread = document.findings.find((one) => one.includes('; check counts per turn'));
  if (misread) return { sentence: `Correct the readings first: ${misread}.`, command: `lacuna check ${file}` };
  if (firstIsAnswer(document) && answer.length > 0)
    return {
      sentence: answer.length > 1 ? 'Add the effects that were found.' : 'Add the effect that was found.',
      command:
        answer.length > 1
          ? `lacuna add ${file} --answer`
          : `lacuna add ${file} ${shellWord(answer[0].effect)}${answer[0].where === 'world' ? '' : ` --where ${shellWord(answer[0].where)}`}`,
    };
  if (document.verdict === 'not_in_library' && document.formulas.length > 0)
    return {
      sentence: 'Make an effect from the formula that was found.',
      command: `lacuna plugins new effect NAME --formula ${shellWord(document.formulas[0].text)}`,
    };
  if (document.next_test !== '') {
    const setup = document.next_test_setup ? ` --setup ${shellWord(document.next_test_setup.name || 'none')}` : '';
    return {
      sentence: 'Record this test next: it separates the candidates.',
      command: `lacuna trial ${file} --test ${shellWord(document.next_test)}${setup} --csv=next.csv`,
    };
  }
  return { sentence: document.findings[0] ?? 'The page Compare shows where the error is large.' };
}

/** The channel that is farthest above its floor; null where a floor is not known. */
export function farthest(errors: ErrorRow[]): ErrorRow | null {
  if (errors.length === 0 || errors.some((one) => one.times_floor === null)) return null;
  return errors.reduce((a, b) => (b.times_floor! > a.times_floor! ? b : a));
}

/** Of a revision that is compared and not diagnosed. */
function stepAfterComparison({ revision, result, next }: Advice, isDiagnosedBefore: boolean, file: string): Step {
  if (/^lacuna /.test(next)) return { sentence: `Find the missing effect. ${result}`, command: next };
  if (next !== '') return { sentence: `${capital(next)}. ${result}` };
  return isDiagnosedBefore
    ? { sentence: `Confirm with a diagnosis of revision ${revision}. ${result}.`, command: `lacuna diagnose ${file}` }
    : { sentence: `Nothing to do. ${result}.` };
}

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

function stepOfModel({ revisions, errors, advice, diagnosis, file }: Overview): Step {
  const newest = revisions[revisions.length - 1].number;
  const word = shellWord(file);
  const own = errors.filter((one) => one.revision === newest);
  const compared = advice.find((one) => one.revision === newest);
  if (diagnosis?.revision === newest)
    return stepAfterDiagnosis(diagnosis.document, own, Boolean(compared?.is_explained), word);
  if (own.length === 0)
    return { sentence: `Revision ${newest} has not been compared with the trials yet.`, command: `lacuna compare ${word}` };
  const worst = farthest(own);
  if (worst === null)
    return {
      sentence:
        'The noise floor is not known, so a missing effect cannot be seen. Declare the noise of the sensors.',
    };
  if (compared) return stepAfterComparison(compared, diagnosis !== null, word);
  if (worst.times_floor! <= kAtTheFloor)
    return {
      sentence: `The error is ${times(worst.times_floor)} the noise floor: as small as the noise allows.`,
    };
  return {
    sentence: `The error of ${worst.channel} is ${times(worst.times_floor)} the noise floor. The last line of lacuna compare says whether the initial-state uncertainty explains it or an effect is missing.`,
    command: `lacuna compare ${word}`,
  };
}

function stepOfRuns({ runs, file }: Overview): Step {
  const word = shellWord(file);
  const open = runs.find((one) => one.ending !== 'done');
  if (open)
    return {
      sentence: `Run ${open.run} has ${open.passes_done} of ${open.passes} passes. If no process is running it, continue it:`,
      command: `lacuna run ${word} --resume`,
    };
  return {
    sentence: 'Predict a test with the models of the newest run.',
    command: `lacuna predict ${word} --test TEST`,
  };
}

/** What to do next, and why. */
export function nextStep(overview: Overview): Step {
  if (overview.revisions.length > 0) return stepOfModel(overview);
  if (overview.runs.length > 0) return stepOfRuns(overview);
  return {
    sentence: 'No result is stored yet.',
    command: `lacuna compare ${shellWord(overview.file)}`,
  };
}
