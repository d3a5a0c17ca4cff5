// Holds the database of a report and answers queries, away from the thread that draws.
import initSqlJs, { type Database, type Statement, type Value } from 'sql.js/dist/sql-wasm-browser.js';
import wasm from '../../node_modules/sql.js/dist/sql-wasm-browser.wasm';
import { fromBase64 } from './base64';
import { decodeTrace, kTraceColumns, type Trace } from './trace';

export type Request =
  | { kind: 'open'; text: string }
  | { kind: 'query'; id: number; sql: string; values: Value[]; most: number };
export type Answer =
  | { kind: 'opened' }
  | { kind: 'failed'; id: number; message: string }
  | { kind: 'table'; id: number; columns: string[]; rows: Value[][]; cut: boolean };

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

const kLongest = 20_000; // ms

function rowsOf(statement: Statement, most: number): { rows: Value[][]; cut: boolean } {
  const rows: Value[][] = [];
  const end = performance.now() + kLongest;
  while (statement.step()) {
    if (rows.length === most) return { rows, cut: true };
    rows.push(statement.get());
    if (rows.length % 1024 === 0 && performance.now() > end) throw new Error('the query takes longer than 20 s');
  }
  return { rows, cut: false };
}

/** The rows of the last of the statements. */
function answer(request: Request & { kind: 'query' }): Answer {
  const statements = database.iterateStatements(request.sql);
  let table: Answer | null = null;
  for (let next = statements.next(); !next.done; next = statements.next()) {
    const statement = next.value;
    if (/^\s*(attach|detach|pragma\s+\w+\s*=)/i.test(request.sql)) throw new Error('only reading is allowed here');
    if (request.values.length > 0) statement.bind(request.values);
    const found = rowsOf(statement, request.most);
    table = { kind: 'table', id: request.id, columns: statement.getColumnNames(), ...found };
  }
  if (!table) throw new Error('there is no statement; try SELECT * FROM error_by_revision');
  return table;
}

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  const id = data.kind === 'query' ? data.id : -1;
  try {
    if (data.kind === 'open') {
      await open(data.text);
      self.postMessage({ kind: 'opened' } satisfies Answer);
    } else {
      self.postMessage(answer(data));
    }
  } catch (error) {
    self.postMessage({ kind: 'failed', id, message: error instanceof Error ? error.message : String(error) } satisfies Answer);
  }
};
