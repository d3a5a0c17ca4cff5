/** What a query may find in a cell; NaN and infinity do not occur, what is not known is null. */
export type Cell = number | string | null | Uint8Array;

export interface Table {
  columns: string[];
  rows: Cell[][];
  /** There was more than was asked for. */
  cut: boolean;
}

/** Where the pages get everything from: the copy of the database inside a report, or a server beside the database. */
export interface Source {
  readonly live: boolean;
  /** Runs one statement that reads. Rejects with a sentence that says what is wrong with it. */
  query(sql: string, values?: Cell[], mostRows?: number): Promise<Table>;
  /** Calls back whenever the database has changed, or cannot be reached (with a sentence), or can again (null). */
  watch(changed: () => void, trouble: (sentence: string | null) => void): void;
  /** Robots in motion, computed for `run` and `trial` if need be; see `pages/replay`. */
  prepareReplay(run: number, trial: number): Promise<void>;
}

export const kMostRows = 100_000;

/** Rows as objects, by column name. */
export function objects<Row>(table: Table): Row[] {
  return table.rows.map((row) => Object.fromEntries(row.map((cell, i) => [table.columns[i], cell])) as Row);
}
