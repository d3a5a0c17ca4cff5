import { quantity, times } from '../kit/format';
import { setupText, type Score, type TrialSetup } from '../pages/compare_data';
import { saveCsv } from '../kit/download';
import { Figure } from './figure';

interface Props {
  scores: Score[];
  setups: TrialSetup[];
  trial: string;
  choose: (trial: string) => void;
  /** Leads to the largest error of a score. */
  linkOf: (score: Score) => string;
}

/** How strongly a cell is shaded: nothing at the floor, all at 30 floors. */
const shade = (timesFloor: number | null) => {
  if (timesFloor === null || timesFloor <= 1.2) return 0;
  return Math.min(5, Math.ceil((5 * Math.log(timesFloor / 1.2)) / Math.log(25)));
};

/** Error by trial and channel, in multiples of the noise floor. */
export function ErrorTable({ scores, setups, trial, choose, linkOf }: Props) {
  const trials = [...new Set(scores.map((one) => one.trial))];
  const channels = [...new Map(scores.map((one) => [one.channel, one.unit])).keys()];
  const at = (name: string, channel: string) => scores.find((one) => one.trial === name && one.channel === channel);
  const setupOf = (name: string) => setupText(setups, scores.find((one) => one.trial === name)!.comparison, name);
  const columns = [
    'trial',
    'held_out',
    'channel',
    'unit',
    'rmse',
    'floor',
    'times_floor',
    'max_error',
    'max_error_time',
  ] as const;
  const keep = () =>
    saveCsv(
      [...columns, 'setup'],
      scores.map((one) => [...columns.map((column) => one[column]), setupOf(one.trial) ?? '']),
      'errors by trial and channel',
    );
  return (
    <Figure
      title="Error by trial and channel"
      note="First line: multiple of the noise floor, and RMSE of the simulation of the whole trial from its initial state (free run). Second line: largest error and its time. Darker means larger."
      downloads={[{ label: 'CSV', run: keep }]}
    >
      <div class="scrolls">
        <table class="grid errors">
          <thead>
            <tr>
              <th scope="col">trial</th>
              {channels.map((one) => (
                <th key={one} scope="col">
                  {one}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {trials.map((name) => (
              <tr key={name} class={name === trial ? 'chosen' : ''}>
                <th scope="row">
                  <button class="link" onClick={() => choose(name)}>
                    {name}
                  </button>
                  {scores.some((one) => one.trial === name && one.held_out === 1) && <span class="tag">held out</span>}
                  {setupOf(name) && <span class="small">{setupOf(name)}</span>}
                </th>
                {channels.map((channel) => {
                  const score = at(name, channel);
                  if (!score) return <td key={channel} />;
                  return (
                    <td key={channel} class={`number shade-${shade(score.times_floor)}`}>
                      <span class="big">{times(score.times_floor)}</span> {quantity(score.rmse, score.unit)}
                      <span class="small">
                        {quantity(score.max_error, score.unit)} at{' '}
                        <a href={linkOf(score)} title={`${channel} of ${name} at its largest error`}>
                          {quantity(score.max_error_time, 's')}
                        </a>
                      </span>
                    </td>
                  );
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Figure>
  );
}
