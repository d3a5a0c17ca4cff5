import { useRows } from '../data/use';
import { saveCsv } from '../kit/download';
import { forceWord, plain, probabilityText, quantity, times } from '../kit/format';
import { valueText } from '../kit/interval';
import { choose, linkTo } from '../kit/route';
import { Figure } from '../ui/figure';
import { Forest, type ForestRow } from '../ui/forest';
import { ForceMap } from '../ui/force_map';
import { Breakable, Empty, Select, Show } from '../ui/parts';
import {
  effectName,
  errorChange,
  errorChangeText,
  filterSentence,
  firstIsAnswer,
  gainText,
  modelName,
  readDocument,
  timesFloor,
  verdictSentence,
  type DiagnosisDocument,
  type DiagnosisRow,
  type Effect,
  type Parameter,
  type Ranked,
} from './diagnose_data';
import { Features } from './diagnose_features';
import { Horizons } from './diagnose_horizons';
import { byHorizon, gainNote, measureOf } from './diagnose_notes';

const kDiagnoses = `SELECT diagnosis.id, experiment.name AS experiment, revision.number AS revision, diagnosis.document
  FROM diagnosis JOIN revision ON revision.id = diagnosis.revision JOIN experiment ON experiment.id = revision.experiment
  ORDER BY diagnosis.id`;

/** The verdict of a diagnosis and its evidence. */
export function DiagnosePage({ choices }: { choices: Record<string, string> }) {
  const rows = useRows<DiagnosisRow>(kDiagnoses);
  return (
    <Show of={rows}>
      {(all) =>
        all.length === 0 ? (
          <Empty>
            The database has no finished diagnosis. Make one: <code>lacuna diagnose FILE</code>
          </Empty>
        ) : (
          <Chosen all={all} choices={choices} />
        )
      }
    </Show>
  );
}

function Chosen({ all, choices }: { all: DiagnosisRow[]; choices: Record<string, string> }) {
  const row = all.find((one) => String(one.id) === choices.diagnosis) ?? all[all.length - 1];
  const document = readDocument(row.document);
  const names = all.map((one) => {
    const { verdict, effect_filter } = readDocument(one.document);
    return `${one.experiment} · revision ${one.revision} · ${verdict.replace(/_/g, ' ')}${effect_filter.length > 0 ? ' (--among)' : ''}`;
  });
  // Several diagnoses of one revision are numbered.
  const label = (i: number) => {
    const alike = names.map((one, at) => ({ one, at })).filter(({ one }) => one === names[i]);
    return alike.length > 1
      ? `${names[i]} · ${alike.findIndex(({ at }) => at === i) + 1} of ${alike.length}`
      : names[i];
  };
  return (
    <>
      <div class="choices">
        <Select
          label="Diagnosis"
          value={String(row.id)}
          options={all.map((one, i) => ({ value: String(one.id), label: label(i) }))}
          change={(value) => choose({ diagnosis: value, feature: null })}
        />
        <a href={linkTo('compare', { experiment: row.experiment, revision: row.revision })}>compare</a>
      </div>
      <p class="lead">
        <strong>{verdictSentence(document)}</strong>{' '}
        {document.stopped && <span class="muted">preliminary: the time limit stopped the search</span>}
        {document.probability !== null && (
          <span class="muted">
            probability that this verdict is right: {probabilityText(document.probability)} (
            {document.calibrated ? 'calibrated on simulated experiments' : 'uncalibrated'})
          </span>
        )}
      </p>
      {document.effect_filter.length > 0 && <p class="note">{filterSentence(document)}</p>}
      {document.horizons.length > 0 && <Horizons errors={document.horizons} />}
      {document.ranking.length > 0 && <Ranking document={document} />}
      <Force document={document} />
      <Features row={row} chosen={choices.feature} />
      <Rest document={document} row={row} />
    </>
  );
}


/** The ranked candidates, and the formula if it was evaluated with the same noise. */
function rowsOf(document: DiagnosisDocument): ForestRow[] {
  const first = firstIsAnswer(document);
  const shown = (gain: number | null) => (byHorizon(document) ? errorChange(gain) : gain);
  const rows = document.ranking.map((one, i) => ({
    name: modelName(one),
    value: shown(one.gain),
    lower: shown(one.gain_ci95[0]),
    upper: shown(one.gain_ci95[1]),
    chosen: first && i === 0,
  }));
  if (document.verdict !== 'not_in_library' || document.formulas_of_rest) return rows;
  const formulas = document.formulas.slice(0, 1).map((one) => ({
    name: `${one.joint}: ${one.text}`,
    value: shown(one.gain.value),
    lower: shown(one.gain.ci95[0]),
    upper: shown(one.gain.ci95[1]),
    chosen: !first,
  }));
  return first ? [...rows, ...formulas] : [...formulas, ...rows];
}

