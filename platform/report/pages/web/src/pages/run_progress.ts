import { useContext, useEffect, useRef, useState } from 'preact/hooks';
import { SharedContext } from '../data/use';
import type { Run } from './run_data';

/** Replicates that one command began have numbers in a row. */
const commandOf = (run: Run) => `${run.experiment}|${run.run - run.replicate}`;

/** The run that got on last, by what the database knows: when a run ended, when it began and how long it has worked. One
 *  that was under way when others of its command ended got on after them. */
export function newestRun(all: Run[]): Run {
  const ends = new Map<string, number>();
  for (const run of all)
    if (run.ended !== null)
      ends.set(commandOf(run), Math.max(Date.parse(run.ended), ends.get(commandOf(run)) ?? -Infinity));
  const moment = (run: Run) => {
    if (run.ended !== null) return Date.parse(run.ended);
    if (run.seconds === null) return Date.parse(run.started);
    return Math.max(Date.parse(run.started) + 1000 * run.seconds, ends.get(commandOf(run)) ?? -Infinity);
  };
  const rank = (run: Run) => [
    moment(run),
    run.seconds === null ? 0 : 1,
    run.ended === null ? 1 : 0,
    run.ended === null ? -run.run : run.run,
  ];
  const isBefore = (a: number[], b: number[]) => {
    const i = a.findIndex((one, at) => one !== b[at]);
    return i >= 0 && a[i] < b[i];
  };
  return all.reduce((best, run) => (isBefore(rank(best), rank(run)) ? run : best));
}

export type Standing = { is: 'ended' | 'running' | 'waiting' | 'not known yet' } | { is: 'quiet'; seconds: number };

interface Seen {
  mark: string;
  /** s; when it was seen to change last, or first. */
  at: number;
  moved: boolean;
  longestGap: number; // s
}

const kQuiet = 15; // s without a change that say nothing yet

/** Whether runs go on, by what a viewer sees change. */
export class ProgressWatch {
  private readonly seen = new Map<number, Seen>();
  private shown: number | null = null;
  private now = 0;

  /** A second of looking. */
  tick(): void {
    ++this.now;
  }

  note(all: Run[]): void {
    for (const run of all) {
      const mark = [run.models, run.tests, run.trials, run.passes_done, run.seconds, run.ending].join();
      const old = this.seen.get(run.run);
      if (old?.mark === mark) continue;
      const gap = old?.moved ? this.now - old.at : 0;
      this.seen.set(run.run, {
        mark,
        at: this.now,
        moved: old !== undefined,
        longestGap: Math.max(gap, old?.longestGap ?? 0),
      });
    }
  }

  standing(run: Run, all: Run[]): Standing {
    if (run.ending !== 'not ended') return { is: 'ended' };
    if (this.isRunning(run)) return { is: 'running' };
    const own = commandOf(run);
    if (run.seconds === null && all.some((one) => commandOf(one) === own && this.isRunning(one)))
      return { is: 'waiting' };
    const seconds = this.quiet(run);
    return seconds > this.limit(run) ? { is: 'quiet', seconds } : { is: 'not known yet' };
  }

  /** The run to show where none is asked for: the one that is shown as long as it goes on, then the one that changed
   *  last; before anything has changed, the newest. */
  choose(all: Run[]): Run {
    const shown = all.find((run) => run.run === this.shown);
    const moving = all.filter((run) => this.isRunning(run)).sort((a, b) => this.quiet(a) - this.quiet(b));
    const chosen = shown && moving.includes(shown) ? shown : (moving[0] ?? newestRun(all));
    this.shown = chosen.run;
    return chosen;
  }

  private isRunning(run: Run): boolean {
    const own = this.seen.get(run.run);
    return run.ending === 'not ended' && own !== undefined && own.moved && this.quiet(run) <= this.limit(run);
  }
  private quiet(run: Run): number {
    return this.now - (this.seen.get(run.run)?.at ?? this.now);
  }
  private limit(run: Run): number {
    return Math.max(kQuiet, 3 * (this.seen.get(run.run)?.longestGap ?? 0));
  }
}

/** The run to show, `asked` or else the one that got on last, and how it stands, as long as the page is in sight. */
export function useProgress(all: Run[], asked: Run | undefined): { run: Run; standing: Standing } {
  const { source } = useContext(SharedContext);
  const [watch] = useState(() => new ProgressWatch());
  const [, tell] = useState('');
  watch.note(all);
  const look = () => {
    const run = asked ?? watch.choose(all);
    return { run, standing: watch.standing(run, all) };
  };
  const latest = useRef(look);
  latest.current = look;
  const open = source.live && all.some((run) => run.ending === 'not ended');
  useEffect(() => {
    if (!open) return;
    const timer = setInterval(() => {
      if (document.hidden) return;
      watch.tick();
      const { run, standing } = latest.current();
      tell(JSON.stringify([run.run, standing]));
    }, 1000);
    return () => clearInterval(timer);
  }, [open]);
  return look();
}
