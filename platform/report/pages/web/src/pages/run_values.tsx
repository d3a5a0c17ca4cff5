import { objects } from '../data/source';
import { useLoaded, useRows } from '../data/use';
import { saveCsv } from '../kit/download';
import { quantity } from '../kit/format';
import { choose, notHere } from '../kit/route';
import { Figure } from '../ui/figure';
import { ParameterChart, type BestValue } from '../ui/parameter_chart';
import { Breakable, Empty, Select, Show } from '../ui/parts';
import { kindOf, spreadOf, type Run, type Spread } from './run_data';

/** Genomes of the last generation of each pass, where a gene is a free value. */
function useSpread(run: Run): Map<string, Spread[]> | undefined {
  return useLoaded(
    async (source) => {
      const genes = await source.query('SELECT model_genes FROM eea_run WHERE run = ?', [run.run]);
      const free = await source.query('SELECT address FROM free_value WHERE run = ? ORDER BY position', [run.run]);
      const addresses = free.rows.map(([address]) => address as string);
      if (run.selected === 1 || genes.rows[0][0] !== JSON.stringify(addresses)) return new Map<string, Spread[]>();
      const rows = objects<{ pass: number; genome: Uint8Array }>(
        await source.query(
          `WITH last AS (SELECT pass, max(generation) AS generation FROM model
             WHERE id BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 GROUP BY pass)
           SELECT (model.pass & 1099511627775) - 1 AS pass, genome FROM model JOIN last USING (pass, generation)
           WHERE model.id BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 AND kind = 'full'`,
          [run.run],
        ),
      );
      return spreadOf(rows, addresses);
    },
    ['spread', run.run, run.passes_done, run.selected],
  ).value;
}

const groupOf = (one: BestValue) => `${kindOf(one.address)}|${one.unit}`;

/** The values of the best model of a pass, as pictures and as a table. */
export function Best({ run, pass }: { run: Run; pass: string | undefined }) {
  const spread = useSpread(run);
  const rows = useRows<BestValue>(
    'SELECT pass, model, position, address, value, unit, truth, lower, upper FROM best_model WHERE run = ? ORDER BY position, pass',
    [run.run],
  );
  return (
    <Show of={rows}>
      {(all) => {
        if (all.length === 0) return <Empty>No finished pass yet.</Empty>;
        const passes = [...new Set(all.map((one) => one.pass))].sort((a, b) => a - b);
        const chosen = passes.includes(Number(pass)) ? Number(pass) : passes[passes.length - 1];
        const values = all.filter((one) => one.pass === chosen);
        const missing = notHere('pass', pass, passes);
        return (
          <>
            <div class="choices">
              <Select
                label="Best model of pass"
                value={String(chosen)}
                options={passes.map((one) => ({ value: String(one), label: String(one) }))}
                change={(value) => choose({ run: run.run, pass: value })}
              />
              <span class="muted">
                model {values[0].model}
                {missing !== null && ` (${missing.replace(/\.$/, '')})`}
              </span>
            </div>
            <div class="two">
              {[...new Set(values.map(groupOf))].map((group) => (
                <ParameterChart
                  key={group}
                  rows={all.filter((one) => groupOf(one) === group)}
                  pass={chosen}
                  spread={spread}
                />
              ))}
            </div>
            <Values values={values} pass={chosen} spread={spread} />
          </>
        );
      }}
    </Show>
  );
}

function Values({
  values,
  pass,
  spread,
}: {
  values: BestValue[];
  pass: number;
  spread: Map<string, Spread[]> | undefined;
}) {
  const spreadAt = (address: string) => spread?.get(address)?.find((one) => one.pass === pass);
  const isKnown = values.some((one) => one.truth !== null);
  const isSpread = values.some((one) => spreadAt(one.address) !== undefined);
  const keep = () =>
    saveCsv(
      ['address', 'unit', 'value', 'truth', 'spread_lower', 'spread_upper', 'lower', 'upper'],
      values.map((one) => [
        one.address,
        one.unit,
        one.value,
        one.truth,
        spreadAt(one.address)?.lower,
        spreadAt(one.address)?.upper,
        one.lower,
        one.upper,
      ]),
      `values of pass ${pass}`,
    );
  const range = (lower: number, upper: number, unit: string) => `${quantity(lower, unit)} … ${quantity(upper, unit)}`;
  return (
    <Figure
      title={`Values of the best model of pass ${pass}`}
      downloads={[{ label: 'CSV', run: keep }]}
      note={isSpread ? 'Spread: range of 80 % of the models of the last generation.' : undefined}
    >
      <div class="scrolls">
        <table class="grid">
          <thead>
            <tr>
              <th>address</th>
              <th class="number">value</th>
              {isKnown && <th class="number">truth</th>}
              {isKnown && <th class="number">off by</th>}
              {isSpread && <th class="number">spread</th>}
              <th class="number">bounds</th>
            </tr>
          </thead>
          <tbody>
            {values.map((one) => {
              const own = spreadAt(one.address);
              return (
                <tr key={one.address}>
                  <th scope="row">
                    <Breakable>{one.address}</Breakable>
                  </th>
                  <td class="number">{quantity(one.value, one.unit)}</td>
                  {isKnown && <td class="number">{quantity(one.truth, one.unit)}</td>}
                  {isKnown && (
                    <td class="number">
                      {one.truth === null || one.value === null ? '—' : quantity(one.value - one.truth, one.unit)}
                    </td>
                  )}
                  {isSpread && <td class="number">{own ? range(own.lower, own.upper, one.unit) : '—'}</td>}
                  <td class="number muted">{range(one.lower, one.upper, one.unit)}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </Figure>
  );
}
