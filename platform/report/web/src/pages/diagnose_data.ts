export interface Parameter {
  value: number | null;
  ci95: [number | null, number | null];
  unit: string;
}

export interface Effect {
  effect: string;
  where: string;
  parameters: Record<string, Parameter>;
}

export interface Gain {
  value: number | null;
  ci95: [number | null, number | null];
}

export interface Ranked {
  effects: Effect[];
  class: string[];
  cv_rmse: Record<string, number>;
  ratio_to_floor: number | null;
  gain: number | null;
  gain_ci95: [number | null, number | null];
  probability: number | null;
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
}

/** What `lacuna diagnose --json` writes, as far as it is shown. */
export interface DiagnosisDocument {
  verdict: 'nothing_missing' | 'effect_found' | 'not_in_library' | 'cannot_tell';
  probability: number | null;
  calibrated: boolean;
  units: Record<string, string>;
  noise_floor: Record<string, number>;
  base: { cv_rmse: Record<string, number>; ratio_to_floor: number | null };
  ranking: Ranked[];
  p_by_chance: number | null;
  chance_95: number | null;
  free_force: { p: number | null; gain: Gain };
  formulas: {
    joint: string;
    text: string;
    unit: string;
    gain: Gain;
    terms: { text: string; coefficient: number; standard_error: number; unit: string }[];
  }[];
  formulas_of_rest: boolean;
  residual_force: ForceCurve[];
  hypotheses: number;
  findings: string[];
  next_test: string;
  next_test_worth: string;
  not_testable: { effect: string; where: string; reason: string }[];
}

export interface DiagnosisRow {
  id: number;
  experiment: string;
  revision: number;
  document: string;
}

export const effectName = (effect: Effect) => `${effect.effect} @ ${effect.where}`;
export const modelName = (model: Ranked) => model.effects.map(effectName).join(' + ');

/** The verdict in one sentence. */
export function verdictSentence(document: DiagnosisDocument): string {
  const best = document.ranking[0];
  switch (document.verdict) {
    case 'nothing_missing':
      return 'Nothing is missing: no effect of the library predicts what was left out better than the model alone.';
    case 'effect_found':
      return `The model lacks ${best ? modelName(best) : 'an effect'}.`;
    case 'not_in_library':
      return `The model lacks something that no effect of the library explains${document.formulas[0] ? `; a force like ${document.formulas[0].text} would` : ''}.`;
    default:
      return 'These data do not tell whether something is missing.';
  }
}

/** With nothing where a document of another version has nothing. */
export function readDocument(text: string): DiagnosisDocument {
  const empty: DiagnosisDocument = {
    verdict: 'cannot_tell',
    probability: null,
    calibrated: false,
    units: {},
    noise_floor: {},
    base: { cv_rmse: {}, ratio_to_floor: null },
    ranking: [],
    p_by_chance: null,
    chance_95: null,
    free_force: { p: null, gain: { value: null, ci95: [null, null] } },
    formulas: [],
    formulas_of_rest: false,
    residual_force: [],
    hypotheses: 0,
    findings: [],
    next_test: '',
    next_test_worth: '',
    not_testable: [],
  };
  return { ...empty, ...(JSON.parse(text) as Partial<DiagnosisDocument>) };
}
