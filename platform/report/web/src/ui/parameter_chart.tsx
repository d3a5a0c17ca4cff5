import { Chart } from './chart';

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

/** Values on their way to the truth: faint those of earlier passes, strong the chosen one's. */
export function ParameterChart({ unit, rows, pass }: { unit: string; rows: BestValue[]; pass: number }) {
  const addresses = [...new Set(rows.map((one) => one.address))];
  const place = (address: string) => addresses.indexOf(address);
  const short = addresses.map((one) => one.replace(/^(body|sensor|joint|actuator|effect)\./, '').replace(/\.(mass|delay)$/, '').replace(/front/, 'f').replace(/back|rear|hind/, 'b').replace(/_left/, 'l').replace(/_right/, 'r').replace(/_upper/, ' u').replace(/_lower/, ' l').slice(0, 8));
  const chosen = rows.filter((one) => one.pass === pass);
  const truth = chosen.filter((one) => one.truth !== null);
  const kind = /\.(\w+)$/.exec(addresses[0])?.[1] ?? 'value';
  return (
    <Chart title={`Parameters towards the truth: ${kind}`} height={280}
      x={{ label: '', unit: '1', whole: true, names: short }} y={{ label: kind, unit, include: [rows[0].lower, rows[0].upper] }}
      note="Small: the best models of earlier passes, in their order from left to right."
      series={[
        { name: 'earlier passes', kind: 'points', colour: 'floor', faint: true, x: rows.map((one) => place(one.address) - 0.3 + (0.6 * one.pass) / Math.max(pass, 1)).filter((_, i) => rows[i].pass < pass), y: rows.filter((one) => one.pass < pass).map((one) => one.value ?? NaN) },
        { name: `pass ${pass}`, kind: 'points', colour: 'predicted', x: chosen.map((one) => place(one.address) + 0.3), y: chosen.map((one) => one.value ?? NaN) },
        ...(truth.length > 0 ? [{ name: 'truth', kind: 'points' as const, colour: 'truth' as const, x: truth.map((one) => place(one.address)), y: truth.map((one) => one.truth ?? NaN) }] : []),
      ]} />
  );
}
