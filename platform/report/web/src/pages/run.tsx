import { useContext, useEffect, useRef, useState } from 'preact/hooks';
import { SharedContext, useRows } from '../data/use';
import { count, duration, plain } from '../kit/format';
import { choose, linkTo } from '../kit/route';
import { Chart } from '../ui/chart';
import { Empty, Select, Show } from '../ui/parts';
import { kindOf, kRuns, passAxis, secondsLeft, type PassRow, type Run } from './run_data';
import { Ensemble, Foretold, Spread } from './run_models';
import { Best } from './run_values';

/** One run of the algorithm; live while it runs. */
export function RunPage({ choices }: { choices: Record<string, string> }) {
  const runs = useRows<Run>(kRuns);
  return (
    <Show of={runs}>
      {(all) => {
        if (all.length === 0)
          return (
            <Empty>
              The database has no run of the algorithm. <code>lacuna run FILE</code> makes one.
            </Empty>
          );
        const running = all.filter((one) => one.ending === 'not ended');
        const run =
          all.find((one) => String(one.run) === choices.run) ?? running[running.length - 1] ?? all[all.length - 1];
        return <OneRun key={run.run} run={run} all={all} pass={choices.pass} />;
      }}
    </Show>
  );
}

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

function OneRun({ run, all, pass }: { run: Run; all: Run[]; pass: string | undefined }) {
  return (
    <>
      <div class="choices">
        <Select
          label="Run"
          value={String(run.run)}
          change={(value) => choose({ run: value, pass: null })}
          options={all.map((one) => ({
            value: String(one.run),
            label: `${one.run} · ${one.experiment} · replicate ${one.replicate} · ${one.ending}`,
          }))}
        />
        <a href={linkTo('replay', { run: run.run })}>replay</a>
        <a href={linkTo('runs', { experiment: run.experiment })}>all replicates</a>
      </div>
      <State run={run} />
      <div class="two">
        <ErrorByPass run={run} />
        <Objective run={run} />
        <Transfer run={run} />
        <Foretold run={run} />
        {run.selected === 0 && <Spread run={run} />}
      </div>
      <Best run={run} pass={pass} />
      <Ensemble run={run} pass={pass} />
    </>
  );
}

