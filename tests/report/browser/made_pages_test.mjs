// Pages of databases that are made for the purpose: findings about one trial, long names, models without a truth, commands,
// databases that have one kind of result alone.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { pathToFileURL } from 'node:url';
import { at, copyExperiments, edit, go, lacuna, newPage, noFaults, shortRun, shots, startBrowser } from './support.mjs';
import { pageModule } from './page_modules.mjs';

const url = (name) => pathToFileURL(at(`${name}.html`)).href;
let browser, page;

before(async () => {
  copyExperiments();
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('add', 'first-steps.toml', 'coulomb_friction', '--where', 'joint.hinge', '--db', 'rig.db', '--quiet');
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('diagnose', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('run', 'walk.toml', '--db', 'walk.db', '--replicates', '2', ...shortRun, '--quiet');
  browser = await startBrowser();
  page = await newPage(browser);
});

after(async () => {
  noFaults(page);
  await browser?.close();
});

/** A report of `from` after `change`, opened at `hash`. */
async function made(name, from, change, hash) {
  await edit(from, `${name}.db`, change);
  lacuna('report', `${name}.db`, '--out', `${name}.html`, '--quiet', '--no-robots');
  await go(page, url(name), hash);
}

const report = (name) => {
  lacuna('report', `${name}.db`, '--out', `${name}.html`, '--quiet', '--no-robots');
  return url(name);
};

const kStretch = [1.0, 1.4]; // s, of steps.csv, which is not the trial that is farthest off
const kFindings = [
  {
    kind: 'regime',
    share: 0.8,
    sentence: '80 % of squared error in 5 % of samples: made',
    view: 'free_run',
    stretches: [
      { trial: 'sine.csv', spans: [[0.1, 0.11]] },
      { trial: 'steps.csv', spans: [kStretch] },
    ],
  },
  {
    kind: 'offset',
    share: 0.5,
    sentence: '50 % of squared error: angle is measured higher',
    view: 'free_run',
    channel: 'angle',
  },
];

describe('compare', () => {
  const withFindings = (name, hash) =>
    made(
      name,
      'rig.db',
      (database) =>
        database.run('UPDATE where_it_fails SET document = ?', [
          JSON.stringify({ findings: kFindings, where: { samples: 1, views: [] } }),
        ]),
      hash,
    );

  /** Times at both ends of what is shown. */
  async function shownTimes() {
    const box = await page.locator('.u-over').first().boundingBox();
    const at = async (share) => {
      await page.mouse.move(box.x + share * box.width, box.y + 30);
      await page.waitForFunction(() => /s: measured/.test(document.querySelector('.channel .readout')?.textContent));
      const [, number, unit] = /([\d.]+) (m?)s: measured/.exec(await page.textContent('.channel .readout'));
      return Number(number) * (unit === 'm' ? 1e-3 : 1);
    };
    return [await at(0.01), await at(0.99)];
  }

  it('opens on the trial and the time that a finding is about', async () => {
    await withFindings('finding', '#/compare?experiment=first-steps&revision=1&finding=0');
    await page.waitForSelector('.trial-curves canvas');
    assert.equal(await page.textContent('.trial-curves .figure-title'), 'steps.csv');
    const [from, to] = await shownTimes();
    assert.ok(from > 0.4 && from <= kStretch[0] && to >= kStretch[1] && to < 2.5, `${from} to ${to} s`);
    assert.equal(await page.locator('.swatch-lit').count(), 1);
  });

  it('goes to the trial of a finding that is clicked, and leaves the choice of another to the reader', async () => {
    await withFindings('clicked', '#/compare?experiment=first-steps&revision=1');
    await page.waitForSelector('.trial-curves canvas');
    assert.equal(await page.textContent('.trial-curves .figure-title'), 'sine.csv', 'farthest off');
    await page.locator('.finding').first().click();
    await page.waitForFunction(
      () => document.querySelector('.trial-curves .figure-title')?.textContent === 'steps.csv',
    );
    await page.locator('.select', { hasText: 'Trial' }).locator('select').selectOption('chirp.csv');
    await page.waitForFunction(
      () => document.querySelector('.trial-curves .figure-title')?.textContent === 'chirp.csv',
    );
    assert.match(await page.textContent('aside.side'), /The chosen finding has no samples in chirp\.csv/);
    await page.locator('.finding').nth(1).click();
    await page.waitForFunction(() => document.querySelector('.trial-curves .figure-title')?.textContent === 'sine.csv');
  });

  it('leads from an error to the moment where it is largest', async () => {
    await go(page, report('rig'), '#/compare?experiment=first-steps&revision=1');
    await page.waitForSelector('.errors td a');
    const cell = page.locator('.errors tr', { hasText: 'chirp.csv' }).locator('td a');
    const [, time, unit] = /([\d.]+) (m?)s/.exec(await cell.textContent());
    const moment = Number(time) * (unit === 'm' ? 1e-3 : 1);
    await cell.click();
    await page.waitForFunction(
      () => document.querySelector('.trial-curves .figure-title')?.textContent === 'chirp.csv',
    );
    const [from, to] = await shownTimes();
    assert.ok(from < moment && moment < to && to - from < 2, `${moment} s in ${from} to ${to} s`);
  });

  it('says where an address asks for a finding or a channel that is not here', async () => {
    await go(page, url('rig'), '#/compare?experiment=first-steps&finding=99&channel=nope');
    await page.waitForFunction(() =>
      /no finding 99 here/.test(document.querySelector('main [role=status]')?.textContent),
    );
    assert.match(await page.textContent('main [role=status]'), /no channel nope here/);
  });

  it('shows the commands over the same times as the readings', async () => {
    await go(page, url('rig'), '#/compare?experiment=first-steps&revision=1');
    await page.waitForSelector('.commands canvas');
    assert.match(await page.textContent('.commands .channel-head'), /command.*motor/s);
    const places = await page.$$eval('.trial-curves .u-over', (all) =>
      all.map((one) => one.getBoundingClientRect()).map(({ left, right }) => `${left} ${right}`),
    );
    assert.equal(new Set(places).size, 1, 'one time axis');
    await page.keyboard.press('+');
    await page.mouse.move(10, 10);
    const box = await page.locator('.commands .u-over').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 20);
    await page.waitForFunction(() =>
      /motor: .*N·m/.test(document.querySelector('.commands .channel-head')?.textContent),
    );
    await page.screenshot({ path: `${shots}/compare-commands.png`, fullPage: true });
  });

  it('shows what was measured where the prediction is the same', async () => {
    await made(
      'same',
      'rig.db',
      (database) =>
        database.run(`UPDATE trace SET (times, samples, precision, sample_count, channels) =
          (SELECT times, samples, precision, sample_count, channels FROM trace AS measured
           WHERE measured.trial = trace.trial AND measured.kind = 'measured') WHERE kind = 'predicted'`),
      '#/compare?experiment=first-steps&revision=1',
    );
    await page.waitForSelector('.trial-curves canvas');
    const shares = await page.$eval('.trial-curves canvas', (canvas) => {
      const ink = (name) =>
        [1, 3, 5].map((at) =>
          parseInt(
            getComputedStyle(document.documentElement)
              .getPropertyValue(`--${name}`)
              .trim()
              .slice(at, at + 2),
            16,
          ),
        );
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      const count = (colour) => {
        let pixels = 0;
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3] > 200 && colour.every((one, c) => Math.abs(data[i + c] - one) < 25)) ++pixels;
        return pixels;
      };
      return { measured: Math.max(count(ink('measured')), count(ink('broad'))), predicted: count(ink('predicted')) };
    });
    assert.ok(shares.measured > 500, JSON.stringify(shares));
    assert.ok(shares.predicted > 200, JSON.stringify(shares));
  });

  it('has no legend of what is not there', async () => {
    await made(
      'unpredicted',
      'rig.db',
      (database) => database.run("DELETE FROM trace WHERE kind IN ('predicted', 'commands')"),
      '#/compare?experiment=first-steps&revision=1',
    );
    await page.waitForSelector('.trial-curves canvas');
    assert.deepEqual(await page.$$eval('.trial-curves .key', (all) => all.map((one) => one.textContent.trim())), [
      'measured',
    ]);
  });
});

