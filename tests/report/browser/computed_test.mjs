// What pages compute before anything is drawn.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { pageModule } from './page_modules.mjs';

describe('what pages compute', () => {
  it('values with as many digits as their interval deserves, and units of columns', async () => {
    const { valueText } = await pageModule('kit/interval.ts');
    assert.equal(valueText(0.53516, 0.53504, 0.53528, 'kg'), '0.53516 [0.53504, 0.53528] kg');
    assert.equal(valueText(0.02423, 0.02391, 0.02435, 'N*m'), '24.23 [23.91, 24.35] mN·m');
    assert.equal(valueText(1000, null, null, 'kg', 'at its bound'), '1000 kg (at its bound)');
    assert.equal(valueText(null, null, null, 'kg'), '—');
    const { unitOf } = await pageModule('pages/sql_units.ts');
    const table = (...units) => ({ columns: ['rmse', 'unit', 'gain'], rows: units.map((unit) => [1, unit, 2]) });
    assert.equal(unitOf(table('rad', 'rad'), 0), 'rad');
    assert.equal(unitOf(table('rad', 'm'), 0), '1');
    assert.equal(unitOf(table('rad', 'm'), 2), 'nats');
  });

  it('probabilities and changes of an error, as the terminal has them', async () => {
    const { errorChange, probabilityText } = await pageModule('kit/format.ts');
    assert.deepEqual([0.896, 0.29, 0.9972, 1, 0.004].map(probabilityText), ['0.89', '0.29', '0.99', '0.99', '< 0.01']);
    assert.equal(errorChange(0.9, 12.1), '−92.6 %');
    assert.equal(errorChange(66, 100), '−34 %');
    assert.equal(errorChange(0.57, 100), '−99.43 %');
    assert.equal(errorChange(14, 10), '+40 %');
    assert.equal(errorChange(1, 1), '0.0 %');
    assert.equal(errorChange(null, 1), '–');
  });

  it('nothing that a diagnosis by horizon never asked, whatever version made it', async () => {
    const { firstIsAnswer, readDocument, timesFloor } = await pageModule('pages/diagnose_data.ts');
    const first = { gain: 2, gain_standard_error: 0.1, gain_ci95: [1.8, 2.2], effects: [{ effect: 'drag', where: 'world' }] };
    for (const document of [
      { verdict: 'not_in_library', horizons: [{}], ranking: [first] },
      { verdict: 'not_in_library', method: 'horizon', horizons: [{}], ranking: [first] },
    ]) {
      const read = readDocument(JSON.stringify(document));
      assert.equal(read.method, 'horizon');
      assert.equal(read.answer_gain.value, null);
      assert.equal(firstIsAnswer(read), false);
    }
    assert.equal(timesFloor({ fitted_ratio_to_floor: 1.5 }), 1.5);
    assert.equal(timesFloor({ ratio_to_floor: 2.5 }), 2.5);
    assert.equal(timesFloor({}), null);
  });

  it('which answer of a diagnosis comes first, as the terminal has it', async () => {
    const { firstIsAnswer, gainText, readDocument } = await pageModule('pages/diagnose_data.ts');
    const gain = (value) => ({ value, ci95: [value - 10, value + 10] });
    const outside = (best, free, formulas, more = {}) => ({
      verdict: 'not_in_library',
      ranking: [{ gain: best, gain_ci95: [best - 10, best + 10], effects: [{ effect: 'drag', where: 'world' }] }],
      answer_gain: gain(best),
      free_force: { gain: gain(free) },
      formulas: formulas.map((value) => ({ gain: gain(value) })),
      formulas_of_rest: false,
      ...more,
    });
    assert.equal(firstIsAnswer(outside(4000, 1000, [5000])), false);
    assert.equal(firstIsAnswer(outside(4000, 1000, [3000])), true);
    assert.equal(firstIsAnswer(outside(4000, 100, [5000])), true, 'nearly all that is to be gained');
    assert.equal(firstIsAnswer(outside(4000, 1000, [])), false);
    assert.equal(firstIsAnswer(outside(0, 0, [])), false, 'nothing is to be gained');
    assert.equal(firstIsAnswer(outside(4000, 100, [], { ranking: [{ gain: 4000, effects: [] }] })), false);
    const { answer_gain, ...before } = outside(4000, 1000, [3000]);
    assert.equal(answer_gain.value, 4000);
    assert.equal(firstIsAnswer(readDocument(JSON.stringify(before))), true, 'of a version that did not write it');
    assert.equal(firstIsAnswer(outside(9, 9, [], { verdict: 'effect_found' })), true);
    assert.equal(firstIsAnswer(outside(9, 9, [], { verdict: 'nothing_missing' })), false);
    assert.equal(gainText({ value: 7397, standard_error: 1458 }), '+7397 ± 2858');
    assert.equal(gainText({ value: -1.25, standard_error: 0.4 }), '−1.3 ± 0.8');
    assert.equal(gainText({ value: 12.3 }), '+12', 'of a version that did not write it');
  });

  const kRun = { experiment: 'walk', ending: 'not ended', ended: null, started: '2026-01-01T10:00:00Z' };
  const ended = (time) => ({ ending: 'done', ended: `2026-01-01T${time}Z` });

  it('the run that got on last, and whether it goes on', async () => {
    const { newestRun, ProgressWatch } = await pageModule('pages/run_progress.ts');
    const replicates = [
      { ...kRun, run: 1, replicate: 1, seconds: 50, ...ended('10:00:50') },
      { ...kRun, run: 2, replicate: 2, seconds: 5, models: 1 },
      { ...kRun, run: 3, replicate: 3, seconds: null, models: 0 },
    ];
    assert.equal(newestRun(replicates).run, 2, 'neither the one that has ended nor the one that has not begun');
    const later = { ...kRun, run: 4, replicate: 1, seconds: 9, started: '2026-01-01T11:00:00Z', ...ended('11:00:09') };
    assert.equal(newestRun([...replicates, later]).run, 4, 'a run that died hides none');
    const watch = new ProgressWatch();
    const now = (models) => replicates.map((one) => (one.run === 2 ? { ...one, models } : one));
    const standings = (all) => all.map((run) => watch.standing(run, all).is);
    watch.note(now(1));
    assert.deepEqual(standings(now(1)), ['ended', 'not known yet', 'not known yet']);
    watch.note([...now(2), later]);
    assert.equal(watch.choose([...now(2), later]).run, 2, 'what is seen to go on comes first');
    assert.deepEqual(standings(now(2)), ['ended', 'running', 'waiting']);
    for (let second = 0; second < 16; ++second) watch.tick();
    assert.deepEqual(watch.standing(now(2)[1], now(2)), { is: 'quiet', seconds: 16 });
    assert.equal(watch.choose([...now(2), later]).run, 4);
  });

  it('the time left, the pass under way included', async () => {
    const { secondsLeft } = await pageModule('pages/run_data.ts');
    // In pass n the models take 100 n s and the tests 100 s, as is assumed; in all 900 s.
    const rows = { evaluations: 100, test_evaluations: 10, models: 100, tests: 10 };
    const left = (more) => Math.round(secondsLeft({ ...kRun, ...rows, passes: 3, passes_done: 1, ...more }));
    assert.equal(left({ seconds: 200 }), 700);
    assert.equal(left({ seconds: 300, models: 150 }), 600);
    assert.equal(left({ seconds: 450, models: 200, tests: 15 }), 450);
    assert.equal(secondsLeft({ ...kRun, ...rows, passes: 3, passes_done: 0, seconds: 50 }), null);
  });

  it('bands of errors that begin at 0, and ticks where the data lie', async () => {
    const { meanBand } = await pageModule('pages/run_data.ts');
    const { logTicks } = await pageModule('kit/ticks.ts');
    const band = meanBand([0.001, 0.05].map((value) => ({ pass: 1, value })));
    assert.deepEqual([band.lower, band.counts], [[0], [2]]);
    assert.ok(meanBand([-1, 1].map((value) => ({ pass: 1, value }))).lower[0] < -1);
    assert.ok(logTicks(0.068, 0.18).filter((tick) => tick > 0.11 && tick < 0.13).length > 0);
  });
});
