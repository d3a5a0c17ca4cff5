import type { Cell, Source, Table, Value } from './source';

/** What was answered, by question. */
export type Answers = Map<string, Table>;

/** A source that remembers what it was asked and answered. */
export class AnswersOf implements Source {
  readonly answers: Answers = new Map();
  readonly live: boolean;

  constructor(private readonly source: Source) {
    this.live = source.live;
  }

  async query(sql: string, values: Value[] = []): Promise<Table> {
    const table = await this.source.query(sql, values);
    this.answers.set(JSON.stringify([sql, values]), table);
    return table;
  }

  ask(sql: string, mostRows: number): Promise<Table> {
    return this.source.ask(sql, mostRows);
  }

  watch(changed: () => void, trouble: (sentence: string | null) => void): void {
    this.source.watch(changed, trouble);
  }

  prepareReplay(run: number, trial: number): Promise<number | null> {
    return this.source.prepareReplay(run, trial);
  }
}

function sameCell(a: Cell, b: Cell): boolean {
  if (a === b) return true;
  if (!(a instanceof Uint8Array) || !(b instanceof Uint8Array)) return false;
  return a.length === b.length && a.every((byte, i) => byte === b[i]);
}

const sameTable = (a: Table, b: Table) =>
  a.cut === b.cut &&
  a.columns.join() === b.columns.join() &&
  a.rows.length === b.rows.length &&
  a.rows.every((row, r) => row.every((cell, c) => sameCell(cell, b.rows[r][c])));

/** Whether the same questions were answered the same. */
export const sameAnswers = (a: Answers, b: Answers) =>
  a.size === b.size && [...a].every(([question, table]) => b.has(question) && sameTable(table, b.get(question)!));