describe('candidates of a diagnosis', () => {
  const effect = (name, where) => ({ effect: name, where, parameters: {} });
  const hip = (side) => `joint.${side}_hip_flexion_extension`;
  const set = (side, last) => [
    effect('coulomb_friction', hip(side)),
    effect('cogging_torque', hip(side)),
    effect(last, hip(side)),
  ];
  const ranking = [
    set('left', 'joint_compliance'),
    set('left', 'joint_backlash'),
    set('right', 'joint_compliance'),
  ].map((effects, i) => ({
    effects,
    class: [],
    cv_rmse: {},
    ratio_to_floor: 1,
    segment_s: 1,
    gain: 9 - i,
    gain_standard_error: 1,
    gain_ci95: [7 - i, 11 - i],
  }));
  const names = ranking.map(({ effects }) => effects.map((one) => `${one.effect} @ ${one.where}`).join(' + '));

  for (const width of [1280, 390])
    it(`have their whole names, within the picture, at ${width} px`, async () => {
      await page.setViewportSize({ width, height: 900 });
      await made(
        `names-${width}`,
        'rig.db',
        (database) =>
          database.run(
            "UPDATE diagnosis SET document = json_set(document, '$.ranking', json(?), '$.verdict', 'effect_found')",
            [JSON.stringify(ranking)],
          ),
        '#/diagnose',
      );
      await page.waitForSelector('.chart .row-name', { state: 'attached' });
      const shown = await page.$$eval('.row-name', (all) =>
        all.map((one) => {
          const frame = one.ownerSVGElement.getBoundingClientRect();
          const lines = [...one.querySelectorAll('tspan')].map((line) => line.getBoundingClientRect());
          return {
            text: [...one.querySelectorAll('tspan')].map((line) => line.textContent).join(''),
            whole: one.querySelector('title').textContent,
            inside: lines.every((line) => line.left >= frame.left - 1 && line.right <= frame.right + 1),
            top: Math.min(...lines.map((line) => line.top)),
            bottom: Math.max(...lines.map((line) => line.bottom)),
          };
        }),
      );
      const bare = (text) => text.replace(/ /g, '');
      assert.deepEqual(
        shown.map((one) => bare(one.text)),
        names.map(bare),
      );
      assert.deepEqual(
        shown.map((one) => one.whole),
        names,
      );
      assert.ok(
        shown.every((one) => one.inside),
        JSON.stringify(shown),
      );
      shown.slice(1).forEach((one, i) => assert.ok(one.top >= shown[i].bottom - 1, 'rows do not overlap'));
      await page.screenshot({ path: `${shots}/diagnose-names-${width}.png`, fullPage: true });
      await page.setViewportSize({ width: 1280, height: 900 });
    });
});

