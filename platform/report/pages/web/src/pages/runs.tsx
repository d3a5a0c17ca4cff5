import { useCallback, useMemo } from 'preact/hooks';
import { useLoaded, useRows } from '../data/use';
import { cellText, duration, plain } from '../kit/format';
import { linkTo, refine } from '../kit/route';
import { Chart, type ChartSeries } from '../ui/chart';
import { seriesColour, type Colour } from '../kit/colours';
import { DataTable } from '../ui/data_table';
import { Figure } from '../ui/figure';
import { saveCsv } from '../kit/download';
import { Empty, Show } from '../ui/parts';
import { kMostRows, type Cell, type Table } from '../data/source';
import { kRunColumns, kRunsFrom, meanBand } from './run_data';

const kShown = `SELECT ${kRunColumns} ${kRunsFrom} ORDER BY eea_runs.run DESC`;

const kFormats: Record<string, (cell: Cell) => string> = {
  best_score: (cell) => plain(cell as number | null, 4),
  seconds: (cell) => duration(cell as number | null),
};

/** Whether each word is in some cell, as it is shown or as it is stored. */
function hasWords(columns: string[], row: Cell[], words: string[]): boolean {
  const texts = row.flatMap((cell, i) => [cellText(cell), String(cell ?? ''), kFormats[columns[i]]?.(cell) ?? '']);
  return words.every((word) => texts.some((text) => text.toLowerCase().includes(word)));
}

/** All runs, and what experiments make of their replicates. */
export function RunsPage({ choices }: { choices: Record<string, string> }) {
  const runs = useLoaded((source) => source.query(kShown), ['runs']);
  const filter = choices.filter ?? choices.experiment ?? '';
  return (
    <Show of={runs}>
      {(table) => (table.rows.length === 0 ? <Commands /> : <Runs table={table} filter={filter} />)}
    </Show>
  );
}

function Runs({ table, filter }: { table: Table; filter: string }) {
  const names = table.columns.join();
  const accept = useCallback(
    (row: Cell[]) => hasWords(names.split(','), row, filter.toLowerCase().split(/\s+/)),
    [names, filter],
  );
  const shown = useMemo(() => table.rows.filter(accept), [table, accept]);
  const column = (name: string) => table.columns.indexOf(name);
  const experiments = [...new Set(table.rows.map((row) => row[column('experiment')] as string))].sort();
  return (
    <>
      <div class="choices wide">
        <input
          type="search"
          class="search"
          placeholder="filter: words in any column ( / )"
          aria-label="Filter runs"
          value={filter}
          onInput={(event) => refine({ filter: event.currentTarget.value, experiment: null })}
        />
        <span class="muted">
          {shown.length} of {table.rows.length} runs
        </span>
      </div>
      <Figure
        title="Runs"
        note="Click a run, or press Enter, to open it."
        downloads={[{ label: 'CSV', run: () => saveCsv(table.columns, shown, 'runs') }]}
      >
        <DataTable
          table={table}
          formats={kFormats}
          accept={accept}
          pick={(row) => {
            location.hash = linkTo('run', { run: table.rows[row][0] as number });
          }}
        />
      </Figure>
      <Replicates runs={shown.map((row) => row[column('run')] as number)} experiments={experiments} />
      <Commands />
    </>
  );
}

interface ErrorRow {
  experiment: string;
  run: number;
  pass: number;
  error: number | null;
  metric: string;
}

