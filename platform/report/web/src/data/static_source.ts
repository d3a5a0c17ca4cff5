import workerText from 'worker-text';
import { kMostRows, type Cell, type Source, type Table } from './source';
import type { Answer, Request } from './worker';

interface Waiting {
  resolve: (table: Table) => void;
  reject: (error: Error) => void;
}

/** The database inside the page, read by sql.js in a worker. */
export class StaticSource implements Source {
  readonly live = false;
  private readonly worker: Worker;
  private readonly waiting = new Map<number, Waiting>();
  private next = 0;

  private constructor() {
    const script = URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' }));
    this.worker = new Worker(script);
  }

  /** `text`: the database, gzip, base64. */
  static async open(text: string): Promise<StaticSource> {
    const source = new StaticSource();
    await new Promise<void>((resolve, reject) => {
      source.worker.onmessage = ({ data }: MessageEvent<Answer>) =>
        data.kind === 'failed' ? reject(new Error(data.message)) : resolve();
      source.worker.onerror = (event) => reject(new Error(event.message || 'the browser allows no worker'));
      source.worker.postMessage({ kind: 'open', text } satisfies Request);
    });
    source.worker.onmessage = ({ data }: MessageEvent<Answer>) => source.take(data);
    return source;
  }

  query(sql: string, values: Cell[] = [], mostRows = kMostRows): Promise<Table> {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ kind: 'query', id, sql, values, most: mostRows } satisfies Request);
    });
  }

  watch(): void {}

  async prepareReplay(): Promise<void> {}

  private take(answer: Answer): void {
    if (answer.kind === 'opened') return;
    const waiting = this.waiting.get(answer.id);
    this.waiting.delete(answer.id);
    if (answer.kind === 'failed') waiting?.reject(new Error(answer.message));
    else waiting?.resolve(answer);
  }
}
