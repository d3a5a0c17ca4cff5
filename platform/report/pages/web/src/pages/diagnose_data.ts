import { forceWord } from '../kit/format';

export interface Parameter {
  value: number | null;
  ci95: [number | null, number | null];
  unit: string;
  stated?: number; // by the robot file, of a value that is wrong there
  at_bound?: boolean;
}

export interface Effect {
  effect: string;
  where: string;
  parameters: Record<string, Parameter>;
  held?: Record<string, { value: number; unit: string }>;
}

export interface Gain {
  value: number | null;
  standard_error: number | null;
  ci95: [number | null, number | null];
}

/** In multiples of the noise floor: on what was left out, or, where errors over horizons decided, on what was fitted. */
export interface RatioToFloor {
  ratio_to_floor?: number | null;
  fitted_ratio_to_floor?: number | null;
}

export interface Ranked extends RatioToFloor {
  effects: Effect[];
  class: string[];
  segment_s: number | null;
  gain: number | null;
  gain_standard_error: number | null;
  gain_ci95: [number | null, number | null];
}

/** RMS errors of predictions of one channel over one horizon; nothing where a value is not known. */
export interface HorizonError {
  horizon_s: number;
  channel: string;
  unit: string;
  floor: number | null;
  base: number | null;
  answer: number | null;
  base_held_out: number | null;
  answer_held_out: number | null;
}

/** A force that the residual shows, over one feature. */
export interface ForceCurve {
  joint: string;
  of: string;
  unit: string;
  force_unit: string;
  at: number[];
  force: number[];
  standard_error: number[];
  position?: number;
  /** What the answer makes of it, at the same places. */
  by_answer?: number[];
}

/** What `lacuna diagnose --json` writes, as far as it is shown. */
export interface DiagnosisDocument {
  verdict: 'nothing_missing' | 'effect_found' | 'not_in_library' | 'cannot_tell';
  probability: number | null;
  calibrated: boolean;
  /** Where the time limit stopped the search. */
  stopped?: { during: string; not_examined: string[]; next: string };
  units: Record<string, string>;
  noise_floor: Record<string, number>;
  /** What decided; none where nothing was searched. */
  method?: 'prediction' | 'horizon' | 'likelihood';
  base: RatioToFloor;
  /** `gain` is how much lower the mean log error is, but by likelihood, where there are none. */
  horizons: HorizonError[];
  ranking: Ranked[];
  p_by_chance: number | null;
  chance_95: number | null;
  free_force: { p: number | null; gain: Gain };
  /** Of the answer, in the noise of `free_force.gain`. */
  answer_gain: Gain;
  formulas: {
    joint: string;
    text: string;
    unit: string;
    gain: Gain;
    terms: { text: string; coefficient: number; standard_error: number; unit: string }[];
  }[];
  formulas_of_rest: boolean;
  /** Of the model as it is, with what the answer makes of it. */
  missing_force: ForceCurve[];
  residual_force: ForceCurve[];
  hypotheses: number;
  /** Names of the only effects that were tried (`--among`); none: all. */
  effect_filter: string[];
  evidence: Record<string, number>;
  findings: string[];
  next_test: string;
  next_test_worth: string;
  /** None in documents of before, and where no recording has a setup. */
  next_test_setup?: { name: string } | null;
  not_testable: { effect: string; where: string; reason: string; failed?: boolean }[];
}

export interface DiagnosisRow {
  id: number;
  experiment: string;
  revision: number;
  document: string;
}

/** Of diagnoses by likelihood. */
const kMostOfIt = 0.95;

/** Of all that is to be gained; 0 where no effect was found. */
function shareOfAnswer({ ranking, answer_gain, free_force }: DiagnosisDocument): number {
  if (!ranking[0]?.effects.length) return 0;
  const answer = Math.max(0, answer_gain.value ?? 0);
  const all = answer + Math.max(0, free_force.gain.value ?? 0);
  return all > 0 ? answer / all : 0;
}

/** Whether the first candidate is the answer, with or without something left over: not where only noise was found, and
 *  not where a force of another form gains more. */
export function firstIsAnswer(document: DiagnosisDocument): boolean {
  if (document.verdict !== 'not_in_library' || document.method === 'prediction')
    return document.verdict === 'effect_found';
  const share = shareOfAnswer(document);
  if (share >= kMostOfIt || document.formulas.length === 0) return share >= kMostOfIt;
  const answer = document.formulas_of_rest ? document.answer_gain.value : document.ranking[0]?.gain;
  return share > 0 && (answer ?? 0) > (document.formulas[0].gain.value ?? 0);
}

/** Change of the error in per cent for a lower mean logarithm, as in −91.3. */
export const errorChange = (gain: number | null) => (gain === null ? null : 100 * Math.expm1(-gain));

/** "−91.3 % [−93.7, −88.0]", as the terminal has it. */
export function errorChangeText({ gain, gain_ci95: [lower, upper] }: Pick<Ranked, 'gain' | 'gain_ci95'>): string {
  const number = (one: number | null) => {
    const text = (errorChange(one) ?? 0).toFixed(1);
    return one === null ? '—' : `${Number(text) > 0 ? '+' : ''}${text.replace('-', '−')}`;
  };
  return gain === null ? '—' : `${number(gain)} % [${number(upper)}, ${number(lower)}]`;
}

