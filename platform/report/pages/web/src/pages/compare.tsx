import { useMemo, useState } from 'preact/hooks';
import { useLoaded, useRows, type Loaded } from '../data/use';
import { savePng } from '../kit/download';
import { quantity, times } from '../kit/format';
import { choose, linkTo, notHere } from '../kit/route';
import { shellWord } from '../kit/shell';
import { Empty, Select, Show } from '../ui/parts';
import { ErrorTable } from '../ui/error_table';
import { TrialCurvesPanel } from '../ui/trial_curves';
import { RegimeTable } from '../ui/regime_table';
import {
  kSetups,
  loadCurves,
  loadWhere,
  pointed,
  regimesOf,
  setupText,
  type Finding,
  type RegimeRow,
  type Score,
  type TrialSetup,
  type Where,
} from './compare_data';
import { chosenPlace, placeOf, stretchToShow, type Place } from './compare_place';

interface Props {
  choices: Record<string, string>;
}

const kScores = 'SELECT * FROM latest_comparison ORDER BY experiment, revision, held_out, trial, channel';

const unique = <Value,>(values: Value[]) => [...new Set(values)];

/** Measured and predicted, channel by channel, and where they part. */
export function ComparePage({ choices }: Props) {
  const scores = useRows<Score>(kScores);
  return (
    <Show of={scores}>
      {(all) =>
        all.length === 0 ? (
          <Empty>
            The database has no comparison. Make one: <code>lacuna compare FILE</code>
          </Empty>
        ) : (
          <Chosen all={all} choices={choices} />
        )
      }
    </Show>
  );
}

function Chosen({ all, choices }: { all: Score[]; choices: Record<string, string> }) {
  const experiments = unique(all.map((one) => one.experiment));
  const experiment = experiments.includes(choices.experiment)
    ? choices.experiment
    : experiments[experiments.length - 1];
  const ofExperiment = all.filter((one) => one.experiment === experiment);
  const revisions = unique(ofExperiment.map((one) => one.revision));
  const revision = revisions.includes(Number(choices.revision))
    ? Number(choices.revision)
    : revisions[revisions.length - 1];
  const scores = ofExperiment.filter((one) => one.revision === revision);
  const trials = unique(scores.map((one) => one.trial));
  const worst = worstOf(scores);
  const fitted = (scores.find((one) => !one.held_out) ?? scores[0]).comparison;
  const where = useLoaded(
    (source) => loadWhere(source, experiment, revision, fitted),
    ['where', experiment, revision, fitted],
  );
  const findings = useMemo(() => (where.value ? pointed(where.value) : []), [where.value]);
  const regimes = useMemo(() => (where.value ? regimesOf(where.value) : []), [where.value]);
  const asked = choices.finding ?? '';
  const finding =
    (/^\d+$/.test(asked) ? findings[Number(asked)] : undefined) ?? regimes.find((one) => one.key === asked);
  const chosen = trials.includes(choices.trial) ? choices.trial : undefined;
  const place = chosenPlace(
    { ...choices, trial: chosen! },
    finding ? placeOf(finding, scores, chosen) : chosen ? { ...kWholeTrial, trial: chosen } : null,
  );
  const trial = place.trial ?? worst?.trial ?? trials[0];
  const isFindingKnown = where.value !== undefined || where.error !== null;
  const channels = unique(scores.filter((one) => one.trial === trial).map((one) => one.channel));
  const missing = [
    notHere('experiment', choices.experiment, experiments),
    notHere('revision', choices.revision, revisions),
    notHere('trial', choices.trial, trials),
    notHere('channel', choices.channel, channels),
    isFindingKnown && asked !== '' && !finding ? notHere('finding', asked, []) : null,
  ].filter((one) => one !== null);
  return (
    <>
      <div class="choices">
        {experiments.length > 1 && (
          <Select
            label="Experiment"
            value={experiment}
            options={experiments.map((one) => ({ value: one, label: one }))}
            change={(value) => choose({ experiment: value, revision: null, trial: null, ...kNoPlace })}
          />
        )}
        <Select
          label="Revision"
          value={String(revision)}
          options={revisions.map((one) => ({ value: String(one), label: String(one) }))}
          change={(value) => choose({ revision: value, ...kNoPlace })}
        />
        <Select
          label="Trial"
          value={trial}
          change={(value) => choose({ trial: value, channel: null, t: null })}
          options={trials.map((one) => ({
            value: one,
            label: scores.some((s) => s.trial === one && s.held_out) ? `${one} (held out)` : one,
          }))}
        />
      </div>
      {missing.length > 0 && (
        <p class="error" role="status">
          {missing.join(' ')} This is revision {revision} of {experiment}, trial {trial}.
        </p>
      )}
      <Summary worst={worst} />
      {isFindingKnown || asked === '' || chosen ? (
        <Trial
          scores={scores}
          trial={trial}
          place={place}
          where={where}
          findings={findings}
          regimes={regimes}
          chosen={finding}
          choose={(key) => choose({ finding: key, trial: null, channel: null, t: null })}
        />
      ) : (
        <p class="empty loading">loading …</p>
      )}
    </>
  );
}

const kNoPlace = { finding: null, channel: null, t: null };
const kWholeTrial: Place = { trial: null, channel: null, from: null, to: null };

/** Farthest above the noise floor; null where no floor is known. */
const worstOf = (scores: Score[]) =>
  scores.reduce<Score | null>((a, b) => ((b.times_floor ?? 0) > (a?.times_floor ?? 0) ? b : a), null);

