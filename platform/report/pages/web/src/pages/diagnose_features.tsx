import { useLoaded } from '../data/use';
import { saveCsv } from '../kit/download';
import { plain } from '../kit/format';
import { choose } from '../kit/route';
import { Chart } from '../ui/chart';
import { Figure } from '../ui/figure';
import { loadWhere, type FeatureTest } from './compare_data';
import type { DiagnosisRow } from './diagnose_data';

/** What the residual depends on, from the comparison of the same revision. */
export function Features({ row, chosen }: { row: DiagnosisRow; chosen: string | undefined }) {
  const where = useLoaded(
    (source) => loadWhere(source, row.experiment, row.revision),
    ['where', row.experiment, row.revision],
  );
  const views = where.value?.where?.views ?? [];
  const view = views.find((one) => one.view === 'acceleration' && one.channels.length > 0) ?? views[0];
  const tests = (view?.channels ?? [])
    .flatMap((channel) =>
      channel.independence
        .filter((one) => one.testable && one.bins.length > 1)
        .map((test) => ({ channel, test, name: `${channel.channel} over ${fullName(test)}` })),
    )
    .sort((a, b) => Number(b.test.depends) - Number(a.test.depends) || b.test.share - a.test.share);
  if (!view || tests.length === 0) return null;
  const shown = tests.find((one) => one.name === chosen) ?? tests[0];
  const unit = shown.channel.unit;
  const bins = shown.test.bins;
  const what = view.view === 'acceleration' ? 'residual acceleration' : 'residual';
  return (
    <div class="two">
      <Chart
        title={`${shown.channel.channel}: ${what} over ${fullName(shown.test)}`}
        height={260}
        x={{ label: fullName(shown.test), unit: shown.test.unit }}
        y={{ label: what, unit, include: [0] }}
        series={[
          {
            name: 'mean of a bin',
            kind: isClass(shown.test) ? 'points' : 'both',
            colour: 'residual',
            x: bins.map((one) => one.feature),
            y: bins.map((one) => one.mean),
          },
          {
            name: '99 % band expected without dependence',
            kind: 'band',
            colour: 'floor',
            x: bins.map((one) => one.feature),
            y: bins.map(() => 0),
            lower: bins.map((one) => -one.band99),
            upper: bins.map((one) => one.band99),
          },
        ]}
      />
      <Figure
        title="Dependence of the residual"
        downloads={[
          {
            label: 'CSV',
            run: () =>
              saveCsv(
                ['channel', 'feature', 'share', 'p', 'depends'],
                tests.map((one) => [
                  one.channel.channel,
                  fullName(one.test),
                  one.test.share,
                  one.test.p,
                  one.test.depends,
                ]),
                'dependence of the residual',
              ),
          },
        ]}
        note="Features are quantities of state and input. Share: part of the squared residual that a feature explains by itself, in the comparison of this revision. Click a row to see the curve."
      >
        <div class="scrolls">
          <table class="grid">
            <thead>
              <tr>
                <th>feature</th>
                <th class="number">share</th>
                <th class="number">p</th>
                <th>depends</th>
              </tr>
            </thead>
            <tbody>
              {tests.map((one) => (
                <tr key={one.name} class={one === shown ? 'chosen' : ''}>
                  <th scope="row">
                    <button class="link" onClick={() => choose({ feature: one.name })}>
                      {view.channels.length > 1 ? one.name : fullName(one.test)}
                    </button>
                  </th>
                  <td class="number">{plain(100 * one.test.share, 2)} %</td>
                  <td class="number">{one.test.p < 0.001 ? '< 0.001' : plain(one.test.p, 2)}</td>
                  <td>{one.test.depends ? 'yes' : 'no'}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </Figure>
    </div>
  );
}

/** Features whose values are classes and not numbers: no line joins their means. */
const isClass = (test: FeatureTest) => ['direction of motion', 'contact'].includes(test.name);

const fullName = (test: FeatureTest) => (test.of ? `${test.name} of ${test.of}` : test.name);