/** "+7397 ± 2858". */
/** As the terminal has it: with 1.96 standard errors. */
export function gainText({ value, standard_error }: Pick<Gain, 'value' | 'standard_error'>): string {
  if (value === null) return '—';
  const sign = value > 0 ? '+' : '';
  const half = Number.isFinite(standard_error) ? 1.96 * (standard_error ?? 0) : null;
  const digits = Math.max(Math.abs(value), half ?? 0) < 10 ? 1 : 0;
  const number = (one: number) => one.toFixed(digits).replace('-', '−');
  return `${sign}${number(value)}${half === null ? '' : ` ± ${number(half)}`}`;
}

export const timesFloor = (one: RatioToFloor) => one.ratio_to_floor ?? one.fitted_ratio_to_floor ?? null;

export const effectName = (effect: Effect) => `${effect.effect} @ ${effect.where}`;
export const modelName = (model: Ranked) => model.effects.map(effectName).join(' + ');

const valuesOf = (best: Ranked) =>
  best.effects.filter((one) => one.effect === 'wrong_value').map((one) => one.where);
const effectsOf = (best: Ranked) => best.effects.filter((one) => one.effect !== 'wrong_value').map(effectName);

/** Effects that are missing, and fixed values of the robot file that are wrong. */
function foundSentence(best: Ranked): string {
  const values = valuesOf(best),
    effects = effectsOf(best);
  const sentences = [];
  if (effects.length > 0) sentences.push(`The model is missing ${effects.join(' + ')}.`);
  if (values.length > 0) sentences.push(`The robot file has a wrong value: ${values.join(', ')}.`);
  return sentences.join(' ');
}

/** Says that only some effects were tried; empty where all were. */
export function filterSentence({ effect_filter: names, hypotheses }: DiagnosisDocument): string {
  if (names.length === 0) return '';
  const tried = `${hypotheses} ${hypotheses === 1 ? 'candidate was' : 'candidates were'} tried`;
  return `Only ${tried} (--among ${names.join(' ')}). To try all effects, run lacuna diagnose without --among.`;
}

/** The verdict in one sentence. */
export function verdictSentence(document: DiagnosisDocument): string {
  const best = document.ranking[0],
    formula = document.formulas?.[0];
  const isFiltered = document.effect_filter.length > 0;
  const none = isFiltered ? 'none of the effects that were tried' : 'no effect of the library';
  switch (document.verdict) {
    case 'nothing_missing':
      return `${isFiltered ? 'No missing effect was found' : 'Nothing is missing'}: ${none} lowers the cross-validated error.`;
    case 'effect_found':
      return best ? foundSentence(best) : 'An effect is missing.';
    case 'not_in_library':
      return `Something is missing that ${none} explains${formula ? `; the ${forceWord(formula.unit)} ${formula.text} explains it` : ''}.`;
    default:
      return 'These data cannot show whether something is missing.';
  }
}

/** The verdict on a revision that is not the newest one. */
export function verdictOfRevision(document: DiagnosisDocument, revision: number): string {
  const best = document.ranking[0];
  if (document.verdict !== 'effect_found' || !best) return `Diagnosis of revision ${revision}: ${verdictSentence(document)}`;
  const lacked = [...effectsOf(best), ...valuesOf(best).map((one) => `a correct value of ${one}`)];
  return `Revision ${revision} lacked ${lacked.join(' + ')}.`;
}

/** Whether the gains are over all horizons, because the three shortest ones showed nothing. */
export const isByAllHorizons = (document: DiagnosisDocument) => (document.evidence.all_lengths ?? 0) > 0;

/** With nothing where a document of another version has nothing, but for the answer's gain: it was that of the ranking. */
export function readDocument(text: string): DiagnosisDocument {
  const empty: DiagnosisDocument = {
    verdict: 'cannot_tell',
    probability: null,
    calibrated: false,
    units: {},
    noise_floor: {},
    base: {},
    horizons: [],
    ranking: [],
    p_by_chance: null,
    chance_95: null,
    free_force: { p: null, gain: { value: null, standard_error: null, ci95: [null, null] } },
    answer_gain: { value: null, standard_error: null, ci95: [null, null] },
    formulas: [],
    formulas_of_rest: false,
    missing_force: [],
    residual_force: [],
    hypotheses: 0,
    effect_filter: [],
    evidence: {},
    findings: [],
    next_test: '',
    next_test_worth: '',
    not_testable: [],
  };
  const known = JSON.parse(text) as Partial<DiagnosisDocument>;
  const first = known.ranking?.[0];
  if (known.method === undefined && known.horizons?.length) known.method = 'horizon'; // of another version, too
  if (first && known.method === undefined)
    empty.answer_gain = { value: first.gain, standard_error: first.gain_standard_error, ci95: first.gain_ci95 };
  return { ...empty, ...known };
}
