import { useMemo } from 'preact/hooks';
import type { Cell } from '../data/source';
import { useRows } from '../data/use';
import { saveCsv } from '../kit/download';
import { plain, quantity } from '../kit/format';
import { Chart } from '../ui/chart';
import { DataTable } from '../ui/data_table';
import { Figure } from '../ui/figure';
import { Show } from '../ui/parts';
import { passAxis, type Run } from './run_data';
import { useScoreUnit } from './score_unit';

interface ForetoldRow {
  trial: number;
  surprise: number | null;
  fitted: number | null;
  passes_set_aside: number;
}

/** How far the best model so far was off a trial that was new to it, beside what it was fitted to. */
export function Foretold({ run }: { run: Run }) {
  const rows = useRows<ForetoldRow>(
    `SELECT trial, surprise, passes_set_aside,
       (SELECT error FROM error_by_pass WHERE error_by_pass.run = foretold.run AND pass = foretold.trial) AS fitted
     FROM foretold WHERE run = ? AND surprise IS NOT NULL ORDER BY trial`,
    [run.run],
  );
  const { unit } = useScoreUnit(run);
  return (
    <Show of={rows}>
      {(all) => {
        if (all.length === 0) return null;
        const aside = all.filter((one) => one.passes_set_aside > 0);
        return (
          <Chart
            title="Error on new trials"
            x={{ label: 'target trial', unit: '1', whole: true }}
            y={{ label: run.metric.replace(/_/g, ' '), unit, log: true }}
            note="Error of the best model so far, on a new trial and on the earlier trials."
            series={[
              {
                name: 'new trial',
                kind: 'both',
                colour: 'measured',
                x: all.map((one) => one.trial),
                y: all.map((one) => one.surprise ?? NaN),
              },
              {
                name: 'earlier trials',
                kind: 'both',
                colour: 'predicted',
                dashed: true,
                x: all.map((one) => one.trial),
                y: all.map((one) => one.fitted ?? NaN),
              },
              ...(aside.length > 0
                ? [
                    {
                      name: 'set aside (too difficult)',
                      kind: 'points' as const,
                      colour: 'other' as const,
                      x: aside.map((one) => one.trial),
                      y: aside.map((one) => one.surprise ?? NaN),
                    },
                  ]
                : []),
            ]}
          />
        );
      }}
    </Show>
  );
}

/** How far the models of the last generation of each pass agree. */
export function Spread({ run }: { run: Run }) {
  const rows = useRows<{ pass: number; least: number; middle: number; most: number }>(
    `WITH own AS (SELECT pass, generation, score, row_number() OVER (PARTITION BY pass ORDER BY score) AS place, count(*) OVER (PARTITION BY pass) AS all_of
       FROM model WHERE id BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 AND kind = 'full' AND score IS NOT NULL)
     SELECT (pass & 1099511627775) - 1 AS pass, min(score) AS least, max(iif(place = (all_of + 9) / 10, score, NULL)) AS middle, max(iif(place = (all_of + 1) / 2, score, NULL)) AS most
     FROM own GROUP BY pass ORDER BY pass`,
    [run.run],
  );
  const { unit } = useScoreUnit(run);
  return (
    <Show of={rows}>
      {(all) =>
        all.length < 2 ? null : (
          <Chart
            title="Spread of the models"
            x={passAxis}
            y={{ label: run.metric.replace(/_/g, ' '), unit, log: true }}
            note="All completely scored models of a pass: the best, the best 10 % and the median."
            series={[
              {
                name: 'median',
                kind: 'line',
                colour: 'floor',
                x: all.map((one) => one.pass),
                y: all.map((one) => one.most),
              },
              {
                name: 'best 10 %',
                kind: 'line',
                colour: 'other',
                x: all.map((one) => one.pass),
                y: all.map((one) => one.middle),
              },
              {
                name: 'best',
                kind: 'line',
                colour: 'predicted',
                x: all.map((one) => one.pass),
                y: all.map((one) => one.least),
              },
            ]}
          />
        )
      }
    </Show>
  );
}

interface EnsembleValue {
  pass: number;
  rank: number;
  model: number;
  structure: string;
  score: number | null;
  address: string | null;
  value: number | null;
  unit: string | null;
}

/** The models that differ, as a pass handed them on. */
export function Ensemble({ run, pass }: { run: Run; pass: string | undefined }) {
  const rows = useRows<EnsembleValue>(
    'SELECT pass, rank, model, structure, score, address, value, unit FROM ensembles WHERE run = ? ORDER BY pass, rank, position',
    [run.run],
  );
  const { unit } = useScoreUnit(run);
  return (
    <Show of={rows}>
      {(all) => {
        const passes = [...new Set(all.map((one) => one.pass))];
        const chosen = passes.includes(Number(pass)) ? Number(pass) : passes[passes.length - 1];
        return <EnsembleTable pass={chosen} values={all.filter((one) => one.pass === chosen)} errorUnit={unit} />;
      }}
    </Show>
  );
}

function EnsembleTable({ pass, values, errorUnit }: { pass: number; values: EnsembleValue[]; errorUnit: string }) {
  const { table, formats } = useMemo(() => {
    const units = new Map(values.flatMap((one) => (one.address === null ? [] : [[one.address, one.unit ?? '']])));
    const ranks = [...new Set(values.map((one) => one.rank))];
    const rows = ranks.map((rank): Cell[] => {
      const own = values.filter((one) => one.rank === rank);
      const at = (address: string) => own.find((one) => one.address === address)?.value ?? null;
      return [rank, own[0].model, own[0].structure || '—', own[0].score, ...[...units.keys()].map(at)];
    });
    const inUnit = ([address, unit]: string[]) => [address, (cell: Cell) => quantity(cell as number | null, unit)];
    return {
      table: { columns: ['rank', 'model', 'structure', 'error', ...units.keys()], rows, cut: false },
      formats: {
        error: (cell: Cell) =>
          errorUnit === '1' ? plain(cell as number | null, 4) : quantity(cell as number | null, errorUnit),
        ...Object.fromEntries([...units].map(inUnit)),
      },
    };
  }, [values, errorUnit]);
  if (table.rows.length < 2) return null;
  return (
    <Figure
      title={`Models carried over from pass ${pass}`}
      note="Order: the best model of each structure and of each restart of the search, then the best of the others. To predict a test with them: lacuna predict FILE --test ..."
      downloads={[{ label: 'CSV', run: () => saveCsv(table.columns, table.rows, `models of pass ${pass}`) }]}
    >
      <DataTable key={errorUnit} table={table} formats={formats} />
    </Figure>
  );
}
