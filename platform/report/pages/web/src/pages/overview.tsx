import { useLoaded } from '../data/use';
import { probabilityText, quantity, times } from '../kit/format';
import { linkTo } from '../kit/route';
import { Figure } from '../ui/figure';
import { Breakable, Empty, Show } from '../ui/parts';
import { saveCsv } from '../kit/download';
import { verdictOfRevision, verdictSentence } from './diagnose_data';
import { loadOverview, nextStep, type ErrorRow, type Overview } from './overview_data';
import { newestRun } from './run_progress';
import { useScoreUnit } from './score_unit';

const kMostExperiments = 10;
const kMostRevisions = 8;

/** The state of each experiment, and what to do next. */
export function OverviewPage() {
  const all = useLoaded(loadOverview, ['overview']);
  return (
    <Show of={all}>
      {(experiments) => (
        <>
          {experiments.length === 0 && (
            <Empty>
              The database has no experiment yet. <code>lacuna compare FILE</code> fits a model and shows its error;{' '}
              <code>lacuna run FILE</code> starts the algorithm.
            </Empty>
          )}
          {experiments.slice(0, kMostExperiments).map((one) => (
            <Experiment key={one.name} of={one} />
          ))}
          {experiments.length > kMostExperiments && (
            <p class="note">
              The newest {kMostExperiments} of {experiments.length} experiments. The pages{' '}
              <a href={linkTo('history')}>History</a> and <a href={linkTo('runs')}>Runs</a> have the others.
            </p>
          )}
        </>
      )}
    </Show>
  );
}

function Experiment({ of }: { of: Overview }) {
  const step = nextStep(of);
  return (
    <section class="experiment">
      <h2 class="experiment-name">{of.name}</h2>
      <Verdict of={of} />
      <div class="next">
        <p>
          <span class="muted">Next:</span> {step.sentence}
        </p>
        {step.command && <code class="block">{step.command}</code>}
      </div>
      {of.errors.length > 0 && <Errors of={of} />}
      {of.runs.length > 0 && <Runs of={of} />}
      <Links of={of} />
    </section>
  );
}

function Verdict({ of: { diagnosis, revisions } }: { of: Overview }) {
  if (!diagnosis) return null;
  const { document, revision, id } = diagnosis;
  const newest = revisions[revisions.length - 1]?.number ?? revision;
  const link = linkTo('diagnose', { diagnosis: id });
  const certainty = [
    ...(document.stopped ? ['preliminary'] : []),
    ...(document.probability !== null ? [`probability that this verdict is right: ${probabilityText(document.probability)}`] : []),
  ];
  if (newest !== revision)
    return (
      <p class="lead">
        <strong>Revision {newest} is not diagnosed yet.</strong>{' '}
        <a href={link}>{verdictOfRevision(document, revision)}</a>{' '}
        <span class="muted">{certainty.join(', ')}</span>
      </p>
    );
  return (
    <p class="lead">
      <a href={link}>
        <strong>{verdictSentence(document)}</strong>
      </a>{' '}
      <span class="muted">{[...certainty, `revision ${revision}`].join(', ')}</span>
    </p>
  );
}

/** An error, and what it was in the revision before. */
function errorText(now: number | null, before: number | null | undefined, unit: string): string {
  if (now === null) return '—';
  if (before === null || before === undefined || before === 0) return quantity(now, unit);
  return `${quantity(before, unit)} → ${quantity(now, unit)}`;
}

function Errors({ of: { name, revisions, errors } }: { of: Overview }) {
  const channels = [...new Set(errors.map((one) => one.channel))];
  const compared = revisions.filter((one) => errors.some((error) => error.revision === one.number));
  const at = (revision: number | undefined, channel: string) =>
    errors.find((one) => one.revision === revision && one.channel === channel);
  const columns: (keyof ErrorRow)[] = ['revision', 'channel', 'unit', 'fit_rmse', 'held_out_rmse', 'times_floor'];
  return (
    <Figure
      title="Error by revision"
      note={`Upper line of a cell: RMSE on the fit trials, previous → this revision. Lower line: RMSE on the held-out trials, and × floor (RMSE divided by the noise floor). Without held-out trials, × floor is that of the fit trials.${compared.length > kMostRevisions ? ` The last ${kMostRevisions} of ${compared.length} revisions.` : ''}`}
      downloads={[
        {
          label: 'CSV',
          run: () =>
            saveCsv(
              columns,
              errors.map((one) => columns.map((column) => one[column])),
              'errors by revision',
            ),
        },
      ]}
    >
      <div class="scrolls">
        <table class="grid">
          <thead>
            <tr>
              <th scope="col">revision</th>
              <th scope="col">change</th>
              {channels.map((channel) => (
                <th scope="col" class="number" key={channel}>
                  {channel}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {compared.slice(-kMostRevisions).map((one) => {
              const before = compared[compared.indexOf(one) - 1];
              return (
                <tr key={one.number}>
                  <th scope="row">
                    <a href={linkTo('compare', { experiment: name, revision: one.number })}>{one.number}</a>
                  </th>
                  <td class="wraps">
                    <Breakable>{one.change}</Breakable>
                  </td>
                  {channels.map((channel) => {
                    const error = at(one.number, channel);
                    return (
                      <td class="number" key={channel}>
                        {error ? (
                          <>
                            {errorText(error.fit_rmse, at(before?.number, channel)?.fit_rmse, error.unit)}
                            <span class="small">
                              {error.held_out_rmse !== null &&
                                `held out ${quantity(error.held_out_rmse, error.unit)}, `}
                              {times(error.times_floor)} floor
                            </span>
                          </>
                        ) : (
                          '—'
                        )}
                      </td>
                    );
                  })}
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </Figure>
  );
}

function Runs({ of: { name, runs } }: { of: Overview }) {
  const run = newestRun(runs);
  const { unit } = useScoreUnit(run);
  return (
    <p>
      <a href={linkTo('run', { run: run.run })}>Run {run.run}</a>: {run.ending}, {run.passes_done} of {run.passes}{' '}
      passes, {run.trials} target trials, best error {quantity(run.best_score, unit, 4)} (
      {run.metric.replace(/_/g, ' ')}).{' '}
      {runs.length > 1 && <a href={linkTo('runs', { experiment: name })}>All {runs.length} runs</a>}
    </p>
  );
}

/** The pages that have something of an experiment. */
function Links({ of: { name, errors, revisions, diagnosis, runs } }: { of: Overview }) {
  const links: [string, string][] = [];
  if (errors.length > 0) links.push(['Compare: where the error is large', linkTo('compare', { experiment: name })]);
  if (diagnosis) links.push(['Diagnose: the missing effect', linkTo('diagnose', { diagnosis: diagnosis.id })]);
  if (revisions.length > 0) links.push(['History: values by revision', linkTo('history', { experiment: name })]);
  if (runs.length > 0) links.push(['Run: pass by pass', linkTo('run', { run: newestRun(runs).run })]);
  if (runs.length > 0) links.push(['Runs: all replicates', linkTo('runs', { experiment: name })]);
  if (errors.length > 0 || runs.length > 0) links.push(['Replay: the robot in motion', linkTo('replay')]);
  links.push(['SQL: any query', linkTo('sql')]);
  return (
    <nav class="page-links" aria-label={`Pages of ${name}`}>
      {links.map(([text, link]) => (
        <a key={text} href={link}>
          {text}
        </a>
      ))}
    </nav>
  );
}
