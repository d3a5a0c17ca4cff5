// Numbers and units as the program prints them (foundation/unit.cpp).
import type { Size } from '../data/source';

const kSuperscripts: Record<string, string> = { '2': '²', '3': '³', '4': '⁴', '-': '⁻', '1': '¹' };

/** "N*m*s/rad" as "N·m·s/rad". */
export function unitText(unit: string): string {
  if (unit === '1') return '';
  return unit
    .replace(/\*/g, '·')
    .replace(/\^(-?\d)/g, (_, digits: string) => [...digits].map((digit) => kSuperscripts[digit] ?? digit).join(''));
}

/** A force on a slider is a torque on a hinge (report/text/diagnosis_text.cpp). */
export const forceWord = (unit: string) => (/^N\*m/.test(unit) ? 'torque' : 'force');

// The first factor takes the prefix, if it may have one and is no power.
const takesPrefix = (unit: string) => /^(rad|Pa|Hz|Ohm|g|m|s|A|N|V|W|J)(?![A-Za-z0-9^])/.test(unit);

function digitsOf(value: number, digits: number): string {
  const magnitude = Math.abs(value);
  if (magnitude === 0) return '0';
  const before = Math.floor(Math.log10(magnitude)) + 1;
  if (before > digits + 3 || before < -3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    return minus(`${mantissa}·10${[...String(Number(exponent))].map((c) => kSuperscriptDigits[c]).join('')}`);
  }
  return minus(value.toFixed(Math.max(digits - before, 0)));
}

const kSuperscriptDigits: Record<string, string> = {
  '0': '⁰',
  '1': '¹',
  '2': '²',
  '3': '³',
  '4': '⁴',
  '5': '⁵',
  '6': '⁶',
  '7': '⁷',
  '8': '⁸',
  '9': '⁹',
  '-': '⁻',
};

const minus = (text: string) => text.replace(/^-/, '−');

export interface Prefix {
  factor: number;
  symbol: string;
}

/** The prefix that suits a value of that size. */
export function prefixFor(magnitude: number, unit: string): Prefix {
  if (!takesPrefix(unit) || magnitude === 0 || !Number.isFinite(magnitude)) return { factor: 1, symbol: '' };
  if (magnitude < 1e-6) return { factor: 1e9, symbol: 'n' };
  if (magnitude < 1e-3) return { factor: 1e6, symbol: 'µ' };
  if (magnitude < 0.1) return { factor: 1e3, symbol: 'm' };
  if (magnitude >= 1e4) return { factor: 1e-3, symbol: 'k' };
  return { factor: 1, symbol: '' };
}

/** "15.8 mrad"; what is not known is an em dash. */
export function quantity(value: number | null | undefined, unit: string, digits = 3): string {
  if (value === null || value === undefined || Number.isNaN(value)) return '—';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  const prefix = prefixFor(Math.abs(value), unit);
  const symbol = prefix.symbol + unitText(unit);
  return digitsOf(value * prefix.factor, digits) + (symbol ? ` ${symbol}` : '');
}

export const plain = (value: number | null | undefined, digits = 3) => quantity(value, '1', digits);

/** Two digits, rounded down, and at most 0.99 (foundation/text/figure_text.cpp). */
export function probabilityText(value: number): string {
  const shown = Math.min(0.99, Math.floor(100 * value + 1e-9) / 100);
  return shown < 0.01 ? '< 0.01' : shown.toFixed(2);
}

/** By how much an error differs from an earlier one, "−87 %" (foundation/text/figure_text.cpp). */
export function errorChange(now: number | null | undefined, then: number | null | undefined): string {
  if (!Number.isFinite(now) || !Number.isFinite(then) || !(then! > 0)) return '–';
  const ratio = Math.max(now! / then!, 1e-4);
  const percent = Math.abs(100 * (ratio - 1));
  const size = `${percent.toFixed(ratio < 0.01 ? 2 : ratio < 0.1 || percent < 10 ? 1 : 0)} %`;
  return size === '0.0 %' ? size : (ratio < 1 ? '−' : '+') + size;
}

/** "13.6 ×"; of the noise floor. */
export const times = (value: number | null | undefined) =>
  value === null || value === undefined ? '—' : `${value < 10 ? value.toFixed(2) : digitsOf(value, 3)} ×`;

export const count = (value: number) =>
  Math.round(value)
    .toString()
    .replace(/\B(?=(\d{3})+(?!\d))/g, ' ');

/** "1 h 05 min", "4.2 s". */
export function duration(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return '—';
  if (seconds < 60) return `${seconds < 10 ? seconds.toFixed(1) : Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 60) return `${minutes} min`;
  return `${Math.floor(minutes / 60)} h ${String(minutes % 60).padStart(2, '0')} min`;
}

/** A cell of any query: every digit that matters, bytes by their number. */
export function cellText(cell: unknown): string {
  if (cell === null || cell === undefined) return '';
  if (cell instanceof Uint8Array) return `${count(cell.length)} bytes`;
  if (typeof cell === 'object') return `${count((cell as Size).bytes)} bytes`;
  if (typeof cell === 'number') return Number.isInteger(cell) ? String(cell) : String(Number(cell.toPrecision(8)));
  return String(cell);
}

/** Numbers of a logarithmic axis: one digit each, or as those of a linear one where that does not tell them. */
export function logTickTexts(ticks: number[], factor = 1): string[] {
  const isOneDigit = (tick: number) => Math.abs(Number(tick.toPrecision(1)) / tick - 1) < 1e-9;
  return ticks.every(isOneDigit) ? ticks.map((tick) => plain(tick * factor, 1)) : tickTexts(ticks, factor);
}

/** Numbers of an axis: as many decimals as their step needs, the same for all. */
export function tickTexts(ticks: (number | null)[], factor = 1): string[] {
  const known = ticks.filter((one): one is number => one !== null).map((one) => one * factor);
  const most = Math.max(...known.map(Math.abs), 0);
  const step = known.length > 1 ? Math.min(...known.slice(1).map((one, i) => Math.abs(one - known[i]))) : most;
  if (most >= 1e6 || (most > 0 && most < 1e-4)) return ticks.map((one) => (one === null ? '' : plain(one * factor, 2)));
  let decimals = 0;
  while (
    step > 0 &&
    decimals < 8 &&
    Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6 * step * 10 ** decimals
  )
    ++decimals;
  return ticks.map((one) => (one === null ? '' : minus((one * factor).toFixed(decimals).replace(/^-(0\.?0*)$/, '$1'))));
}
