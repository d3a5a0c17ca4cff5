import { saveCsv } from '../kit/download';
import { plain, times } from '../kit/format';
import type { Finding, RegimeRow } from '../pages/compare_data';
import { Figure } from './figure';

interface Props {
  regimes: RegimeRow[];
  chosen: Finding | undefined;
  choose: (key: string | null) => void;
}

const percent = (share: number) => `${plain(100 * share, 2)} %`;
const kOf: Record<string, string> = { acceleration: 'squared residual acceleration' };

/** Error by regime: how much of it is in how many samples. */
export function RegimeTable({ regimes, chosen, choose }: Props) {
  if (regimes.length === 0) return null;
  const keep = () =>
    saveCsv(
      ['of', 'regime', 'share_of_error', 'share_of_samples', 'times_floor'],
      regimes.map((one) => [one.view, one.sentence, one.share, one.share_of_samples, one.times_floor]),
      'errors by regime',
    );
  return (
    <Figure
      title="Error by regime"
      downloads={[{ label: 'CSV', run: keep }]}
      note="On the fit trials. Regime: the samples in which one quantity, or several, are in a range, such as |velocity| < 50 mrad/s. Load: force or torque of actuators, springs and dampers on the joint, in the model. Accumulated work: integral of |load × velocity| over time. Click a regime to show the trial with most of its samples; they are highlighted."
    >
      <div class="scrolls">
        <table class="grid regimes">
          <thead>
            <tr>
              <th scope="col">regime</th>
              <th scope="col">quantity</th>
              <th scope="col" class="number">
                share of quantity
              </th>
              <th scope="col" class="number">
                share of samples
              </th>
              <th scope="col" class="number">
                × floor
              </th>
            </tr>
          </thead>
          <tbody>
            {regimes.map((one) => (
              <tr key={one.key} class={one === chosen ? 'chosen' : ''}>
                <th scope="row">
                  {one.stretches ? (
                    <button class="link" onClick={() => choose(one === chosen ? null : one.key)}>
                      {one.sentence}
                    </button>
                  ) : (
                    one.sentence
                  )}
                </th>
                <td class="muted">{kOf[one.view] ?? 'squared error'}</td>
                <td class="number">{percent(one.share)}</td>
                <td class="number">{percent(one.share_of_samples)}</td>
                <td class="number">{times(one.times_floor)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Figure>
  );
}
