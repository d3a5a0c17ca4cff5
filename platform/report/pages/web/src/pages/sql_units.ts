import type { Table } from '../data/source';

/** Of columns that schema/database.md gives one unit wherever a view has them. */
const kUnits: Record<string, string> = {
  time: 's',
  duration: 's',
  seconds: 's',
  max_error_time: 's',
  times_floor: '× floor',
  base_times_floor: '× floor',
  gain: 'nats',
  gain_lower: 'nats',
  gain_upper: 'nats',
};

/** Of columns whose unit stands in column `unit` beside them. */
const kBesideUnit = [
  'rmse',
  'fit_rmse',
  'held_out_rmse',
  'floor',
  'max_error',
  'sensor',
  'input',
  'process',
  'value',
  'standard_error',
  'lower',
  'upper',
  'start',
  'truth',
];

/** The unit of a result's column as far as its name tells it, else "1". */
export function unitOf(table: Table, column: number): string {
  const name = table.columns[column];
  if (kUnits[name]) return kUnits[name];
  const unit = table.columns.indexOf('unit');
  if (unit < 0 || !kBesideUnit.includes(name)) return '1';
  const units = new Set(table.rows.map((row) => row[unit]));
  const [only] = units;
  return units.size === 1 && typeof only === 'string' ? only : '1';
}
