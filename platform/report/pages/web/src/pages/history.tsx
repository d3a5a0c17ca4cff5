import { useRows } from '../data/use';
import { saveCsv } from '../kit/download';
import { quantity, times } from '../kit/format';
import { valueText } from '../kit/interval';
import { choose, linkTo } from '../kit/route';
import { Chart, type ChartSeries } from '../ui/chart';
import { Figure } from '../ui/figure';
import { Breakable, Empty, Select, Show } from '../ui/parts';

interface Row {
  experiment: string;
  revision: number;
  change: string;
  channel: string;
  unit: string;
  fit_rmse: number | null;
  held_out_rmse: number | null;
  floor: number | null;
  times_floor: number | null;
}

interface Revision {
  experiment: string;
  number: number;
  parent: number | null;
  change: string;
  effects: string | null;
  free_values: number;
}

interface Fitted {
  experiment: string;
  revision: number;
  address: string;
  value: number | null;
  unit: string;
  lower: number | null;
  upper: number | null;
  at_bound: string | null;
  identifiable: number;
}

const number = (value: number | null) => value ?? NaN;

/** How the error fell, revision by revision. */
export function HistoryPage({ choices }: { choices: Record<string, string> }) {
  const revisions = useRows<Revision>(
    'SELECT experiment, number, parent, change, effects, free_values FROM revisions ORDER BY experiment, number',
  );
  const errors = useRows<Row>('SELECT * FROM error_by_revision ORDER BY experiment, revision, channel');
  return (
    <Show of={revisions}>
      {(all) =>
        all.length === 0 ? (
          <Empty>
            The database has no revision of a model. Make the first: <code>lacuna compare FILE</code>
          </Empty>
        ) : (
          <Show of={errors}>{(rows) => <Chosen revisions={all} rows={rows} choices={choices} />}</Show>
        )
      }
    </Show>
  );
}

function Chosen({ revisions, rows, choices }: { revisions: Revision[]; rows: Row[]; choices: Record<string, string> }) {
  const experiments = [...new Set(revisions.map((one) => one.experiment))];
  const experiment = experiments.includes(choices.experiment)
    ? choices.experiment
    : experiments[experiments.length - 1];
  const own = revisions.filter((one) => one.experiment === experiment);
  const errors = rows.filter((one) => one.experiment === experiment);
  const channels = [...new Map(errors.map((one) => [one.channel, one.unit]))];
  const last = own[own.length - 1].number;
  const [a, b] = [Number(choices.a ?? own[Math.max(own.length - 2, 0)].number), Number(choices.b ?? last)];
  return (
    <>
      {experiments.length > 1 && (
        <div class="choices">
          <Select
            label="Experiment"
            value={experiment}
            options={experiments.map((one) => ({ value: one, label: one }))}
            change={(value) => choose({ experiment: value, a: null, b: null })}
          />
        </div>
      )}
      <Lead errors={errors} />
      <div class="two">
        {channels.map(([channel, unit]) => (
          <Errors
            key={channel}
            channel={channel}
            unit={unit}
            rows={errors.filter((one) => one.channel === channel)}
            revisions={own}
          />
        ))}
      </div>
      <Table revisions={own} errors={errors} experiment={experiment} a={a} b={b} />
      {own.length > 1 && <SideBySide experiment={experiment} revisions={own} errors={errors} a={a} b={b} />}
    </>
  );
}

function Lead({ errors }: { errors: Row[] }) {
  if (errors.length === 0) return <p class="lead">No revision has been compared yet.</p>;
  const first = errors[0];
  const of = first.held_out_rmse === null ? first.channel : `${first.channel}, held-out trials`;
  const last = [...errors].reverse().find((one) => one.channel === first.channel) ?? first;
  if (first === last)
    return (
      <p class="lead">
        {of}: <strong>{times(first.times_floor)}</strong> the noise floor.
      </p>
    );
  return (
    <p class="lead">
      {of}: from {times(first.times_floor)} the noise floor to <strong>{times(last.times_floor)}</strong> in{' '}
      {new Set(errors.map((one) => one.revision)).size} revisions.
    </p>
  );
}

function Errors({
  channel,
  unit,
  rows,
  revisions,
}: {
  channel: string;
  unit: string;
  rows: Row[];
  revisions: Revision[];
}) {
  const x = rows.map((one) => revisions.findIndex((revision) => revision.number === one.revision));
  const series: ChartSeries[] = [
    { name: 'fit', kind: 'both', colour: 'predicted', x, y: rows.map((one) => number(one.fit_rmse)) },
    {
      name: 'held out',
      kind: 'both',
      colour: 'held',
      dashed: true,
      x,
      y: rows.map((one) => number(one.held_out_rmse)),
    },
  ];
  const floors = rows.map((one) => number(one.floor));
  const level = rows.length === 1 && Number.isFinite(floors[0]); // one point is no line
  if (!level) series.push({ name: 'noise floor', kind: 'line', colour: 'floor', dashed: true, x, y: floors });
  const kept = series.filter((one) => one.y.some(Number.isFinite));
  return (
    <Chart
      title={`RMSE of ${channel}`}
      x={{ label: 'revision', unit: '1', whole: true, names: revisions.map((one) => String(one.number)) }}
      y={{ label: 'RMSE', unit, log: true }}
      series={kept}
      levels={level ? [{ name: 'noise floor', at: floors[0], colour: 'floor' }] : []}
      pick={(_, i) => choose({ revision: rows[i].revision, a: null, b: rows[i].revision })}
    />
  );
}

