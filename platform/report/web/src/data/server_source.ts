import { fromBase64 } from './base64';
import { kMostRows, type Cell, type Source, type Table } from './source';

type JsonCell = number | string | null | { base64: string };

const kPoll = 1000; // ms between looks at whether the database has changed
const kShareOfTime = 50; // what looks cost a processor is at most a 50th of the time, so that a run keeps it

/** The server of `lacuna serve`, which is where the page came from. */
export class ServerSource implements Source {
  readonly live = true;
  private readonly token = new URLSearchParams(location.search).get('token') ?? '';
  private cost = 0; // ms of the server's processor since the last look

  async query(sql: string, values: Cell[] = [], mostRows = kMostRows): Promise<Table> {
    const response = await this.post('sql', { sql, values, most: mostRows });
    const answer = (await response.json()) as { error?: string; columns: string[]; rows: JsonCell[][]; cut: boolean };
    if (answer.error !== undefined) throw new Error(answer.error);
    this.cost += 1000 * Number(response.headers.get('X-Lacuna-Seconds') ?? 0);
    const rows = answer.rows.map((row) =>
      row.map((cell) => (cell !== null && typeof cell === 'object' ? fromBase64(cell.base64) : cell)));
    return { columns: answer.columns, rows, cut: answer.cut };
  }

  watch(changed: () => void, trouble: (sentence: string | null) => void): void {
    let stamp: string | null = null;
    const look = async () => {
      let pause = kPoll;
      try {
        if (!document.hidden) {
          const { stamp: now, error } = (await (await this.post('state', {})).json()) as { stamp: string; error?: string };
          trouble(error ?? null);
          if (stamp !== null && now !== stamp && !error) {
            pause = Math.max(kPoll, Math.min(kShareOfTime * this.cost, 30 * kPoll));
            this.cost = 0;
            changed();
          }
          stamp = now;
        }
      } catch {
        trouble('lacuna serve does not answer; this page goes on when it does');
      }
      setTimeout(look, pause);
    };
    void look();
  }

  async prepareReplay(run: number, trial: number): Promise<void> {
    const answer = (await (await this.post('replay', { run, trial })).json()) as { error?: string };
    if (answer.error !== undefined) throw new Error(answer.error);
  }

  private post(path: string, body: unknown): Promise<Response> {
    return fetch(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', 'X-Lacuna-Token': this.token },
      body: JSON.stringify(body),
    });
  }
}