function Ranking({ document }: { document: DiagnosisDocument }) {
  const outdone = document.verdict === 'not_in_library' && !firstIsAnswer(document);
  return (
    <div class="two">
      <Forest
        title={byHorizon(document) ? 'Change of the cross-validated error by candidate' : 'Cross-validated gain by candidate'}
        label={measureOf(document)}
        linear={byHorizon(document)}
        chance={byHorizon(document) ? null : document.chance_95}
        rows={rowsOf(document)}
        note={gainNote(document)}
      />
      <Figure
        title={outdone ? 'Candidates of the library (none is the answer)' : 'Candidates'}
        downloads={[{ label: 'CSV', run: () => saveCandidates(document.ranking) }]}
        note={`Error on ${byHorizon(document) ? 'fitted' : 'left-out'} data, in multiples of the noise floor. Null model (the model without any added effect): ${times(timesFloor(document.base))}. A value without an interval is at a bound of its range, or these data do not determine it.`}
      >
        <div class="scrolls">
          <table class="grid">
            <thead>
              <tr>
                <th scope="col" />
                <th scope="col">effect and parameters</th>
                <th scope="col" class="number">
                  {byHorizon(document) ? 'change of error' : 'gain / nats'}
                </th>
                <th scope="col" class="number">
                  error
                </th>
              </tr>
            </thead>
            <tbody>
              {document.ranking.map((one, i) => (
                <Candidate key={i} rank={i + 1} model={one} inPercent={byHorizon(document)} length={document.ranking[0]?.segment_s ?? null} />
              ))}
            </tbody>
          </table>
        </div>
      </Figure>
    </div>
  );
}

function saveCandidates(ranking: Ranked[]): void {
  const parameters = ranking.flatMap((model, i) => {
    const own = [
      i + 1,
      modelName(model),
      model.gain,
      model.gain_ci95[0],
      model.gain_ci95[1],
      timesFloor(model),
      model.segment_s,
    ];
    const values = model.effects.flatMap((effect) =>
      Object.entries(effect.parameters).map(([name, one]) => [
        ...own,
        `${effectName(effect)} ${name}`,
        one.value,
        one.ci95[0],
        one.ci95[1],
        one.unit,
      ]),
    );
    return values.length > 0 ? values : [[...own, null, null, null, null, null]];
  });
  saveCsv(
    [
      'rank',
      'model',
      'gain',
      'gain_lower',
      'gain_upper',
      'times_floor',
      'segment_s',
      'parameter',
      'value',
      'lower',
      'upper',
      'unit',
    ],
    parameters,
    'candidates',
  );
}

interface CandidateProps {
  rank: number;
  model: Ranked;
  inPercent: boolean; // its gain
  length: number | null; // s, of the answer's segments; errors over others are no measure beside its own
}

function parameterText(name: string, one: Parameter): string {
  const noInterval = one.at_bound ? 'at a bound of its range' : 'not determined';
  const value = `${name} ${valueText(one.value, one.ci95[0], one.ci95[1], one.unit, noInterval)}`;
  return one.stated === undefined ? value : `${value} instead of ${quantity(one.stated, one.unit)}`;
}

/** Fixed parameters of which only the product with a fitted one is determined. */
function heldTexts(effect: Effect): string[] {
  return Object.entries(effect.held ?? {}).map(([name, one]) => `${name} held at ${quantity(one.value, one.unit)}`);
}

function Candidate({ rank, model, inPercent, length }: CandidateProps) {
  return (
    <tr>
      <td class="muted">{rank}</td>
      <td class="wraps">
        <strong>
          <Breakable>{modelName(model)}</Breakable>
        </strong>
        {model.effects.map((effect) => (
          <span key={effect.effect + effect.where} class="small">
            {Object.entries(effect.parameters)
              .map(([name, one]) => parameterText(name, one))
              .concat(heldTexts(effect))
              .join(' · ')}
          </span>
        ))}
        {model.class.length > 0 && <span class="small">indistinguishable on these data: {model.class.join(', ')}</span>}
      </td>
      <td class="number">
        {inPercent
          ? errorChangeText(model)
          : gainText({ value: model.gain, standard_error: model.gain_standard_error })}
      </td>
      <td class="number">
        {(model.segment_s ?? null) === length ? (
          times(timesFloor(model))
        ) : (
          <>
            not comparable<span class="small">{quantity(model.segment_s, 's')} segments</span>
          </>
        )}
      </td>
    </tr>
  );
}

