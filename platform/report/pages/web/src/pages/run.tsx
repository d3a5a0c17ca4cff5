import type { ComponentChildren } from 'preact';
import { useRows } from '../data/use';
import { choose, linkTo, notHere } from '../kit/route';
import { Chart } from '../ui/chart';
import { Empty, Select, Show } from '../ui/parts';
import { kindOf, kRuns, passAxis, type PassRow, type Run } from './run_data';
import { Ensemble, Foretold, Spread } from './run_models';
import { useProgress, type Standing } from './run_progress';
import { State } from './run_state';
import { useScoreUnit } from './score_unit';
import { Best } from './run_values';

/** One run of the algorithm; live while it runs. */
export function RunPage({ choices }: { choices: Record<string, string> }) {
  const runs = useRows<Run>(kRuns);
  return (
    <Show of={runs}>
      {(all) =>
        all.length === 0 ? (
          <Empty>
            The database has no run of the Estimation-Exploration Algorithm (<code>lacuna run FILE</code>). Comparing and
            diagnosing a model need none.
          </Empty>
        ) : (
          <Chosen all={all} choices={choices} />
        )
      }
    </Show>
  );
}

/** The run that is asked for, else the one that got on last. */
function Chosen({ all, choices }: { all: Run[]; choices: Record<string, string> }) {
  const asked = all.find((one) => String(one.run) === choices.run);
  const { run, standing } = useProgress(all, asked);
  const missing = notHere(
    'run',
    choices.run,
    all.map((one) => one.run),
  );
  if (missing !== null)
    return (
      <>
        <RunSelect all={all} />
        <Empty>{missing} Choose a run from the list.</Empty>
      </>
    );
  return <OneRun key={run.run} run={run} all={all} standing={standing} pass={choices.pass} />;
}

function RunSelect({ run, all, children }: { run?: Run; all: Run[]; children?: ComponentChildren }) {
  const options = all.map((one) => ({
    value: String(one.run),
    label: `${one.run} · ${one.experiment} · replicate ${one.replicate} · ${one.ending}`,
  }));
  return (
    <div class="choices">
      <Select
        label="Run"
        value={run ? String(run.run) : ''}
        change={(value) => choose({ run: value, pass: null })}
        options={run ? options : [{ value: '', label: '—' }, ...options]}
      />
      {children}
    </div>
  );
}

interface OneRunProps {
  run: Run;
  all: Run[];
  standing: Standing;
  pass: string | undefined;
}

function OneRun({ run, all, standing, pass }: OneRunProps) {
  return (
    <>
      <RunSelect run={run} all={all}>
        <a href={linkTo('replay', { run: run.run })}>replay</a>
        <a href={linkTo('runs', { experiment: run.experiment })}>all replicates</a>
      </RunSelect>
      <State run={run} standing={standing} />
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

const number = (value: number | null) => value ?? NaN;

function ErrorByPass({ run }: { run: Run }) {
  const rows = useRows<PassRow>('SELECT * FROM error_by_pass WHERE run = ? ORDER BY pass', [run.run]);
  const { unit, channels } = useScoreUnit(run);
  return (
    <Show of={rows}>
      {(all) => (
        <Chart
          title="Error of the best model"
          x={passAxis}
          y={{ label: run.metric.replace(/_/g, ' '), unit, log: true }}
          note={`Over all trials so far; a new trial can increase it.${channels ? ` Measured: ${channels}.` : ''}`}
          series={[
            {
              name: 'best model',
              unlisted: true,
              kind: 'both',
              colour: 'predicted',
              x: all.map((one) => one.pass),
              y: all.map((one) => number(one.error)),
            },
          ]}
          pick={(_, i) => choose({ run: run.run, pass: all[i].pass })}
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
                  title={`True-parameter error: ${name}`}
                  x={passAxis}
                  y={{ label: 'true-parameter error', unit, include: [0] }}
                  note={`Difference from the true (hidden) value${several ? ': mean over the values of this kind; band: smallest to largest' : ''}.`}
                  series={[
                    ...(several
                      ? [
                          {
                            name: 'smallest to largest',
                            unlisted: true,
                            kind: 'band' as const,
                            colour: 'truth' as const,
                            x,
                            y: mean,
                            lower: x.map((pass) => Math.min(...passes.get(pass)!)),
                            upper: x.map((pass) => Math.max(...passes.get(pass)!)),
                          },
                        ]
                      : []),
                    { name: several ? 'mean' : name, unlisted: true, kind: 'both', colour: 'truth', x, y: mean },
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
            note="Result that the models predicted when they chose the test, and the target's result."
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
