import { useContext, useEffect, useRef, useState } from 'preact/hooks';
import { SharedContext, useRows } from '../data/use';
import { count, duration, quantity } from '../kit/format';
import { secondsLeft, type Run } from './run_data';
import type { Standing } from './run_progress';
import { useScoreUnit } from './score_unit';

/** Evaluations per second, between what was seen last and now. */
function useRate(run: Run): number | null {
  const seen = useRef<{ seconds: number; models: number }[]>([]);
  const [rate, setRate] = useState<number | null>(null);
  useEffect(() => {
    if (run.seconds === null) return;
    seen.current = [...seen.current, { seconds: run.seconds, models: run.models + run.tests }].slice(-8);
    const [first, last] = [seen.current[0], seen.current[seen.current.length - 1]];
    if (last.seconds > first.seconds) setRate((last.models - first.models) / (last.seconds - first.seconds));
  }, [run.seconds, run.models, run.tests]);
  return rate;
}

/** How a run stands, as far as it can be seen. */
function StandingText({ run, standing }: { run: Run; standing: Standing }) {
  const { source } = useContext(SharedContext);
  if (standing.is === 'ended') return <strong>{run.ending}</strong>;
  if (!source.live) return <strong>not ended when this report was made</strong>;
  if (standing.is === 'quiet')
    return (
      <>
        <strong>no progress seen for {duration(standing.seconds)}</strong>: slow or stopped. To continue:{' '}
        <code>lacuna run FILE --resume</code>
      </>
    );
  const words = { running: 'running', waiting: 'waiting', 'not known yet': 'not ended' };
  return <strong>{words[standing.is]}</strong>;
}

/** How fast a run is: while it goes on lately, afterwards over all; of one that may be broken off nothing. */
function speedOf(run: Run, standing: Standing, live: boolean, rate: number | null): [string, string][] {
  if (standing.is === 'ended' || !live)
    return [['evaluations per second', run.seconds ? count((run.models + run.tests) / run.seconds) : '—']];
  if (standing.is === 'quiet' || standing.is === 'waiting') return [];
  const left = run.passes_done === 0 ? 'known after pass 1' : duration(secondsLeft(run));
  return [
    ['evaluations per second', rate === null ? '…' : count(rate)],
    ['time left, about', standing.is === 'running' ? left : '…'],
  ];
}

/** How far a run is, and how fast. */
export function State({ run, standing }: { run: Run; standing: Standing }) {
  const { source } = useContext(SharedContext);
  const rate = useRate(run);
  const { unit } = useScoreUnit(run);
  const stopped = useRows<{ pass: number; stopped: string }>(
    'SELECT number AS pass, stopped FROM pass WHERE run = ? AND stopped IS NOT NULL',
    [run.run],
  ).value?.[0];
  const facts: [string, string][] = [
    ['passes', `${run.passes_done} of ${run.passes}`],
    ['best error', quantity(run.best_score, unit, 4)],
    ['models', count(run.models)],
    ['tests', count(run.tests)],
    ['target trials', count(run.trials)],
    ['running time', duration(run.seconds)],
    ...speedOf(run, standing, source.live, rate),
  ];
  return (
    <>
      <p class="lead">
        Run {run.run} of {run.experiment}, replicate {run.replicate}: <StandingText run={run} standing={standing} />
      </p>
      {stopped && (
        <p>
          Stopped after pass {stopped.pass}: {stopped.stopped}.
        </p>
      )}
      <progress value={run.passes_done} max={run.passes} aria-label="passes" />
      <dl class="facts">
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}