function State({ run }: { run: Run }) {
  const { source } = useContext(SharedContext);
  const rate = useRate(run);
  const running = run.ending === 'not ended';
  const stopped = useRows<{ pass: number; stopped: string }>(
    'SELECT number AS pass, stopped FROM pass WHERE run = ? AND stopped IS NOT NULL',
    [run.run],
  ).value?.[0];
  const facts: [string, string][] = [
    ['passes', `${run.passes_done} of ${run.passes}`],
    ['best error', plain(run.best_score, 4)],
    ['models', count(run.models)],
    ['tests', count(run.tests)],
    ['target trials', count(run.trials)],
    ['work', duration(run.seconds)],
    ...(running && source.live
      ? ([
          ['evaluations per second', rate === null ? '…' : count(rate)],
          ['left, about', duration(secondsLeft(run))],
        ] as [string, string][])
      : ([['evaluations per second', run.seconds ? count((run.models + run.tests) / run.seconds) : '—']] as [
          string,
          string,
        ][])),
  ];
  return (
    <>
      <p class="lead">
        Run {run.run} of {run.experiment}, replicate {run.replicate}:{' '}
        <strong>
          {running ? (source.live ? 'running or broken off' : 'not ended when this report was made') : run.ending}
        </strong>
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

const number = (value: number | null) => value ?? NaN;

function ErrorByPass({ run }: { run: Run }) {
  const rows = useRows<PassRow>('SELECT * FROM error_by_pass WHERE run = ? ORDER BY pass', [run.run]);
  return (
    <Show of={rows}>
      {(all) => (
        <Chart
          title="Error of the best model"
          x={passAxis}
          y={{ label: run.metric.replace(/_/g, ' '), unit: '1', log: true }}
          note="Over all trials so far, so that a new trial may raise it."
          series={[
            {
              name: '',
              kind: 'both',
              colour: 'predicted',
              x: all.map((one) => one.pass),
              y: all.map((one) => number(one.error)),
            },
          ]}
          pick={(_, i) => choose({ pass: all[i].pass })}
        />
      )}
    </Show>
  );
}

function Objective({ run }: { run: Run }) {
  const rows = useRows<{ pass: number; address: string; error: number | null; unit: string }>(
    'SELECT pass, address, error, unit FROM parameter_error_by_pass WHERE run = ? ORDER BY address, pass',
    [run.run],
  );
  return (
    <Show of={rows}>
      {(all) => {
        if (all.length === 0) return null;
        // One picture a unit and group: masses in kg, delays in s, or whatever the objective metric calls its figures.
        const groups = new Map<string, Map<number, number[]>>();
        for (const { pass, address, error, unit } of all) {
          if (error === null) continue;
          const group = `${kindOf(address)}|${unit}`;
          const passes = groups.get(group) ?? groups.set(group, new Map()).get(group)!;
          passes.set(pass, [...(passes.get(pass) ?? []), error]);
        }
        return (
          <>
            {[...groups].map(([group, passes]) => {
              const [name, unit] = group.split('|');
              const x = [...passes.keys()].sort((a, b) => a - b);
              const mean = x.map(
                (pass) => passes.get(pass)!.reduce((sum, one) => sum + one, 0) / passes.get(pass)!.length,
              );
              const several = Math.max(...[...passes.values()].map((one) => one.length)) > 1;
              return (
                <Chart
                  key={group}
                  title={`Objective error: ${name}`}
                  x={passAxis}
                  y={{ label: 'distance from the truth', unit, include: [0] }}
                  note={several ? 'Mean over the values of that kind; band: the smallest and the largest.' : undefined}
                  series={[
                    ...(several
                      ? [
                          {
                            name: '',
                            kind: 'band' as const,
                            colour: 'truth' as const,
                            x,
                            y: mean,
                            lower: x.map((pass) => Math.min(...passes.get(pass)!)),
                            upper: x.map((pass) => Math.max(...passes.get(pass)!)),
                          },
                        ]
                      : []),
                    { name: '', kind: 'both', colour: 'truth', x, y: mean },
                  ]}
                />
              );
            })}
          </>
        );
      }}
    </Show>
  );
}

interface TransferRow {
  trial: number;
  pass: number;
  predicted: number;
  measured: number | null;
  unit: string | null;
  fitness: string;
  for_transfer: number;
}

function Transfer({ run }: { run: Run }) {
  const rows = useRows<TransferRow>(
    'SELECT trial, pass, predicted, measured, unit, fitness, for_transfer FROM transfer_gap WHERE run = ? ORDER BY trial',
    [run.run],
  );
  return (
    <Show of={rows}>
      {(all) =>
        all.length === 0 ? null : (
          <Chart
            title="Transfer: predicted and measured"
            x={{ label: 'target trial', unit: '1', whole: true }}
            y={{ label: all[0].fitness.replace(/_/g, ' '), unit: all[0].unit ?? '1', include: [0] }}
            note="What the models that chose a test said it would do, and what the target did."
            series={[
              {
                name: 'predicted',
                kind: 'both',
                colour: 'predicted',
                x: all.map((one) => one.trial),
                y: all.map((one) => one.predicted),
              },
              {
                name: 'measured',
                kind: 'both',
                colour: 'measured',
                dashed: true,
                x: all.map((one) => one.trial),
                y: all.map((one) => number(one.measured)),
              },
            ]}
            pick={(_, i) => {
              if (!all[i].for_transfer) location.hash = linkTo('replay', { run: run.run, trial: all[i].trial });
            }}
          />
        )
      }
    </Show>
  );
}
