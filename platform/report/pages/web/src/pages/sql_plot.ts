import type { Cell, Table } from '../data/source';

export interface Column {
  name: string;
  i: number;
  /** Few whole numbers, as of passes. */
  isWhole: boolean;
}

export interface Axes {
  x: Column;
  y: Column;
  kind: 'points' | 'line';
}

// Columns for the x axis and for the y axis if a table has several columns of numbers.
const kOver = ['time', 't', 'sample', 'pass', 'revision', 'generation', 'trial', 'evaluations_so_far'];
const kFound = ['times_floor', 'residual', 'error', 'value', 'score', 'gain', 'held_out_rmse', 'fit_rmse', 'rmse'];
const kFewPoints = 20;

export function numericColumns({ columns, rows }: Table): Column[] {
  const isNumeric = (column: number) =>
    rows.some((row) => typeof row[column] === 'number') &&
    rows.every((row) => row[column] === null || typeof row[column] === 'number');
  const isWhole = (column: number) => {
    const values = rows.map((row) => row[column]);
    return values.every((one) => Number.isInteger(one)) && new Set(values).size <= kFewPoints;
  };
  return columns.map((name, i) => ({ name, i, isWhole: isWhole(i) })).filter(({ i }) => isNumeric(i));
}

const isConstant = (rows: Cell[][], { i }: Column) => rows.every((row) => row[i] === rows[0][i]);

const isIncreasing = (rows: Cell[][], { i }: Column) =>
  rows.every((row, k) => k === 0 || (row[i] ?? NaN) > (rows[k - 1][i] ?? NaN));

/** The axes that the reader chose or, where nothing was chosen, those that show most: no column that is the same in every
 *  row, what was found over what it was found for. Null: there is nothing to plot. */
export function axesOf(table: Table, choices: Record<string, string>): Axes | null {
  const numeric = numericColumns(table);
  const telling = numeric.filter((one) => !isConstant(table.rows, one));
  if (numeric.length < 2 || telling.length === 0) return null;
  const named = (name: string | undefined) => numeric.find((one) => one.name === name);
  const best = (names: string[], among: Column[]) =>
    names.map((name) => among.find((one) => one.name === name)).find((one) => one !== undefined);
  const x = named(choices.x) ?? best(kOver, telling) ?? telling[0];
  const others = (among: Column[]) => among.filter((one) => one !== x);
  const y = named(choices.y) ?? best(kFound, others(telling)) ?? others(telling).at(-1) ?? others(numeric).at(-1) ?? x;
  const isLine = choices.as ? choices.as === 'line' : table.rows.length > kFewPoints && isIncreasing(table.rows, x);
  return { x, y, kind: isLine ? 'line' : 'points' };
}
