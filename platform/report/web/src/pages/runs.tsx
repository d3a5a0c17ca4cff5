import { useCallback, useMemo, useState } from 'preact/hooks';
import { useLoaded, useRows } from '../data/use';
import { duration, plain } from '../kit/format';
import { linkTo } from '../kit/route';
import { Chart, type ChartSeries } from '../ui/chart';
import { seriesColour } from '../kit/colours';
import { DataTable } from '../ui/data_table';
import { Figure } from '../ui/figure';
import { saveCsv } from '../kit/download';
import { Empty, Show } from '../ui/parts';
import { kMostRows, type Cell, type Table } from '../data/source';
import { kRunColumns, kRunsFrom, meanBand } from './run_data';

const kShown = `SELECT ${kRunColumns} ${kRunsFrom} ORDER BY eea_runs.run DESC`;

/** All runs, and what experiments make of their replicates. */
export function RunsPage({ choices }: { choices: Record<string, string> }) {
  const runs = useLoaded((source) => source.query(kShown), ['runs']);
  const [filter, setFilter] = useState(choices.experiment ?? '');
  const accept = useCallback(
    (row: Cell[]) =>
      filter === '' ||
      filter
        .toLowerCase()
        .split(/\s+/)
        .every((word) =>
          row.some((cell) =>
            String(cell ?? '')
              .toLowerCase()
              .includes(word),
          ),
        ),
    [filter],
  );
  return (
    <Show of={runs}>
      {(table) =>
        table.rows.length === 0 ? (
          <Commands />
        ) : (
          <Runs table={table} filter={filter} setFilter={setFilter} accept={accept} />
        )
      }
    </Show>
  );
}

function Runs({
  table,
  filter,
  setFilter,
  accept,
}: {
  table: Table;
  filter: string;
  setFilter: (text: string) => void;
  accept: (row: Cell[]) => boolean;
}) {
  const shown = useMemo(() => table.rows.filter(accept), [table, accept]);
  const formats = {
    best_score: (cell: Cell) => plain(cell as number | null, 4),
    seconds: (cell: Cell) => duration(cell as number | null),
  };
  return (
    <>
      <div class="choices wide">
        <input
          type="search"
          class="search"
          placeholder="filter: words of any column ( / )"
          aria-label="Filter runs"
          value={filter}
          onInput={(event) => setFilter(event.currentTarget.value)}
        />
        <span class="muted">
          {shown.length} of {table.rows.length} runs
        </span>
      </div>
      <Figure
        title="Runs"
        note="A click opens a run."
        downloads={[{ label: 'CSV', run: () => saveCsv(table.columns, shown, 'runs') }]}
      >
        <DataTable
          table={table}
          formats={formats}
          accept={accept}
          pick={(row) => {
            location.hash = linkTo('run', { run: table.rows[row][0] as number });
          }}
        />
      </Figure>
      <Replicates runs={shown.map((row) => row[0] as number)} />
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

function Replicates({ runs }: { runs: number[] }) {
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
  return (
    <div class="two">
      <Show of={rows}>
        {(all) => {
          const own = all.filter((one) => wanted.has(one.run));
          if (own.length === 0) return <Empty>No pass has ended.</Empty>;
          return (
            <>
              {[...new Set(own.map((one) => one.metric))].map((metric) => (
                <Bands
                  key={metric}
                  title={`Error by pass: ${metric.replace(/_/g, ' ')}`}
                  label="error of the best model"
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
                title={`Objective error by pass: ${address}`}
                label={`error of ${address}`}
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

/** Each experiment's mean over its runs with the 95 % interval of the mean; single runs faint. */
function Bands({
  title,
  label,
  unit,
  log,
  rows,
}: {
  title: string;
  label: string;
  unit: string;
  log?: boolean;
  rows: BandRow[];
}) {
  const series = [...new Set(rows.map((one) => one.experiment))].flatMap((experiment, i): ChartSeries[] => {
    const own = rows.filter((one) => one.experiment === experiment);
    const runs = [...new Set(own.map((one) => one.run))];
    const band = meanBand(own);
    const positive = (values: number[]) => (log ? values.map((one) => (one > 0 ? one : NaN)) : values);
    return [
      ...(runs.length > 1 && runs.length <= 60
        ? runs.map((run): ChartSeries => ({
            name: '',
            kind: 'line',
            colour: seriesColour(i),
            faint: true,
            x: own.filter((one) => one.run === run).map((one) => one.pass),
            y: own.filter((one) => one.run === run).map((one) => one.value ?? NaN),
          }))
        : []),
      ...(runs.length > 1
        ? [
            {
              name: '',
              kind: 'band' as const,
              colour: seriesColour(i),
              x: band.x,
              y: band.mean,
              lower: positive(band.lower),
              upper: positive(band.upper),
            },
          ]
        : []),
      {
        name: `${experiment}${runs.length > 1 ? `, mean of ${runs.length} runs` : ''}`,
        kind: 'both',
        colour: seriesColour(i),
        x: band.x,
        y: band.mean,
      },
    ];
  });
  return (
    <Chart
      title={title}
      x={{ label: 'pass', unit: '1', whole: true }}
      y={{ label, unit, log, include: log ? [] : [0] }}
      series={series}
      note="Bands: 95 % intervals of the means over the runs that the filter shows."
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
          {table.rows.length === 0 ? <Empty>None.</Empty> : <DataTable table={table} />}
        </Figure>
      )}
    </Show>
  );
}