function Summary({ worst }: { worst: Score | null }) {
  if (!worst) return <p class="lead">The noise floor is not known, so the errors have no reference.</p>;
  const atFloor = (worst.times_floor ?? 0) <= 1.2;
  return (
    <p class="lead">
      {atFloor ? 'The model is at the noise floor in every trial: ' : 'The largest error is in '}
      <strong>
        {atFloor ? (
          `at most ${times(worst.times_floor)}`
        ) : (
          <a href={linkTo('compare', linkOf(worst))}>{`${worst.channel} of ${worst.trial}`}</a>
        )}
      </strong>
      {atFloor ? ' the floor.' : `: RMSE ${quantity(worst.rmse, worst.unit)}, ${times(worst.times_floor)} the floor.`}
    </p>
  );
}

/** Where the largest error of a score is. */
const linkOf = ({ experiment, revision, trial, channel, max_error_time }: Score) => ({
  experiment,
  revision,
  trial,
  channel,
  t: max_error_time === null ? null : Number(max_error_time.toPrecision(6)),
});

function NoFinding({ analysed }: { analysed: boolean }) {
  return (
    <Empty>
      {analysed ? (
        'The error on the fit trials shows no significant dependence on input or state.'
      ) : (
        <>
          Not analysed for this revision. To fit the model and analyse the fit trials: <code>lacuna compare FILE</code>
        </>
      )}
    </Empty>
  );
}

interface TrialProps {
  scores: Score[];
  trial: string;
  place: Place;
  where: Loaded<Where>;
  findings: Finding[];
  regimes: RegimeRow[];
  chosen: Finding | undefined;
  /** A finding's number, a regime's key, or none. */
  choose: (key: string | number | null) => void;
}

function Trial({ scores, trial, place, where, findings, regimes, chosen, choose: point }: TrialProps) {
  const own = scores.filter((one) => one.trial === trial);
  const { comparison, experiment, revision } = own[0];
  const known = useRows<TrialSetup>(kSetups);
  const setups = known.value ?? [];
  const setup = setupText(setups, comparison, trial);
  const curves = useLoaded((source) => loadCurves(source, comparison, trial, own), ['curves', comparison, trial]);
  const lit = useMemo(() => chosen?.stretches?.find((one) => one.trial === trial)?.spans ?? [], [chosen, trial]);
  const [error, setError] = useState<string | null>(null);
  const keep = () => {
    const canvases = [...document.querySelectorAll<HTMLCanvasElement>('.trial-curves canvas')];
    if (canvases.length === 0) setError('there is no picture to save');
    else savePng(canvases, `${experiment}, revision ${revision}: ${trial}`);
  };
  return (
    <>
      <div class="with-side">
        <section class="main-column">
          <Show of={curves}>
            {(value) =>
              value === null ? (
                <Empty>The samples of this trial are not in {`the ${comparison ? 'report' : 'database'}`}.</Empty>
              ) : (
                <TrialCurvesPanel
                  key={`${comparison} ${trial}`}
                  curves={value}
                  title={trial}
                  setup={setup}
                  lit={lit}
                  channel={place.channel}
                  stretch={stretchToShow(place, value.times[0], value.times[value.times.length - 1])}
                  keep={keep}
                />
              )
            }
          </Show>
          {error && <p class="error">{error}</p>}
          {known.error && <p class="error">{known.error}</p>}
        </section>
        <aside class="side">
          <h2>Where the error is large</h2>
          {where.error && <p class="error">{where.error}</p>}
          {where.value && findings.length === 0 && <NoFinding analysed={where.value.where !== null} />}
          <ol class="findings">
            {findings.map((one, i) => (
              <li key={i} class={one === chosen ? 'chosen' : ''}>
                <button
                  class="quiet finding"
                  aria-pressed={one === chosen}
                  onClick={() => point(one === chosen ? null : i)}
                >
                  {one.sentence}
                </button>
              </li>
            ))}
          </ol>
          {chosen?.stretches && lit.length === 0 && (
            <p class="note">
              The chosen finding has no samples in {trial}.{' '}
              <button class="link" onClick={() => choose({ trial: null, channel: null, t: null })}>
                Show the trial with most of its samples.
              </button>
            </p>
          )}
          {findings.length > 0 && (
            <p class="note">
              Click a finding to go to its trial, channel and time; its samples are highlighted.
            </p>
          )}
        </aside>
      </div>
      <ErrorTable
        scores={scores}
        setups={setups}
        trial={trial}
        choose={(name) => choose({ trial: name, channel: null, t: null })}
        linkOf={(score) => linkTo('compare', linkOf(score))}
      />
      <RegimeTable regimes={regimes} chosen={chosen} choose={point} />
      <Simulate experiment={experiment} />
    </>
  );
}

/** How the model is simulated on another test. */
function Simulate({ experiment }: { experiment: string }) {
  const file = useRows<{ file: string }>(
    `SELECT file FROM experiment_text JOIN experiment ON experiment.id = experiment_text.experiment
     WHERE experiment.name = ? ORDER BY experiment_text.id DESC LIMIT 1`,
    [experiment],
  ).value?.[0]?.file;
  return (
    <div class="note">
      Simulate the fitted model on another test:
      <code class="block">{`lacuna predict ${shellWord((file ?? 'FILE').replace(/^.*\//, ''))} --fitted --test TEST --csv=prediction.csv`}</code>
    </div>
  );
}
