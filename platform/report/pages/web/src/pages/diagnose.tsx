import { useRows } from '../data/use';
import { saveCsv } from '../kit/download';
import { plain, quantity, times } from '../kit/format';
import { valueText } from '../kit/interval';
import { choose, linkTo } from '../kit/route';
import { Figure } from '../ui/figure';
import { Forest, type ForestRow } from '../ui/forest';
import { ForceMap } from '../ui/force_map';
import { Breakable, Empty, Select, Show } from '../ui/parts';
import {
  effectName,
  firstIsAnswer,
  gainText,
  modelName,
  readDocument,
  verdictSentence,
  type DiagnosisDocument,
  type DiagnosisRow,
  type Ranked,
} from './diagnose_data';
import { Features } from './diagnose_features';
import { Horizons } from './diagnose_horizons';

const kDiagnoses = `SELECT diagnosis.id, experiment.name AS experiment, revision.number AS revision, diagnosis.document
  FROM diagnosis JOIN revision ON revision.id = diagnosis.revision JOIN experiment ON experiment.id = revision.experiment
  ORDER BY diagnosis.id`;

/** What a model lacks, and how that is known. */
export function DiagnosePage({ choices }: { choices: Record<string, string> }) {
  const rows = useRows<DiagnosisRow>(kDiagnoses);
  return (
    <Show of={rows}>
      {(all) =>
        all.length === 0 ? (
          <Empty>
            The database has no finished diagnosis. <code>lacuna diagnose FILE</code> makes one.
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
  const label = (one: DiagnosisRow) => {
    const { verdict } = readDocument(one.document);
    return `${one.experiment} · revision ${one.revision} · ${verdict.replace(/_/g, ' ')}`;
  };
  return (
    <>
      <div class="choices">
        <Select
          label="Diagnosis"
          value={String(row.id)}
          options={all.map((one) => ({ value: String(one.id), label: label(one) }))}
          change={(value) => choose({ diagnosis: value, feature: null })}
        />
        <a href={linkTo('compare', { experiment: row.experiment, revision: row.revision })}>compare</a>
      </div>
      <p class="lead">
        <strong>{verdictSentence(document)}</strong>{' '}
        {document.stopped && <span class="muted">preliminary: the time limit stopped the search</span>}
        {document.probability !== null && (
          <span class="muted">
            probability {plain(document.probability, 2)} (
            {document.calibrated ? 'calibrated on rigs with known answers' : 'uncalibrated'})
          </span>
        )}
      </p>
      {document.horizons.length > 0 && <Horizons errors={document.horizons} />}
      {document.ranking.length > 0 && <Ranking document={document} />}
      <Force document={document} />
      <Features row={row} chosen={choices.feature} />
      <Rest document={document} />
    </>
  );
}

/** What the library comes to, and the force of another form where that was judged under the same noise. */
function rowsOf(document: DiagnosisDocument): ForestRow[] {
  const first = firstIsAnswer(document);
  const rows = document.ranking.map((one, i) => ({
    name: modelName(one),
    value: one.gain,
    lower: one.gain_ci95[0],
    upper: one.gain_ci95[1],
    chosen: first && i === 0,
  }));
  if (document.verdict !== 'not_in_library' || document.formulas_of_rest) return rows;
  const formulas = document.formulas.slice(0, 1).map((one) => ({
    name: `${one.joint}: ${one.text}`,
    value: one.gain.value,
    lower: one.gain.ci95[0],
    upper: one.gain.ci95[1],
    chosen: !first,
  }));
  return first ? [...rows, ...formulas] : [...formulas, ...rows];
}

/** What the gains are, below their picture. */
function gainNote(document: DiagnosisDocument): string {
  if (document.horizons.length > 0)
    return 'How much lower the mean logarithm of the error over all horizons is than that of the model alone, where it was not fitted, with 95 % intervals; 0.69 is half the error.';
  const first =
    document.verdict === 'not_in_library' && !firstIsAnswer(document) && !document.formulas_of_rest
      ? 'First: the formula below. '
      : '';
  return `${first}Log likelihood over that of the model alone, with 95 % intervals; 5 nats are odds of 150 to 1. Dashed: what the best of ${document.hypotheses} effects reaches by chance in 95 % of cases (${plain(document.chance_95)} nats; p ${plain(document.p_by_chance, 2)}).`;
}

function Ranking({ document }: { document: DiagnosisDocument }) {
  const outdone = document.verdict === 'not_in_library' && !firstIsAnswer(document);
  return (
    <div class="two">
      <Forest
        title="How much better each predicts what was left out"
        label="gain / nats"
        chance={document.horizons.length > 0 ? null : document.chance_95}
        rows={rowsOf(document)}
        note={gainNote(document)}
      />
      <Figure
        title={outdone ? 'Candidates of the library, none of which is the answer' : 'Candidates'}
        downloads={[{ label: 'CSV', run: () => saveCandidates(document.ranking) }]}
        note={`Error on what was left out, in multiples of the noise floor; the model alone: ${times(document.base.ratio_to_floor)}. A value without an interval is at a bound of its range, or not told by these data.`}
      >
        <div class="scrolls">
          <table class="grid">
            <thead>
              <tr>
                <th scope="col" />
                <th scope="col">effect and parameters</th>
                <th scope="col" class="number">
                  gain / nats
                </th>
                <th scope="col" class="number">
                  error
                </th>
              </tr>
            </thead>
            <tbody>
              {document.ranking.map((one, i) => (
                <Candidate key={i} rank={i + 1} model={one} length={document.ranking[0]?.segment_s ?? null} />
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
      model.ratio_to_floor,
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

const kNoInterval = 'at its bound, or not told';

interface CandidateProps {
  rank: number;
  model: Ranked;
  length: number | null; // s, of the answer's segments; errors over others are no measure beside its own
}

function Candidate({ rank, model, length }: CandidateProps) {
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
              .map(([name, one]) => `${name} ${valueText(one.value, one.ci95[0], one.ci95[1], one.unit, kNoInterval)}`)
              .join(' · ')}
          </span>
        ))}
        {model.class.length > 0 && <span class="small">not told apart from it here: {model.class.join(', ')}</span>}
      </td>
      <td class="number">{gainText({ value: model.gain, standard_error: model.gain_standard_error })}</td>
      <td class="number">
        {(model.segment_s ?? null) === length ? times(model.ratio_to_floor) : `over ${quantity(model.segment_s, 's')}`}
      </td>
    </tr>
  );
}

function Force({ document }: { document: DiagnosisDocument }) {
  if (document.residual_force.length === 0 && document.formulas.length === 0) return null;
  return (
    <>
      <div class="two">
        <ForceMap curves={document.residual_force} />
      </div>
      {document.formulas.length > 0 && (
        <Figure
          note={
            <>
              In SI units of the state. As an effect of your own:{' '}
              <code>lacuna plugins new effect NAME --formula "{document.formulas[0].text}"</code>
            </>
          }
          downloads={[{ label: 'CSV', run: () => saveFormulas(document) }]}
          title={document.formulas_of_rest ? 'A formula for what the answer leaves' : 'A formula for what is missing'}
        >
          <div class="scrolls">
            <table class="grid">
              <thead>
                <tr>
                  <th>joint</th>
                  <th>force</th>
                  <th class="number">gain</th>
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
                    <td class="number">{gainText(one.gain)} nats</td>
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

function Rest({ document }: { document: DiagnosisDocument }) {
  return (
    <div class="two">
      <section>
        {document.findings.length > 0 && (
          <>
            <h2>Findings</h2>
            <ul>
              {document.findings.map((one) => (
                <li key={one}>{one}</li>
              ))}
            </ul>
          </>
        )}
        {document.next_test !== '' && (
          <>
            <h2>A test that would settle it</h2>
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
          <h2>Not testable on these data</h2>
          <ul class="muted">
            {document.not_testable.map((one) => (
              <li key={one.effect + one.where}>
                {one.effect}
                {one.where ? ` @ ${one.where}` : ''}: {one.reason}
              </li>
            ))}
          </ul>
        </section>
      )}
    </div>
  );
}
