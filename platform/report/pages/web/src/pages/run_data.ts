export interface Run {
  run: number;
  experiment: string;
  replicate: number;
  ending: string;
  passes_done: number;
  passes: number;
  best_score: number | null;
  metric: string;
  fitness: string | null;
  models: number;
  tests: number;
  trials: number;
  evaluations: number;
  steps: number;
  seconds: number | null;
  seed: number;
  /** UTC; null: not ended. */
  started: string;
  ended: string | null;
  /** Of tests, in the passes that have ended. */
  test_evaluations: number;
  /** A report has a selection of the models and tests only. */
  selected: number;
}

export interface PassRow {
  run: number;
  pass: number;
  trials: number;
  error: number | null;
  best_model: number | null;
  evaluations_so_far: number;
  steps_so_far: number;
}

/** Counts are those of the database, also where a report has a selection. */
export const kRunColumns = `eea_runs.run, experiment, replicate, ending, passes_done, passes, best_score, metric,
  coalesce(page_run.models, eea_runs.models) AS models, coalesce(page_run.tests, eea_runs.tests) AS tests, trials,
  evaluations, steps, seconds, seed`;
export const kRunsFrom = 'FROM eea_runs LEFT JOIN page_run ON page_run.run = eea_runs.run';
export const kRuns = `SELECT ${kRunColumns}, fitness, page_run.run IS NOT NULL AS selected,
  (SELECT started FROM run WHERE number = eea_runs.run) AS started,
  (SELECT ended FROM run WHERE number = eea_runs.run) AS ended,
  (SELECT coalesce(sum(test_evaluations), 0) FROM pass WHERE pass.run = eea_runs.run AND pass.ended) AS test_evaluations
  ${kRunsFrom} ORDER BY eea_runs.run`;

export const passAxis = { label: 'pass', unit: '1', whole: true };

export interface Band {
  x: number[];
  mean: number[];
  lower: number[];
  upper: number[];
  /** How many values each mean is of. */
  counts: number[];
}

/** Mean over replicates by pass, with the 95 % interval of the mean (Student's t), cut at 0 where no value is negative. */
export function meanBand(rows: { pass: number; value: number | null }[]): Band {
  const least = rows.some((one) => one.value !== null && one.value < 0) ? -Infinity : 0;
  const byPass = new Map<number, number[]>();
  for (const { pass, value } of rows) if (value !== null) byPass.set(pass, [...(byPass.get(pass) ?? []), value]);
  const band: Band = { x: [], mean: [], lower: [], upper: [], counts: [] };
  for (const pass of [...byPass.keys()].sort((a, b) => a - b)) {
    const values = byPass.get(pass)!;
    const mean = values.reduce((sum, one) => sum + one, 0) / values.length;
    const variance = values.reduce((sum, one) => sum + (one - mean) ** 2, 0) / Math.max(values.length - 1, 1);
    const half = values.length > 1 ? studentT(values.length - 1) * Math.sqrt(variance / values.length) : NaN;
    band.x.push(pass);
    band.mean.push(mean);
    band.lower.push(Math.max(mean - half, least));
    band.upper.push(mean + half);
    band.counts.push(values.length);
  }
  return band;
}

/** The 97.5 % quantile for so many degrees of freedom; within 0.3 % (an expansion about the normal one). */
export function studentT(freedom: number): number {
  const small = [12.706, 4.303, 3.182, 2.776, 2.571];
  if (freedom <= small.length) return small[freedom - 1];
  const z = 1.959964;
  return z + (z ** 3 + z) / (4 * freedom) + (5 * z ** 5 + 16 * z ** 3 + 3 * z) / (96 * freedom ** 2);
}

/** How long a run will still take: in pass n a model costs n trials and a test one, as the command's own display has it;
 *  how far the pass under way is tell the models and tests that those before it had. Null before one has ended. */
export function secondsLeft(run: Run): number | null {
  if (run.ending !== 'not ended' || run.passes_done === 0 || run.seconds === null) return null;
  const done = run.passes_done;
  const testWork = run.test_evaluations > 0 ? 1 : 0;
  const work = (passes: number) => (passes * (passes + 1)) / 2 + testWork * passes;
  const share = (rows: number, before: number) => Math.min(Math.max(((rows - before) / before) * done || 0, 0), 1);
  const underWay = (done + 1) * share(run.models, run.evaluations) + testWork * share(run.tests, run.test_evaluations);
  return run.seconds * Math.max(work(run.passes) / (work(done) + underWay) - 1, 0);
}

/** The last path element of an address, as a kind of value: "mass" of "body.torso.mass". */
export const kindOf = (address: string) => /\.(\w+)$/.exec(address)?.[1] ?? address;

export interface Spread {
  pass: number;
  lower: number;
  middle: number;
  upper: number;
}

const quantile = (sorted: number[], share: number) => sorted[Math.round(share * (sorted.length - 1))];

/** How far the models of the last generation of each pass agree about each free value, where a gene is a value: the
 *  tenths at the ends and the median, by address. */
export function spreadOf(rows: { pass: number; genome: Uint8Array }[], addresses: string[]): Map<string, Spread[]> {
  const models = rows.map(({ pass, genome }) => ({ pass, genes: new Float64Array(genome.slice().buffer) }));
  const passes = [...new Set(rows.map((one) => one.pass))];
  return new Map(
    addresses.map((address, gene) => [
      address,
      passes.map((pass) => {
        const values = models
          .filter((one) => one.pass === pass)
          .map((one) => one.genes[gene])
          .sort((a, b) => a - b);
        return { pass, lower: quantile(values, 0.1), middle: quantile(values, 0.5), upper: quantile(values, 0.9) };
      }),
    ]),
  );
}
