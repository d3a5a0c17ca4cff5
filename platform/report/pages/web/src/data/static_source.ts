import workerText from 'worker-text';
import { kMostRows, type Source, type Table, type Value } from './source';
import type { Answer, Query, Request } from './worker';

const kLongest = 10_000; // ms a query may take, as the server has it

interface Waiting {
  query: Query;
  resolve: (table: Table) => void;
  reject: (error: Error) => void;
}

/** The database inside the page, read by sql.js in a worker, one query after the other. */
export class StaticSource implements Source {
  readonly live = false;
  private readonly script = URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' }));
  private readonly queue: Waiting[] = [];
  private worker: Worker | null = null;
  private asked: Waiting | null = null;
  private timer = 0;
  private broken: Error | null = null;

  private constructor(private readonly text: string) {}

  /** `text`: the database, gzip, base64. */
  static async open(text: string): Promise<StaticSource> {
    const source = new StaticSource(text);
    await source.start();
    return source;
  }

  query(sql: string, values: Value[] = []): Promise<Table> {
    return this.enqueue({ kind: 'query', sql, values, most: kMostRows, sizes: false });
  }

  ask(sql: string, mostRows: number): Promise<Table> {
    return this.enqueue({ kind: 'query', sql, values: [], most: mostRows, sizes: true });
  }

  watch(): void {}

  /** What the report has is found by its run and trial. */
  async prepareReplay(run: number, trial: number): Promise<number | null> {
    const { rows } = await this.query(
      'SELECT id FROM page_replay WHERE run = ? AND trial = ? ORDER BY pass DESC LIMIT 1',
      [run, trial],
    );
    return rows.length > 0 ? (rows[0][0] as number) : null;
  }

  private enqueue(query: Query): Promise<Table> {
    if (this.broken) return Promise.reject(this.broken);
    return new Promise((resolve, reject) => {
      this.queue.push({ query, resolve, reject });
      this.next();
    });
  }

  /** A new worker that has opened the database. */
  private start(): Promise<void> {
    const worker = new Worker(this.script);
    return new Promise((resolve, reject) => {
      const fail = (message: string) => {
        worker.terminate();
        reject(new Error(message));
      };
      worker.onerror = (event) => fail(event.message || 'the browser does not allow web workers');
      worker.onmessage = ({ data }: MessageEvent<Answer>) => {
        if (data.kind === 'failed') return fail(data.message);
        worker.onmessage = (event: MessageEvent<Answer>) => this.take(event.data);
        worker.onerror = (event) => this.startAgain(event.message || 'the query failed');
        this.worker = worker;
        resolve();
      };
      worker.postMessage({ kind: 'open', text: this.text } satisfies Request);
    });
  }

  private next(): void {
    if (this.asked || !this.worker || this.queue.length === 0) return;
    this.asked = this.queue.shift()!;
    this.timer = window.setTimeout(
      () => this.startAgain(`the query took longer than ${kLongest / 1000} s and was stopped`),
      kLongest,
    );
    this.worker.postMessage(this.asked.query satisfies Request);
  }

  private take(answer: Answer): void {
    clearTimeout(this.timer);
    const asked = this.asked;
    this.asked = null;
    if (answer.kind === 'failed') asked?.reject(new Error(answer.message));
    else if (answer.kind === 'table') asked?.resolve(answer);
    this.next();
  }

  /** Nothing else ends a query that is under way. What waits goes on with the new worker. */
  private startAgain(reason: string): void {
    clearTimeout(this.timer);
    this.worker?.terminate();
    this.worker = null;
    this.asked?.reject(new Error(reason));
    this.asked = null;
    this.start().then(
      () => this.next(),
      (error: Error) => {
        this.broken = error;
        for (const one of this.queue.splice(0)) one.reject(error);
      },
    );
  }
}