describe('a run whose truth nobody knows', () => {
  it('has no picture of a way to the truth and no column of it', async () => {
    await made(
      'unknown',
      'walk.db',
      (database) => {
        database.run('UPDATE free_value SET truth = NULL');
        database.run('DELETE FROM objective_score');
      },
      '#/run?run=2',
    );
    await page.waitForSelector('.figure-title:has-text("Parameters by pass: mass")');
    const text = await page.textContent('main');
    assert.doesNotMatch(text, /truth/);
    assert.doesNotMatch(text, /off by/);
  });

  it('says in what unit its error is', async () => {
    const { scoreUnit } = await pageModule('pages/score_unit.ts');
    const angles = [
      { name: 'hip', unit: 'rad' },
      { name: 'knee', unit: 'rad' },
    ];
    assert.equal(scoreUnit('mean_absolute_difference', angles).unit, 'rad');
    const mixed = scoreUnit('mean_absolute_difference', [...angles, { name: 'motor', unit: 'N*m' }]);
    assert.deepEqual(mixed, { unit: '1', channels: 'hip (rad), knee (rad), motor (N·m)' });
    assert.equal(scoreUnit('a_metric_of_a_plugin', angles).unit, '1');
    await go(page, report('walk'), '#/run?run=2');
    await page.waitForFunction(() => /Measured: touch_front_left/.test(document.querySelector('main').textContent));
  });
});

