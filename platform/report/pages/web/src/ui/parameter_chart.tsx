import { kindOf, type Spread } from '../pages/run_data';
import { Chart, type ChartSeries } from './chart';

export interface BestValue {
  pass: number;
  model: number;
  position: number;
  address: string;
  value: number | null;
  unit: string;
  truth: number | null;
  lower: number;
  upper: number;
}

interface Props {
  /** Of one kind and unit, over all passes. */
  rows: BestValue[];
  pass: number;
  /** By address. */
  spread: Map<string, Spread[]> | undefined;
}

/** What tells an address from the others: without the first word and the kind that all have. */
function shortNames(addresses: string[]): string[] {
  const words = addresses.map((one) => one.split('.').slice(1, -1).join('.') || one);
  return new Set(words).size === addresses.length ? words : addresses;
}

/** Every value with its name; the spread is that of the last generation of its pass. */
function csvOf({ rows, spread }: Props) {
  return {
    columns: ['address', 'unit', 'pass', 'value', 'truth', 'spread_lower', 'spread_median', 'spread_upper'],
    rows: rows.map((one) => {
      const own = spread?.get(one.address)?.find((at) => at.pass === one.pass);
      return [one.address, one.unit, one.pass, one.value, one.truth, own?.lower, own?.middle, own?.upper];
    }),
  };
}

/** Values on their way to the truth, where one is known: faint those of earlier passes, strong the chosen one's. */
export function ParameterChart(props: Props) {
  const { rows, pass, spread } = props;
  const addresses = [...new Set(rows.map((one) => one.address))];
  const place = (address: string) => addresses.indexOf(address);
  const earlier = rows.filter((one) => one.pass < pass),
    chosen = rows.filter((one) => one.pass === pass);
  const truth = chosen.filter((one) => one.truth !== null);
  const spreads = addresses.map((address) => spread?.get(address)?.find((one) => one.pass === pass));
  const kind = kindOf(addresses[0]);
  const series: ChartSeries[] = [
    {
      name: 'earlier passes',
      kind: 'points',
      colour: 'floor',
      faint: true,
      x: earlier.map((one) => place(one.address) - 0.3 + (0.6 * one.pass) / Math.max(pass, 1)),
      y: earlier.map((one) => one.value ?? NaN),
    },
    {
      name: `pass ${pass}`,
      kind: 'points',
      colour: 'predicted',
      x: chosen.map((one) => place(one.address) + 0.3),
      y: chosen.map((one) => one.value ?? NaN),
    },
    {
      name: 'truth',
      kind: 'points',
      colour: 'truth',
      x: truth.map((one) => place(one.address)),
      y: truth.map((one) => one.truth ?? NaN),
    },
    {
      name: 'median and 80 % range of the last generation',
      kind: 'points',
      colour: 'other',
      x: addresses.map((one) => place(one) + 0.4),
      y: spreads.map((one) => one?.middle ?? NaN),
      lower: spreads.map((one) => one?.lower ?? NaN),
      upper: spreads.map((one) => one?.upper ?? NaN),
    },
  ];
  return (
    <Chart
      title={`${truth.length > 0 ? 'Parameters and hidden values' : 'Parameters by pass'}: ${kind}`}
      height={280}
      x={{ label: '', unit: '1', whole: true, names: shortNames(addresses) }}
      y={{ label: kind, unit: rows[0].unit, include: rows.flatMap((one) => [one.lower, one.upper]) }}
      note="Small marks: best models of earlier passes, from left to right."
      series={series}
      csv={csvOf(props)}
    />
  );
}
