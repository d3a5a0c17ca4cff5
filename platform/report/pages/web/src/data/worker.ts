// Holds the database of a report and answers queries, away from the thread that draws.
import initSqlJs, { type Database, type Statement } from 'sql.js/dist/sql-wasm-browser.js';
import wasm from '../../node_modules/sql.js/dist/sql-wasm-browser.wasm';
import { fromBase64 } from './base64';
import { isReading } from './reading_only';
import { kMostBytes, type Cell, type Table, type Value } from './source';
import { decodeTrace, kTraceColumns, type Trace } from './trace';

/** Of what a user typed bytes are told by their number. */
export interface Query {
  kind: 'query';
  sql: string;
  values: Value[];
  most: number;
  sizes: boolean;
}
export type Request = { kind: 'open'; text: string } | Query;
export type Answer = { kind: 'opened' } | { kind: 'failed'; message: string } | ({ kind: 'table' } & Table);

let database: Database;

async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const traces = new Map<number, Trace | null>();

function readTrace(id: number): Trace | null {
  const statement = database.prepare(`SELECT ${kTraceColumns} FROM trace WHERE id = ?`);
  statement.bind([id]);
  const trace = statement.step() ? decodeTrace(statement.get()) : null;
  statement.free();
  return trace;
}

function traceOf(id: number): Trace | null {
  if (!traces.has(id)) {
    if (traces.size > 8) traces.clear();
    traces.set(id, readTrace(id));
  }
  return traces.get(id)!;
}

/** Traces are bytes; the view `samples` shows them as rows. */
function showSamples(): void {
  database.create_function('trace_time', (id: number, sample: number) => traceOf(id)?.times[sample] ?? null);
  database.create_function('trace_column', (id: number, channel: number) => {
    const values = traceOf(id)?.values[channel];
    return values ? JSON.stringify(Array.from(values)) : null;
  });
  database.run(`CREATE TEMP VIEW samples AS
    SELECT trace.id AS trace, value.key AS sample, trace_time(trace.id, value.key) AS time,
           json_extract(channel.value, '$.name') AS channel, value.value AS value
    FROM trace, json_each(trace.channels) AS channel, json_each(trace_column(trace.id, channel.key)) AS value`);
}

async function open(text: string): Promise<void> {
  const [sql, bytes] = await Promise.all([
    initSqlJs({ wasmBinary: wasm.buffer as ArrayBuffer, useOldExtensionFunctions: false }),
    inflate(fromBase64(text)),
  ]);
  database = new sql.Database(bytes);
  showSamples();
  database.run('PRAGMA query_only = ON');
}

const kReadOnly = 'only reading is allowed here';
const kExact = 2 ** 53;
const isInexact = (cell: Cell) => typeof cell === 'number' && Number.isInteger(cell) && Math.abs(cell) >= kExact;
const sizeOf = (cell: Cell) => 8 + (typeof cell === 'string' || cell instanceof Uint8Array ? cell.length : 0);

/** Integers that no number holds exactly are text. */
function exactRow(statement: Statement): Cell[] {
  const row: Cell[] = statement.get();
  if (!row.some(isInexact)) return row;
  return statement.get(null, { useBigInt: true }).map((cell) => {
    if (typeof cell !== 'bigint') return cell;
    return Math.abs(Number(cell)) <= kExact && BigInt(Number(cell)) === cell ? Number(cell) : String(cell);
  });
}

function rowsOf(statement: Statement, query: Query): { rows: Cell[][]; cut: boolean } {
  const rows: Cell[][] = [];
  let bytes = 0;
  while (statement.step()) {
    if (rows.length === query.most || bytes > kMostBytes) return { rows, cut: true };
    const row = exactRow(statement).map((cell) =>
      query.sizes && cell instanceof Uint8Array ? { bytes: cell.length } : cell,
    );
    bytes += row.reduce<number>((sum, cell) => sum + sizeOf(cell), 0);
    rows.push(row);
  }
  return { rows, cut: false };
}

/** The rows of the last of the statements. */
function answer(query: Query): Answer {
  const statements = database.iterateStatements(query.sql);
  let table: Answer | null = null;
  for (;;) {
    if (!isReading(statements.getRemainingSQL())) throw new Error(kReadOnly);
    const next = statements.next();
    if (next.done) break;
    if (query.values.length > 0) next.value.bind(query.values);
    const found = rowsOf(next.value, query);
    table = { kind: 'table', columns: next.value.getColumnNames(), ...found };
  }
  if (!table) throw new Error('there is no statement; try SELECT * FROM error_by_revision');
  return table;
}

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  try {
    if (data.kind === 'open') {
      await open(data.text);
      self.postMessage({ kind: 'opened' } satisfies Answer);
    } else {
      self.postMessage(answer(data));
    }
  } catch (error) {
    const said = error instanceof Error ? error.message : String(error);
    const message = /readonly database/.test(said) ? kReadOnly : said;
    self.postMessage({ kind: 'failed', message } satisfies Answer);
  }
};