describe('the overview', () => {
  const kNoDiagnoses = ['candidate_model', 'diagnosis'];
  const kNoComparisons = ['where_it_fails', 'noise_floor', 'comparison_score', 'numerical_error', 'comparison'];
  const without = (tables) => (database) => {
    for (const table of tables) database.run(`DELETE FROM ${table}`);
  };
  const links = () => page.$$eval('.page-links a', (all) => all.map((one) => one.textContent.split(':')[0]));

  it('comes first, says the newest verdict, the errors and what to do next', async () => {
    await go(page, report('rig'), '');
    assert.match(await page.title(), /^Overview/);
    assert.equal(await page.textContent('.experiment-name'), 'first-steps');
    assert.match(await page.textContent('.experiment .lead'), /Nothing is missing.*revision 2/);
    assert.match(await page.textContent('.next'), /the loop ends here/);
    const rows = await page.$$eval('.experiment tbody tr', (all) => all.map((one) => one.textContent));
    assert.equal(rows.length, 2);
    assert.match(rows[0], /^1.*14\.\d mradheld out 13\.\d mrad, 13\.\d × floor/);
    assert.match(rows[1], /coulomb_friction.*14\.\d mrad → \d\d\d µradheld out \d\d\d µrad, 0\.\d\d × floor/);
    assert.deepEqual(await links(), ['Compare', 'Diagnose', 'History', 'Replay', 'SQL']);
    await page.screenshot({ path: `${shots}/overview.png`, fullPage: true });
    await page.locator('.experiment .lead a').click();
    await page.waitForFunction(() => document.title.startsWith('Diagnose'));
  });

  it('advises a diagnosis where comparisons are all there is', async () => {
    await made(
      'compared',
      'rig.db',
      (database) => {
        without(kNoDiagnoses)(database);
        database.run(
          'DELETE FROM comparison_score WHERE comparison IN (SELECT comparison.id FROM comparison JOIN revision ON revision.id = revision WHERE number = 2)',
        );
      },
      '',
    );
    assert.match(await page.textContent('.next'), /Revision 2 has not been compared.*lacuna compare first-steps\.toml/);
    await made(
      'compared-once',
      'rig.db',
      (database) => {
        without(kNoDiagnoses)(database);
        database.run('DELETE FROM revision WHERE number = 2');
      },
      '',
    );
    assert.match(
      await page.textContent('.next'),
      /1\d\.\d × the noise floor: something is missing.*lacuna diagnose first-steps\.toml/,
    );
    assert.deepEqual(await links(), ['Compare', 'History', 'Replay', 'SQL']);
  });

  it('has the verdict where diagnoses are all there is', async () => {
    await made('diagnosed', 'rig.db', without(kNoComparisons), '');
    assert.match(await page.textContent('.experiment .lead'), /Nothing is missing/);
    assert.deepEqual(await links(), ['Diagnose', 'History', 'SQL']);
  });

  it('has the newest run where runs are all there is', async () => {
    await go(page, report('walk'), '');
    assert.match(await page.textContent('.experiment'), /Run [12]: done, 2 of 2 passes.*All 2 runs/);
    assert.match(await page.textContent('.next'), /lacuna predict walk\.toml --test/);
    assert.deepEqual(await links(), ['Run', 'Runs', 'Replay', 'SQL']);
  });

  it('says what to do where there is nothing', async () => {
    await made(
      'nothing',
      'rig.db',
      (database) => {
        const tables = database
          .exec("SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'schema%'")[0]
          .values.flat();
        without(tables)(database);
      },
      '',
    );
    assert.match(await page.textContent('main'), /no experiment yet.*lacuna compare FILE/);
    for (const name of ['compare', 'diagnose', 'history', 'run', 'runs', 'replay', 'sql'])
      await go(page, url('nothing'), `#/${name}`);
  });

  it('names the command that follows from each verdict', async () => {
    const { nextStep } = await pageModule('pages/overview_data.ts');
    const document = (verdict, more = {}) => ({
      verdict,
      ranking: [],
      horizons: [],
      formulas: [],
      findings: [],
      next_test: '',
      formulas_of_rest: false,
      effect_filter: [],
      evidence: {},
      answer_gain: { value: 0 },
      free_force: { gain: { value: 0 } },
      ...more,
    });
    const commandAfter = (verdict, more) =>
      nextStep({
        name: 'rig',
        file: 'my rig.toml',
        revisions: [{ experiment: 'rig', number: 3, change: '' }],
        errors: [],
        advice: [],
        runs: [],
        diagnosis: { id: 1, revision: 3, document: document(verdict, more) },
      }).command;
    const found = (...effects) => ({ ranking: [{ gain: 9, effects }] });
    const friction = { effect: 'coulomb_friction', where: 'joint.hinge' };
    assert.equal(
      commandAfter('effect_found', found(friction)),
      "lacuna add 'my rig.toml' coulomb_friction --where joint.hinge",
    );
    assert.equal(
      commandAfter('effect_found', found({ effect: 'air_drag', where: 'world' })),
      "lacuna add 'my rig.toml' air_drag",
    );
    assert.equal(commandAfter('effect_found', found(friction, friction)), "lacuna add 'my rig.toml' --answer");
    assert.equal(commandAfter('nothing_missing'), undefined);
    assert.equal(
      commandAfter('not_in_library', { formulas: [{ text: '-0.1*v*abs(v)', gain: { value: 9 } }] }),
      "lacuna plugins new effect NAME --formula '-0.1*v*abs(v)'",
    );
    assert.equal(
      commandAfter('cannot_tell', {
        next_test: 'triangle motor 0.3 N*m 0.1 Hz 20 s',
        next_test_setup: { name: 'heavy' },
      }),
      "lacuna trial 'my rig.toml' --test 'triangle motor 0.3 N*m 0.1 Hz 20 s' --setup heavy --csv=next.csv",
    );
    assert.equal(commandAfter('cannot_tell', { stopped: { during: 'x' } }), "lacuna diagnose 'my rig.toml'");
    assert.equal(
      commandAfter('nothing_missing', { effect_filter: ['backlash'], hypotheses: 1 }),
      "lacuna diagnose 'my rig.toml'",
      'all other effects are left',
    );
  });

  /** A rig of two revisions, the second of which has an error of 1.3 floors on its held-out files. */
  const compared = (advice, diagnosed) => ({
    name: 'rig',
    file: 'rig.toml',
    revisions: [1, 2].map((number) => ({ experiment: 'rig', number, change: '' })),
    errors: [{ revision: 2, channel: 'angle', unit: 'rad', fit_rmse: 2, held_out_rmse: 1.3, times_floor: 1.3 }],
    advice: advice ? [{ revision: 2, ...advice }] : [],
    runs: [],
    diagnosis: { id: 1, revision: diagnosed, document: { verdict: 'nothing_missing', ranking: [], effect_filter: [] } },
  });

  it('takes what the initial-state uncertainty explains for no missing effect', async () => {
    const { nextStep } = await pageModule('pages/overview_data.ts');
    const explained = { result: 'Error is 2.8 × the noise floor. It is explained', next: '', is_explained: 1 };
    assert.deepEqual(nextStep(compared(explained, 1)), {
      sentence: 'Confirm with a diagnosis of revision 2. Error is 2.8 × the noise floor. It is explained.',
      command: 'lacuna diagnose rig.toml',
    });
    assert.deepEqual(nextStep(compared(explained, 2)), { sentence: 'Nothing to add: the loop ends here.' });
    assert.match(nextStep(compared(null, 2)).sentence, /the held-out error of angle is 1\.30 × the noise floor/);
    const missing = { result: 'Something is missing.', next: 'lacuna diagnose rig.toml', is_explained: 0 };
    assert.deepEqual(nextStep(compared(missing, 1)), {
      sentence: 'Find the missing effect. Something is missing.',
      command: 'lacuna diagnose rig.toml',
    });
    assert.equal(nextStep(compared(null, 1)).command, 'lacuna compare rig.toml', 'of an older version');
    assert.doesNotMatch(nextStep(compared(null, 1)).sentence, /something is missing/);
  });

  it('says what was found in an earlier revision as of that revision', async () => {
    const { verdictOfRevision, verdictSentence, filterSentence } = await pageModule('pages/diagnose_data.ts');
    const found = {
      verdict: 'effect_found',
      effect_filter: [],
      ranking: [{ effects: [{ effect: 'drag', where: 'joint.hinge' }] }],
    };
    assert.equal(verdictOfRevision(found, 1), 'Revision 1 lacked drag @ joint.hinge.');
    assert.equal(verdictSentence(found), 'The model is missing drag @ joint.hinge.');
    const filtered = { verdict: 'nothing_missing', effect_filter: ['drag', 'backlash'], hypotheses: 2, ranking: [] };
    assert.match(verdictSentence(filtered), /^No missing effect was found: none of the effects that were tried/);
    assert.match(filterSentence(filtered), /^Only 2 candidates were tried \(--among drag backlash\)\./);
    assert.equal(filterSentence({ ...filtered, effect_filter: [] }), '');
  });
});