function saveRevisions(revisions: Revision[], errors: Row[]): void {
  saveCsv(
    [
      'revision',
      'parent',
      'change',
      'effects',
      'free_values',
      'channel',
      'unit',
      'fit_rmse',
      'held_out_rmse',
      'floor',
      'times_floor',
    ],
    revisions.flatMap((one) => {
      const own = errors.filter((row) => row.revision === one.number);
      const first = [one.number, one.parent, one.change, one.effects, one.free_values];
      return own.length === 0
        ? [first]
        : own.map((row) => [
            ...first,
            row.channel,
            row.unit,
            row.fit_rmse,
            row.held_out_rmse,
            row.floor,
            row.times_floor,
          ]);
    }),
    'revisions',
  );
}

function Table({
  revisions,
  errors,
  experiment,
  a,
  b,
}: {
  revisions: Revision[];
  errors: Row[];
  experiment: string;
  a: number;
  b: number;
}) {
  return (
    <Figure
      title="Revisions"
      downloads={[{ label: 'CSV', run: () => saveRevisions(revisions, errors) }]}
      note="Changes from the parent. Click a number to see its curves. Choose two revisions, a and b, to compare them."
    >
      <div class="scrolls">
        <table class="grid">
          <thead>
            <tr>
              <th>a</th>
              <th>b</th>
              <th>revision</th>
              <th>change</th>
              <th>× floor</th>
              <th>parent</th>
            </tr>
          </thead>
          <tbody>
            {revisions.map((one) => (
              <tr key={one.number}>
                <td>
                  <input
                    type="radio"
                    name="a"
                    aria-label={`a: revision ${one.number}`}
                    checked={a === one.number}
                    onChange={() => choose({ a: one.number })}
                  />
                </td>
                <td>
                  <input
                    type="radio"
                    name="b"
                    aria-label={`b: revision ${one.number}`}
                    checked={b === one.number}
                    onChange={() => choose({ b: one.number })}
                  />
                </td>
                <th scope="row">
                  <a href={linkTo('compare', { experiment, revision: one.number })} title="Show its curves">
                    {one.number}
                  </a>
                </th>
                <td class="wraps">
                  <strong>
                    <Breakable>{one.change}</Breakable>
                  </strong>
                  <span class="small">
                    {one.effects ?? 'no effects'} · {one.free_values} free values
                  </span>
                </td>
                <td class="wraps">
                  {errors
                    .filter((row) => row.revision === one.number)
                    .map((row) => `${row.channel} ${times(row.times_floor)}${row.held_out_rmse === null ? '' : ' (held out)'}`)
                    .join(', ') || '—'}
                </td>
                <td class="muted">{one.parent ?? ''}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Figure>
  );
}

const interval = (one: Fitted | undefined) => {
  if (!one) return '—';
  const otherwise = one.at_bound ? `at its ${one.at_bound} bound` : one.identifiable ? '' : 'not determined';
  return otherwise
    ? valueText(one.value, null, null, one.unit, otherwise)
    : valueText(one.value, one.lower, one.upper, one.unit);
};

function SideBySide({
  experiment,
  revisions,
  errors,
  a,
  b,
}: {
  experiment: string;
  revisions: Revision[];
  errors: Row[];
  a: number;
  b: number;
}) {
  const values = useRows<Fitted>(
    'SELECT experiment, revision, address, value, unit, lower, upper, at_bound, identifiable FROM fitted_parameters WHERE experiment = ? AND revision IN (?, ?) ORDER BY position',
    [experiment, a, b],
  );
  const name = (wanted: number) => `${wanted} · ${revisions.find((one) => one.number === wanted)?.change ?? ''}`;
  const channels = [...new Map(errors.map((one) => [one.channel, one.unit]))];
  const error = (revision: number, channel: string, unit: string) => {
    const row = errors.find((one) => one.revision === revision && one.channel === channel);
    return row
      ? `fit ${quantity(row.fit_rmse, unit)}, held out ${quantity(row.held_out_rmse, unit)}, ${times(row.times_floor)}`
      : '—';
  };
  return (
    <Figure
      title="Side by side"
      downloads={[
        {
          label: 'CSV',
          run: () =>
            saveCsv(
              ['revision', 'address', 'value', 'unit', 'lower', 'upper', 'at_bound'],
              (values.value ?? []).map((one) => [
                one.revision,
                one.address,
                one.value,
                one.unit,
                one.lower,
                one.upper,
                one.at_bound,
              ]),
              `revisions ${a} and ${b}`,
            ),
        },
      ]}
    >
      <Show of={values}>
        {(all) => (
          <div class="scrolls">
            <table class="grid side-by-side">
              <thead>
                <tr>
                  <th />
                  <th>
                    <Breakable>{name(a)}</Breakable>
                  </th>
                  <th>
                    <Breakable>{name(b)}</Breakable>
                  </th>
                </tr>
              </thead>
              <tbody>
                {channels.map(([channel, unit]) => (
                  <tr key={channel}>
                    <th scope="row">
                      {channel} <span class="muted">RMSE, × floor</span>
                    </th>
                    <td>{error(a, channel, unit)}</td>
                    <td>{error(b, channel, unit)}</td>
                  </tr>
                ))}
                {[...new Set(all.map((one) => one.address))].map((address) => {
                  const at = (revision: number) =>
                    all.find((one) => one.revision === revision && one.address === address);
                  return (
                    <tr key={address}>
                      <th scope="row">
                        <Breakable>{address}</Breakable>
                      </th>
                      <td>{interval(at(a))}</td>
                      <td>{interval(at(b))}</td>
                    </tr>
                  );
                })}
              </tbody>
            </table>
          </div>
        )}
      </Show>
    </Figure>
  );
}
