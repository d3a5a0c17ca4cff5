/** How many bytes there are, where their content was not asked for. */
export interface Size {
  bytes: number;
}

/** What a parameter of a query may be. */
export type Value = number | string | null | Uint8Array;

/** What a query may find in a cell: NaN and infinity do not occur, what is not known is null; an integer that no number
 *  holds exactly is text. */
export type Cell = Value | Size;

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
  query(sql: string, values?: Value[]): Promise<Table>;
  /** The same for what a user typed: of bytes it tells how many they are. */
  ask(sql: string, mostRows: number): Promise<Table>;
  /** Calls back whenever the database has changed, or cannot be reached (with a sentence), or can again (null). */
  watch(changed: () => void, trouble: (sentence: string | null) => void): void;
  /** Has the robots of that trial in motion; resolves to their key in `page_replay`, null where they are not here. */
  prepareReplay(run: number, trial: number): Promise<number | null>;
}

export const kMostRows = 100_000;
/** An answer has no further rows after so many bytes; as storage/queries/page_query.h has it. */
export const kMostBytes = 64 * 2 ** 20;

/** Rows as objects, by column name. */
export function objects<Row>(table: Table): Row[] {
  return table.rows.map((row) => Object.fromEntries(row.map((cell, i) => [table.columns[i], cell])) as Row);
}