function Force({ document }: { document: DiagnosisDocument }) {
  if (document.missing_force.length + document.residual_force.length + document.formulas.length === 0) return null;
  return (
    <>
      <div class="two">
        <ForceMap curves={document.missing_force} kind="missing" />
        <ForceMap curves={document.residual_force} kind="unexplained" />
      </div>
      {document.formulas.length > 0 && (
        <Figure
          note={
            <>
              In SI units. To make an effect from it:{' '}
              <code>lacuna plugins new effect NAME --formula "{document.formulas[0].text}"</code>
            </>
          }
          downloads={[{ label: 'CSV', run: () => saveFormulas(document) }]}
          title={
            document.formulas_of_rest || document.verdict === 'effect_found'
              ? `Formula for the residual ${forceWord(document.formulas[0].unit)}`
              : `Formula for the missing ${forceWord(document.formulas[0].unit)}`
          }
        >
          <div class="scrolls">
            <table class="grid">
              <thead>
                <tr>
                  <th>joint</th>
                  <th>{forceWord(document.formulas[0].unit)}</th>
                  <th class="number">{byHorizon(document) ? 'change of error' : 'gain'}</th>
                </tr>
              </thead>
              <tbody>
                {document.formulas.map((one) => (
                  <tr key={one.joint + one.text}>
                    <td>{one.joint}</td>
                    <td class="wraps">
                      <code>{one.text}</code>
                      <span class="small">
                        {one.terms
                          .map((term) => `${term.text}: ${plain(term.coefficient)} ± ${plain(term.standard_error, 2)}`)
                          .join(' · ')}
                      </span>
                    </td>
                    <td class="number">
                      {byHorizon(document)
                        ? errorChangeText({ gain: one.gain.value, gain_ci95: one.gain.ci95 })
                        : `${gainText(one.gain)} nats`}
                    </td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        </Figure>
      )}
    </>
  );
}

const saveFormulas = (document: DiagnosisDocument) =>
  saveCsv(
    ['joint', 'formula', 'unit', 'gain', 'term', 'coefficient', 'standard_error', 'term_unit'],
    document.formulas.flatMap((one) =>
      one.terms.map((term) => [
        one.joint,
        one.text,
        one.unit,
        one.gain.value,
        term.text,
        term.coefficient,
        term.standard_error,
        term.unit,
      ]),
    ),
    'formulas',
  );

interface Compared {
  trial: string;
  channel: string;
}

/** A link to the trial and the channel that a sentence names. */
function linkOf(sentence: string, row: DiagnosisRow, compared: Compared[]): string | null {
  const named = (names: string[]) =>
    names.filter((one) => sentence.includes(one)).sort((a, b) => b.length - a.length)[0] ?? null;
  const trial = named(compared.map((one) => one.trial));
  if (trial === null) return null;
  const channel = named(compared.filter((one) => one.trial === trial).map((one) => one.channel));
  return linkTo('compare', { experiment: row.experiment, revision: row.revision, trial, channel });
}

function Rest({ document, row }: { document: DiagnosisDocument; row: DiagnosisRow }) {
  const compared = useRows<Compared>(
    'SELECT trial, channel FROM latest_comparison WHERE experiment = ? AND revision = ?',
    [row.experiment, row.revision],
  );
  return (
    <div class="two">
      <section>
        {document.findings.length > 0 && (
          <>
            <h2>Findings</h2>
            <ul>
              {document.findings.map((one) => {
                const link = linkOf(one, row, compared.value ?? []);
                return (
                  <li key={one}>
                    {one} {link && <a href={link}>curves</a>}
                  </li>
                );
              })}
            </ul>
          </>
        )}
        {document.next_test !== '' && (
          <>
            <h2>Recommended next test</h2>
            <p>
              <code class="block">
                lacuna trial FILE --test "{document.next_test}"
                {document.next_test_setup && ` --setup ${document.next_test_setup.name || 'none'} --csv=next.csv`}
              </code>
            </p>
            <p class="note">{document.next_test_worth}</p>
          </>
        )}
      </section>
      {document.not_testable.length > 0 && (
        <section>
          <h2>Effects that could not be tested</h2>
          <ul class="muted">
            {document.not_testable.map((one) => (
              <li key={one.effect + one.where}>
                {one.effect}
                {one.where ? ` @ ${one.where}` : ''}: {one.failed && 'its plugin failed: '}
                {one.reason}
              </li>
            ))}
          </ul>
        </section>
      )}
    </div>
  );
}