describe('labels and ticks', () => {
  it('names that are too long stay different', async () => {
    const { labelLines, shortened, wrapped } = await pageModule('kit/labels.ts');
    const long = (middle) => `body.front_left_leg.${'very_'.repeat(12)}${middle}.${'long_'.repeat(12)}mass`;
    const names = ['upper', 'lower', 'upper_b'].map(long);
    for (const letters of [12, 20, 40]) {
      const texts = shortened(names, letters);
      assert.equal(new Set(texts).size, names.length, texts.join());
    }
    assert.ok(shortened(names, 40).every((one) => one.length <= 40));
    assert.equal(new Set(labelLines(names, 16, 3).map(String)).size, 3);
    assert.deepEqual(wrapped('coulomb_friction @ joint.hinge + backlash @ joint.hinge', 32), [
      'coulomb_friction @ joint.hinge +',
      'backlash @ joint.hinge',
    ]);
    assert.deepEqual(wrapped('abcdefgh', 3), ['abc', 'def', 'gh']);
  });

  it('numbers of a logarithmic axis stay apart', async () => {
    const { logTicks, apartTicks } = await pageModule('kit/ticks.ts');
    for (const [low, high] of [
      [0.9, 11],
      [1e-12, 1e12],
      [0.11, 0.18],
      [1e-300, 1e300],
      [1, 1000],
      [3, 13],
    ])
      for (const apart of [0.04, 0.08, 0.2]) {
        const ticks = logTicks(low, high, apart);
        assert.ok(ticks.length >= 1, `${low} to ${high}`);
        ticks
          .slice(1)
          .forEach((tick, i) =>
            assert.ok(
              Math.log(tick / ticks[i]) >= 0.99 * apart * (Math.log(high) - Math.log(low)),
              `${ticks} of ${low} to ${high}`,
            ),
          );
      }
    assert.deepEqual(logTicks(0.95, 11, 0.01), [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
    assert.deepEqual(
      apartTicks([-10, 0, 10, 100], (tick) => tick, 20, 0),
      [0, 100],
    );
  });
});