/** `experiments`: all that there are, so that each keeps its colour whatever is shown. */
function Replicates({ runs, experiments }: { runs: number[]; experiments: string[] }) {
  const rows = useRows<ErrorRow>(
    'SELECT experiment, run, pass, error, metric FROM error_by_pass ORDER BY experiment, run, pass',
  );
  const objective = useRows<{
    experiment: string;
    run: number;
    pass: number;
    address: string;
    error: number | null;
    unit: string;
  }>(
    `SELECT experiment, run, pass, CASE WHEN instr(address, '.') THEN replace(address, rtrim(address, replace(address, '.', '')), '') ELSE address END AS address, avg(error) AS error, unit
     FROM parameter_error_by_pass GROUP BY run, pass, 4, unit ORDER BY experiment, run, pass LIMIT ${kMostRows}`,
  );
  const wanted = new Set(runs);
  if (runs.length === 0) return <Empty>No run matches these words.</Empty>;
  return (
    <div class="two">
      <Show of={rows}>
        {(all) => {
          const own = all.filter((one) => wanted.has(one.run));
          if (own.length === 0) return <Empty>These runs have no finished pass.</Empty>;
          return (
            <>
              {[...new Set(own.map((one) => one.metric))].map((metric) => (
                <Bands
                  key={metric}
                  title={`Error by pass: ${metric.replace(/_/g, ' ')}`}
                  label="error of the best model"
                  experiments={experiments}
                  unit="1"
                  log
                  rows={own.filter((one) => one.metric === metric).map((one) => ({ ...one, value: one.error }))}
                />
              ))}
            </>
          );
        }}
      </Show>
      {objective.value &&
        [...new Set(objective.value.map((one) => `${one.address}|${one.unit}`))].map((group) => {
          const [address, unit] = group.split('|');
          const own = objective.value!.filter(
            (one) => one.address === address && one.unit === unit && wanted.has(one.run),
          );
          return (
            own.length > 0 && (
              <Bands
                key={group}
                title={`True-parameter error by pass: ${address}`}
                label={`error of ${address}`}
                experiments={experiments}
                unit={unit}
                rows={own.map((one) => ({ ...one, value: one.error }))}
              />
            )
          );
        })}
    </div>
  );
}

interface BandRow {
  experiment: string;
  run: number;
  pass: number;
  value: number | null;
}

interface BandsProps {
  title: string;
  label: string;
  unit: string;
  log?: boolean;
  experiments: string[];
  rows: BandRow[];
}

const kMostLines = 60;

/** "mean of 8 runs", or "of 2–8" where some have ended earlier than others. */
function meanOf(counts: number[]): string {
  const [least, most] = [Math.min(...counts), Math.max(...counts)];
  return `mean of ${least < most ? `${least}–${most}` : most} runs`;
}

/** An experiment's mean over its runs with the 95 % interval of the mean; single runs faint. */
function seriesOf(experiment: string, colour: Colour, own: BandRow[]): ChartSeries[] {
  const runs = [...new Set(own.map((one) => one.run))];
  const { x, mean, lower, upper, counts } = meanBand(own);
  if (runs.length < 2) return [{ name: experiment, kind: 'both', colour, x, y: mean }];
  const lines = runs.slice(0, runs.length <= kMostLines ? runs.length : 0).map((run): ChartSeries => {
    const points = own.filter((one) => one.run === run);
    return {
      name: `${experiment}, run ${run}`,
      unlisted: true,
      kind: 'line',
      colour,
      faint: true,
      x: points.map((one) => one.pass),
      y: points.map((one) => one.value ?? NaN),
    };
  });
  return [
    ...lines,
    { name: `${experiment}, 95 % interval`, unlisted: true, kind: 'band', colour, x, y: mean, lower, upper, counts },
    { name: `${experiment}, ${meanOf(counts)}`, kind: 'both', colour, x, y: mean, counts },
  ];
}

function Bands({ title, label, unit, log, experiments, rows }: BandsProps) {
  const series = experiments.flatMap((experiment, i) => {
    const own = rows.filter((one) => one.experiment === experiment);
    return own.length > 0 ? seriesOf(experiment, seriesColour(i), own) : [];
  });
  return (
    <Chart
      title={title}
      x={{ label: 'pass', unit: '1', whole: true }}
      y={{ label, unit, log, include: log ? [] : [0] }}
      series={series}
      note={
        series.some((one) => one.kind === 'band')
          ? 'Bands: 95 % intervals of the means over the runs that the filter shows.'
          : undefined
      }
    />
  );
}

/** Every command that wrote to the database. */
function Commands() {
  const commands = useLoaded(
    (source) => source.query('SELECT run, started, ending, experiment, command FROM runs ORDER BY run DESC LIMIT 1000'),
    ['commands'],
  );
  return (
    <Show of={commands}>
      {(table) => (
        <Figure
          title="Commands that wrote to this database"
          downloads={[{ label: 'CSV', run: () => saveCsv(table.columns, table.rows, 'commands') }]}
        >
          {table.rows.length === 0 ? <Empty>None.</Empty> : <DataTable table={table} wide="command" />}
        </Figure>
      )}
    </Show>
  );
}
