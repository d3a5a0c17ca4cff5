import { plain } from '../kit/format';
import { firstIsAnswer, isByAllHorizons, type DiagnosisDocument } from './diagnose_data';

/** Whether candidates are ranked by errors over horizons, and not by likelihoods. */
export const byHorizon = (document: DiagnosisDocument) => document.horizons.length > 0;
export const measureOf = (document: DiagnosisDocument) => (byHorizon(document) ? 'change of error / %' : 'gain / nats');

/** Horizons over which a gain is a mean. */
function decidingHorizons(document: DiagnosisDocument): string {
  if (document.method !== 'prediction') return 'the horizons';
  return isByAllHorizons(document) ? 'all horizons' : 'the three shortest horizons';
}

/** How many candidates were tried, and what chance makes of so many. */
function triedText({ ranking, hypotheses, p_by_chance }: DiagnosisDocument): string {
  const shown = `${hypotheses} candidates were tried, alone and in combinations of up to three; the ${ranking.length === 1 ? 'best is' : `${ranking.length} best are`} shown.`;
  return p_by_chance === null
    ? shown
    : `${shown} Probability that noise alone gives a gain as large as the best one: p = ${plain(p_by_chance, 2)}.`;
}

/** What the gains are, below their picture. */
export function gainNote(document: DiagnosisDocument): string {
  const isFormulaFirst =
    document.verdict === 'not_in_library' && !firstIsAnswer(document) && !document.formulas_of_rest;
  const first = isFormulaFirst && document.formulas.length > 0 ? 'First: the formula below. ' : '';
  if (byHorizon(document))
    return `${first}Change of the cross-validated error against the null model, the model without any added effect (geometric mean over ${decidingHorizons(document)}), with 95 % intervals. Blue: the answer, the candidate that the verdict names. ${triedText(document)}`;
  return `${first}Increase of the log likelihood over the null model, the model without any added effect, with 95 % intervals; 5 nats are odds of 150 to 1. Blue: the answer, the candidate that the verdict names. Dashed: gain that the best of ${document.hypotheses} effects exceeds by noise alone in 5 % of cases (${plain(document.chance_95)} nats). Probability that noise alone gives a gain as large as the best one: p = ${plain(document.p_by_chance, 2)}.`;
}
