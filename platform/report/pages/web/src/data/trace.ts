import type { Cell, Source, Value } from './source';

export interface Channel {
  name: string;
  unit: string;
}

/** A time series: one array a channel. */
export interface Trace {
  times: Float64Array;
  channels: Channel[];
  /** SI; NaN: not measured. */
  values: Float64Array[];
}

/** The columns that `decodeTrace` takes, in order. */
export const kTraceColumns = 'trace.channels, trace.sample_count, trace.precision, trace.times, trace.samples';

const aligned = (bytes: Uint8Array): ArrayBuffer => bytes.slice().buffer as ArrayBuffer;

function decodeTimes(bytes: Uint8Array, count: number): Float64Array {
  const numbers = new Float64Array(aligned(bytes));
  if (numbers.length === count) return numbers;
  const [start, step] = numbers; // equally spaced times are stored as these two
  return Float64Array.from({ length: count }, (_, i) => start + step * i);
}

/** The bytes of table `trace`, as schema/database.md describes them. */
export function decodeTrace([channels, count, precision, times, samples]: Cell[]): Trace {
  const names = JSON.parse(channels as string) as Trace['channels'];
  const rows = count as number;
  const buffer = aligned(samples as Uint8Array);
  const flat = precision === 'float32' ? new Float32Array(buffer) : new Float64Array(buffer);
  const values = names.map((_, channel) => {
    const column = new Float64Array(rows);
    for (let row = 0; row < rows; ++row) column[row] = flat[row * names.length + channel];
    return column;
  });
  return { times: decodeTimes(times as Uint8Array, rows), channels: names, values };
}

/** Time series by the kinds that `sql` finds with the keys of table `trace`; each is asked for by itself, since an answer
 *  has a largest size. */
export async function loadTraces(source: Source, sql: string, values: Value[]): Promise<Map<string, Trace>> {
  const { rows } = await source.query(sql, values);
  const traces = await Promise.all(
    rows.map(async ([kind, id]): Promise<[string, Trace]> => {
      const found = await source.query(`SELECT ${kTraceColumns} FROM trace WHERE id = ?`, [id as Value]);
      return [kind as string, decodeTrace(found.rows[0])];
    }),
  );
  return new Map(traces);
}
