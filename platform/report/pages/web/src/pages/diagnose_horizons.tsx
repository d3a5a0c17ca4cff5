import { saveCsv } from '../kit/download';
import { errorChange, quantity } from '../kit/format';
import { Figure } from '../ui/figure';
import type { HorizonError } from './diagnose_data';

/** How the answer changes the error of predictions, from a few readings to the longest horizon. */
export function Horizons({ errors }: { errors: HorizonError[] }) {
  const heldOut = errors.some((one) => one.base_held_out !== null);
  const hasAnswer = errors.some((one) => one.answer !== one.base);
  const cell = (base: number | null, answer: number | null, unit: string) =>
    hasAnswer ? change(base, answer, unit) : quantity(base, unit);
  return (
    <Figure
      title="Prediction error by horizon"
      downloads={[{ label: 'CSV', run: () => saveErrors(errors) }]}
      note={`RMS error${hasAnswer ? ' without → with the answer, the candidate that the verdict names' : ''}. Each prediction starts from a measured state; the error that the uncertainty of this state causes is removed. Floor: noise of a reading.`}
    >
      <div class="scrolls">
        <table class="grid">
          <thead>
            <tr>
              <th scope="col">channel</th>
              <th scope="col" class="number">
                horizon
              </th>
              <th scope="col" class="number">
                fit
              </th>
              {heldOut && (
                <th scope="col" class="number">
                  held out
                </th>
              )}
              <th scope="col" class="number">
                floor
              </th>
            </tr>
          </thead>
          <tbody>
            {errors.map((one) => (
              <tr key={one.channel + one.horizon_s}>
                <td>{one.channel}</td>
                <td class="number">{quantity(one.horizon_s, 's')}</td>
                <td class="number">{cell(one.base, one.answer, one.unit)}</td>
                {heldOut && <td class="number">{cell(one.base_held_out, one.answer_held_out, one.unit)}</td>}
                <td class="number">{quantity(one.floor, one.unit)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Figure>
  );
}

function change(base: number | null, answer: number | null, unit: string): string {
  if (base === null || answer === null) return '–';
  return `${quantity(base, unit)} → ${quantity(answer, unit)} (${errorChange(answer, base)})`;
}

const saveErrors = (errors: HorizonError[]) =>
  saveCsv(
    ['channel', 'horizon_s', 'unit', 'base', 'answer', 'base_held_out', 'answer_held_out', 'floor'],
    errors.map((one) => [
      one.channel,
      one.horizon_s,
      one.unit,
      one.base,
      one.answer,
      one.base_held_out,
      one.answer_held_out,
      one.floor,
    ]),
    'horizons',
  );
