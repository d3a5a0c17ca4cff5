import { plain, prefixFor, unitText } from './format';

const kFewestDigits = 3;
const kMostDigits = 7;

/** Digits with which `width` shows two of its own in numbers of the size of `value`; as report/text/interval_text.cpp has it. */
function digitsFor(value: number, width: number): number {
  if (!(width > 0) || !Number.isFinite(width) || value === 0) return kFewestDigits;
  const needed = Math.floor(Math.log10(Math.abs(value))) - Math.floor(Math.log10(width)) + 2;
  return Math.min(Math.max(needed, kFewestDigits), kMostDigits);
}

const known = (one: number | null | undefined): one is number =>
  one !== null && one !== undefined && Number.isFinite(one);

/** "0.53516 [0.53504, 0.53528] kg": as many digits as the interval deserves, one unit for all three, that of the
 *  largest. `otherwise` stands in the interval's place where there is none. */
export function valueText(
  value: number | null,
  lower: number | null,
  upper: number | null,
  unit: string,
  otherwise = '',
): string {
  if (!known(value)) return '—';
  const bounded = known(lower) && known(upper);
  const digits = bounded ? digitsFor(value, upper - lower) : kFewestDigits;
  const prefix = prefixFor(Math.max(...(bounded ? [value, lower, upper] : [value]).map(Math.abs)), unit);
  const number = (one: number) => plain(one * prefix.factor, digits);
  const symbol = prefix.symbol + unitText(unit);
  const interval = bounded ? ` [${number(lower)}, ${number(upper)}]` : '';
  return `${number(value)}${interval}${symbol ? ` ${symbol}` : ''}${bounded || !otherwise ? '' : ` (${otherwise})`}`;
}
