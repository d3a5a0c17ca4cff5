import { fromBase64 } from './base64';
import { kMostRows, type Size, type Source, type Table, type Value } from './source';

type JsonCell = number | string | null | { base64: string } | Size;

const kPoll = 1000; // ms between looks at whether the database has changed

/** The server of `lacuna serve`, which is where the page came from. */
export class ServerSource implements Source {
  readonly live = true;
  private readonly token = new URLSearchParams(location.search).get('token') ?? '';

  query(sql: string, values: Value[] = []): Promise<Table> {
    return this.sql('show', { sql, values, most: kMostRows });
  }

  ask(sql: string, mostRows: number): Promise<Table> {
    return this.sql('sql', { sql, most: mostRows, sizes: true });
  }

  /** The server tells of a change late enough that it does not slow a run. */
  watch(changed: () => void, trouble: (sentence: string | null) => void): void {
    let stamp: string | null = null;
    const look = async () => {
      try {
        if (!document.hidden) {
          const { stamp: now, error } = await this.post<{ stamp: string; error?: string }>('state', {});
          trouble(error ?? null);
          if (stamp !== null && now !== stamp && !error) changed();
          stamp = now;
        }
      } catch {
        trouble('lacuna serve does not answer; the page continues when it does');
      }
      setTimeout(look, kPoll);
    };
    void look();
  }

  async prepareReplay(run: number, trial: number): Promise<number | null> {
    const { replay, error } = await this.post<{ replay: number; error?: string }>('replay', { run, trial });
    if (error !== undefined) throw new Error(error);
    return replay;
  }

  /** What a page shows (`show`) does not wait for what a user typed (`sql`). */
  private async sql(path: 'show' | 'sql', question: unknown): Promise<Table> {
    const answer = await this.post<{ error?: string; columns: string[]; rows: JsonCell[][]; cut: boolean }>(
      path,
      question,
    );
    if (answer.error !== undefined) throw new Error(answer.error);
    const cell = (one: JsonCell) =>
      one !== null && typeof one === 'object' && 'base64' in one ? fromBase64(one.base64) : one;
    return { columns: answer.columns, rows: answer.rows.map((row) => row.map(cell)), cut: answer.cut };
  }

  private async post<Answer>(path: string, body: unknown): Promise<Answer> {
    const response = await fetch(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', 'X-Lacuna-Token': this.token },
      body: JSON.stringify(body),
    });
    if (response.headers.get('Content-Type') !== 'application/json') throw new Error((await response.text()).trim());
    return (await response.json()) as Answer;
  }
}
