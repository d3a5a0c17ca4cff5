// Every page, from the file and from the server, on a diagnosis and on a quadruped's run.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, describe, it } from 'node:test';
import { outOfReach, whatIsCut } from './layout.mjs';
import { browser, prepare } from './databases.mjs';
import {
  at,
  go,
  lacuna,
  newPage,
  noFaults,
  picture,
  shot,
  started,
  url,
} from './support.mjs';

prepare();

describe('the setup of a trial', () => {
  it('stands above its curves and in the table of errors', async () => {
    const recording = (file, set) => `[[target.recording]]\nfile = "data/servo_pendulum/${file}.csv"\n${set}\n`;
    const text = readFileSync(at('first-steps.toml'), 'utf8')
      .replace('name = "first-steps"', 'name = "loads"')
      .replace(/^(files|holdout) = .*\n/gm, '')
      .replace(
        '[target.time]',
        recording('sine', 'set = { "body.arm.mass" = "0.53 kg" }') +
          recording('steps', 'own = ["body.arm.mass"]') +
          recording('chirp', '') +
          '[target.time]',
      );
    writeFileSync(at('loads.toml'), text);
    lacuna('compare', 'loads.toml', '--quiet');
    lacuna('report', 'loads.db', '--out', 'loads.html', '--quiet');
    const page = await newPage(browser);
    const words = { 'sine.csv': 'body.arm.mass = 0.53 kg', 'steps.csv': 'body.arm.mass fitted to this trial only' };
    for (const [trial, said] of Object.entries(words)) {
      await go(page, url('loads.html'), `#/compare?trial=${trial}`);
      await page.waitForSelector('.trial-curves canvas');
      await page.waitForFunction(
        (line) => document.querySelector('.trial-curves')?.textContent.includes(line),
        `Setup of this trial: ${said}.`,
        { timeout: 10000 },
      );
      assert.ok((await page.locator('.errors tbody th', { hasText: trial }).textContent()).endsWith(said));
    }
    assert.equal(await page.locator('.errors tbody th', { hasText: 'chirp.csv' }).textContent(), 'chirp.csv');
    await shot(page, 'compare-setup');
    noFaults(page);
    await page.close();
  });
});

/** The same looks at a file and at a server. */
function pagesOf(way, open) {
  describe(`pages of ${way}`, () => {
    let rig, walk, page;
    before(async () => {
      [rig, walk] = await open();
      page = await newPage(browser);
    });
    after(async () => {
      noFaults(page);
      await page.close();
    });

    it('compare shows curves, zooms, and lights up what a finding speaks of', async () => {
      await go(page, rig, '#/compare?experiment=damped-flap&revision=1');
      await page.waitForSelector('.trial-curves canvas');
      assert.equal(await page.locator('.errors tbody tr').count(), 3);
      const whole = await picture(page, '.trial-curves canvas');
      await page.keyboard.press('+');
      await page.waitForFunction(
        (before) => document.querySelector('.trial-curves canvas').toDataURL() !== before,
        whole,
      );
      await page.keyboard.press('0');
      const box = await page.locator('.u-over').first().boundingBox();
      await page.mouse.move(box.x + 0.4 * box.width, box.y + 20);
      await page.mouse.down();
      await page.mouse.move(box.x + 0.6 * box.width, box.y + 30, { steps: 4 });
      await page.mouse.up();
      await page.waitForFunction(
        (before) => document.querySelector('.trial-curves canvas').toDataURL() !== before,
        whole,
      );
      assert.equal(await page.locator('.swatch-lit').count(), 0);
      await page.locator('.finding:not(:disabled)').first().click();
      await page.waitForSelector('.swatch-lit');
      assert.match(page.url(), /finding=0/);
      await page.locator('.errors .link', { hasText: 'swings' }).click();
      await page.waitForFunction(() =>
        document.querySelector('.trial-curves .figure-title')?.textContent.includes('swings'),
      );
      await page.locator('.regimes .link').first().click();
      await page.waitForFunction(() => /finding=\w+\.0/.test(location.hash));
      await shot(page, `compare-${way}`);
    });

    it('compare opens where the model is farthest off, and says what is not there', async () => {
      await go(page, rig, '#/compare?experiment=damped-flap');
      await page.waitForSelector('.trial-curves canvas');
      const title = await page.textContent('.trial-curves .figure-title');
      assert.ok((await page.textContent('.lead strong')).endsWith(` of ${title}`));
      await go(page, rig, '#/compare?experiment=first-steps&revision=99&trial=nope');
      const says = await page.textContent('main [role=status]');
      assert.match(says, /no revision 99 here.*no trial nope here.*This is revision 2 of first-steps/);
    });

    it('diagnose says the verdict, ranks, maps the force and tests features', async () => {
      await go(page, rig, '#/diagnose');
      assert.match(await page.textContent('.lead'), /Something is missing that no effect of the library explains/);
      await page.waitForSelector('.chart .whisker.thick', { state: 'attached' }); // a chart is drawn when it has its size
      assert.ok((await page.locator('.chart .whisker.thick').count()) >= 3);
      assert.ok((await page.locator('rect title').count()) > 10, 'a map of the force');
      assert.match(await page.textContent('main'), /position \/ rad/);
      assert.match(await page.textContent('main'), /q\^2\*v/);
      assert.match(await page.textContent('.chart .ink-predicted .row-name'), /q\^2\*v/, 'it wins');
      assert.equal(await page.locator('.chart .ink-predicted .row-name').count(), 1);
      assert.match(await page.textContent('main'), /change of error.*−\d+\.\d % \[/s);
      assert.doesNotMatch(await page.textContent('table.grid'), /weight/);
      await page.locator('button.link', { hasText: 'position' }).first().click();
      await page.waitForFunction(() => document.body.textContent.includes('over position'));
      await shot(page, `diagnose-${way}`);
    });

    it('history puts two revisions side by side', async () => {
      await go(page, rig, '#/history?experiment=first-steps');
      assert.match(await page.textContent('.lead'), /in 2 revisions/);
      await page.waitForSelector('.side-by-side td');
      assert.match(await page.textContent('.side-by-side'), /effect\.coulomb_friction\.torque/);
      assert.match(await page.textContent('.side-by-side'), /0\.535\d\d \[0\.53[45]\d\d, 0\.535\d\d\] kg/);
      await page.getByLabel('b: revision 1').click();
      await page.waitForFunction(
        () => !document.querySelector('.side-by-side')?.textContent.includes('coulomb_friction.torque'),
      );
      await shot(page, `history-${way}`);
      await go(page, rig, '#/history?experiment=damped-flap');
      assert.match(await page.textContent('.lead'), /^angle, held-out trials: [\d.]+ × the noise floor\.$/);
      await page.waitForSelector('.chart line.ink-floor', { state: 'attached' });
    });

    it('a run shows errors, transfer, objective errors and values; runs show replicates', async () => {
      await go(page, walk, '#/run?run=2');
      for (const title of [
        'Error of the best model',
        'True-parameter error: mass',
        'Transfer',
        'Spread',
        'Error on new trials',
        'Parameters and hidden values: delay',
        'Models carried over from pass 2',
      ])
        await page.waitForSelector(`.figure-title:has-text("${title}")`);
      assert.match(await page.textContent('.facts'), /2 of 2/);
      await shot(page, `run-${way}`);
      await go(page, walk, '#/runs');
      await page.waitForSelector('.tabulator-row');
      assert.match(await page.textContent('main'), /mean of 2 runs/);
      await page.keyboard.press('/');
      await page.keyboard.type('no such run');
      await page.waitForFunction(() => document.querySelector('main').textContent.includes('0 of 2 runs'));
      assert.match(await page.textContent('main'), /No run matches these words/);
      await shot(page, `runs-${way}`);
    });

    it('runs are found by what is shown, opened with Enter, and there again after going back', async () => {
      await go(page, walk, '#/runs');
      const score = (await page.textContent('.tabulator-row [tabulator-field=c6]')).trim();
      await page.locator('main .search').fill(`${score} done`);
      await page.waitForFunction(() => /filter=/.test(location.hash));
      assert.match(await page.textContent('main'), /[12] of 2 runs/);
      await page.locator('.pickable .tabulator-row').first().focus();
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => /#\/run\?run=2/.test(location.hash));
      await page.goBack();
      await page.waitForSelector('main .search');
      assert.equal(await page.inputValue('main .search'), `${score} done`);
    });

    it('what an address asks for and is not here is said', async () => {
      await go(page, walk, '#/run?run=77');
      assert.match(await page.textContent('main'), /no run 77 here/);
      await go(page, walk, '#/%E0%A4%A');
      assert.match(await page.textContent('main'), /no page “%E0%A4%A”/);
    });

    it('pictures of parameters have whole names, and files that say what is in them', async () => {
      await go(page, walk, '#/run?run=2');
      const figure = page.locator('.figure', { hasText: 'Parameters and hidden values: mass' }).last();
      await figure.locator('svg').waitFor();
      assert.ok((await figure.locator('svg').textContent()).includes('front_right_lower'));
      const csvOf = async (of) => {
        const click = of.locator('.download', { hasText: 'CSV' }).click();
        const [file] = await Promise.all([page.waitForEvent('download'), click]);
        return readFileSync(await file.path(), 'utf8');
      };
      const values = await csvOf(figure);
      assert.match(values, /^address,unit,pass,value,truth,/);
      assert.match(values, /\nbody\.front_right_lower\.mass,kg,1,/);
      await go(page, walk, '#/runs');
      const bands = await csvOf(page.locator('.figure', { hasText: 'True-parameter error by pass: mass' }).last());
      assert.match(bands, /\n"quadruped-parametric-smoke, run 1",1,/);
      assert.match(bands, /95 % interval",1,[\d.]+,0,[\d.]+,2\r/, 'of two runs it would begin below 0');
    });

    it('replay lists all trials, the last one too', async () => {
      const last = JSON.parse(lacuna('sql', 'walk.db', '--json', 'SELECT max(number) AS n FROM target_trial'))[0].n;
      await go(page, walk, `#/replay?run=2&trial=${last}`);
      await page.waitForSelector('.stage canvas');
      const listed = await page.locator('.choices option').allTextContents();
      for (let trial = 0; trial <= last; ++trial)
        assert.ok(
          listed.some((one) => one.includes(`run 2 · trial ${trial}`)),
          `trial ${trial} in ${listed}`,
        );
      assert.ok(listed.some((one) => one.startsWith(`run 2 · trial ${last} (transfer)`)));
    });

    it('replay plays, scrubs and steps', async () => {
      await go(page, walk, '#/replay?run=2&trial=0');
      await page.waitForSelector('.stage canvas');
      await page.waitForSelector('.trial-curves canvas');
      const start = await picture(page, '.stage canvas');
      await page.locator('input[type=range]').fill('0.5');
      await page.waitForFunction((before) => document.querySelector('.stage canvas').toDataURL() !== before, start);
      assert.match(await page.textContent('.clock'), /0\.50 s/);
      await shot(page, `replay-${way}`);
      await page.locator('.figure-title').first().click();
      await page.keyboard.press(' ');
      await page.waitForFunction(() => document.querySelector('.clock').textContent !== '0.50 s');
      await page.keyboard.press(' ');
      const clock = () => page.textContent('.clock');
      const rewind = () => page.locator('input[type=range]').fill('0.5'); // at the end no key moves it further
      const moves = async (key) => {
        const before = await clock();
        await page.keyboard.press(key);
        await page.waitForFunction((old) => document.querySelector('.clock').textContent !== old, before);
      };
      await page.locator('button.primary').click();
      await page.locator('button.primary').click();
      await rewind();
      await page.locator('.figure-title').first().click();
      await moves('Shift+ArrowRight');
      await page.keyboard.press(',');
      assert.equal(await page.inputValue('.player select'), '0.5');
      await page.keyboard.press(' ');
      await page.getByLabel('Pause', { exact: true }).waitFor();
      await page.keyboard.press(' ');
      await page.getByLabel('Play', { exact: true }).waitFor();
      const still = await clock();
      await page.getByLabel('Find').focus();
      await page.keyboard.type('a b.');
      await page.keyboard.press('ArrowLeft');
      assert.equal(await page.inputValue('.finder .search'), 'a b.');
      assert.equal(await clock(), still);
      await page.keyboard.press('Escape');
      await rewind();
      await page.locator('input[type=range]').focus();
      await moves('Shift+ArrowRight');
      await page.keyboard.press('6');
      await page.waitForFunction(() => document.title.startsWith('Runs'));
      await go(page, rig, '#/replay');
      await page.waitForSelector('.stage canvas');
      assert.match(await page.textContent('main'), /the measured motion/);
    });

    it('a picture of zoomed curves has all of them as they are, with a heading', async () => {
      await go(page, walk, '#/replay?run=2&trial=0');
      await page.waitForSelector('.trial-curves canvas');
      const last = () => page.$$eval('.trial-curves canvas', (all) => all[all.length - 1].toDataURL());
      const before = await last();
      await page.keyboard.press('+');
      await page.waitForTimeout(300);
      assert.equal(await last(), before, 'out of sight');
      const click = page.locator('.trial-curves .download').click();
      const [file] = await Promise.all([page.waitForEvent('download'), click]);
      assert.notEqual(await last(), before);
      const heights = await page.$$eval('.trial-curves canvas', (all) => all.map((one) => one.height));
      const heading = readFileSync(await file.path()).readUInt32BE(20) - heights.reduce((a, b) => a + b);
      assert.ok(heading > 50, `${heading} px for title, database and legend`);
      await page.keyboard.press('+');
      await page.waitForTimeout(300);
      const zoomed = await last();
      await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
      assert.notEqual(await last(), zoomed);
      const widths = () =>
        page.$$eval('.trial-curves .uplot', (all) => [...new Set(all.map((one) => one.clientWidth))]);
      assert.deepEqual(await widths(), [700]);
      await page.evaluate(() => dispatchEvent(new Event('afterprint')));
      await page.waitForTimeout(100);
      assert.ok((await widths())[0] > 1000);
    });

    it('paper has the query, the choices and the name of the database', async () => {
      const print = async (hash) => {
        await go(page, rig, hash);
        await page.emulateMedia({ media: 'print' });
      };
      await print(`#/sql?q=${encodeURIComponent('SELECT 41 + 1 AS answer')}`);
      assert.ok(await page.locator('pre', { hasText: 'SELECT 41 + 1 AS answer' }).isVisible());
      assert.ok(await page.locator('.views').isHidden());
      assert.ok(await page.locator('footer', { hasText: 'rig.db' }).isVisible());
      await print('#/compare?experiment=first-steps&trial=sine.csv');
      assert.ok(await page.locator('.choices strong', { hasText: 'sine.csv' }).isVisible());
      assert.ok(await page.locator('.choices select').first().isHidden());
      const adjust = await page.$eval('.errors td', (cell) => getComputedStyle(cell).printColorAdjust);
      assert.equal(adjust, 'exact');
      await page.emulateMedia({ media: 'screen' });
    });

    it('SQL begins with a picture of what there is', async () => {
      for (const [base, title] of [
        [rig, 'times_floor over revision'],
        [walk, 'error over pass'],
      ]) {
        await go(page, base, '#/sql');
        await page.waitForSelector('.tabulator-row');
        await page.waitForSelector(`.figure-title:has-text("${title}")`);
        await page.waitForFunction(() => document.querySelectorAll('.chart .point').length >= 2);
      }
    });

    it('SQL answers, plots, saves, and says what is wrong', async () => {
      await go(page, rig, '#/sql');
      await page.waitForSelector('.tabulator-row');
      await page
        .locator('textarea')
        .fill('SELECT sample, time, value FROM samples WHERE trace = (SELECT min(id) FROM traces) LIMIT 100');
      await page.keyboard.press('Control+Enter');
      await page.waitForFunction(() => document.querySelector('main').textContent.includes('100 rows'));
      await page.waitForSelector('.chart .line', { state: 'attached' });
      await page.locator('.select', { hasText: 'as' }).last().locator('select').selectOption('points');
      await page.waitForFunction(() => document.querySelectorAll('.chart .point').length === 100);
      await page.locator('.select', { hasText: 'x' }).first().locator('select').selectOption('time');
      await page.waitForFunction(() => document.querySelector('.chart').textContent.includes('time / s'));
      const [file] = await Promise.all([
        page.waitForEvent('download'),
        page.locator('.figure .download', { hasText: 'CSV' }).first().click(),
      ]);
      assert.equal(file.suggestedFilename(), 'query.csv');
      const [svg] = await Promise.all([
        page.waitForEvent('download'),
        page.locator('.download', { hasText: 'SVG' }).first().click(),
      ]);
      assert.match(svg.suggestedFilename(), /\.svg$/);
      await shot(page, `sql-${way}`);
      const run = async (sql) => {
        await page.locator('textarea').fill(sql);
        await page.locator('button[type=submit]').click();
      };
      for (const [bad, says] of [
        ['SELECT * FROM nowhere', /no such table: nowhere; see “Views”/],
        ['DELETE FROM run', /only reading is allowed/],
        ['selekt 1', /syntax error/],
        ["ATTACH 'x' AS y", /only reading is allowed/],
        ['/* 1 */ SELECT 1; -- 2\n PRAGMA query_only = OFF', /only reading is allowed/],
        ['WITH x AS (SELECT 1) DELETE FROM run', /only reading is allowed/],
        [' -- nothing', /there is no statement/],
      ]) {
        await run(bad);
        await page.waitForFunction(
          ([source]) => new RegExp(source).test(document.querySelector('[role=alert]')?.textContent ?? ''),
          [says.source],
        );
        assert.equal(await page.locator('.data-table, .chart').count(), 0, 'of the query before');
        await run('SELECT 1 AS one');
        await page.waitForSelector('.tabulator-row');
        assert.equal(await page.locator('[role=alert]').count(), 0);
        await run('');
        await page.waitForFunction(() => document.querySelector('main').textContent.includes('Type a query'));
        assert.equal(await page.locator('.data-table, .chart, [role=alert]').count(), 0, 'of the query before');
      }
      await run('SELECT 1e999 AS most, -1e999 AS least');
      await page.waitForFunction(() => /Infinity.*-Infinity/s.test(document.querySelector('.tabulator')?.textContent));
      await run('SELECT 9007199254740993 AS large, zeroblob(3) AS bytes');
      await page.waitForFunction(() => document.querySelector('.tabulator')?.textContent.includes('9007199254740993'));
      assert.match(await page.textContent('.tabulator-row'), /3 bytes/);
      await run('WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 60000) SELECT i FROM n');
      await page.waitForFunction(() => document.querySelector('main').textContent.includes('first 50 000 rows'));
      const [all] = await Promise.all([
        page.waitForEvent('download'),
        page.locator('.figure .download', { hasText: 'CSV' }).first().click(),
      ]);
      assert.match(readFileSync(await all.path(), 'utf8'), /\r\n60000\r\n$/);
      await page.locator('.views button', { hasText: 'revisions' }).first().click();
      await page.waitForSelector('.tabulator-row');
    });

    it('is led by keys and fits a phone, the dark and paper', async () => {
      await go(page, rig, '#/compare');
      for (const [key, title] of [
        ['3', 'Diagnose'],
        ['4', 'History'],
        ['8', 'SQL'],
        ['1', 'Overview'],
        ['2', 'Compare'],
      ]) {
        await page.keyboard.press(key);
        await page.waitForFunction((wanted) => document.title.startsWith(wanted), title);
      }
      await page.keyboard.press('/');
      await page.keyboard.type('first-steps revision 2');
      await page.waitForFunction(() => document.querySelectorAll('.found a').length >= 1);
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => /compare\?experiment=first-steps&revision=2/.test(location.hash));
      await page.keyboard.press('8');
      await page.waitForFunction(() => document.title.startsWith('SQL'));
      await page.setViewportSize({ width: 390, height: 844 });
      for (const [base, hash] of [
        ...['overview', 'compare', 'diagnose', 'replay', 'sql'].map((one) => [rig, `#/${one}`]),
        ...['damped-flap', 'first-steps'].map((one) => [rig, `#/history?experiment=${one}`]),
        ...['overview', 'run', 'runs', 'replay', 'sql'].map((one) => [walk, `#/${one}`]),
      ]) {
        await go(page, base, hash);
        await page.waitForTimeout(300);
        assert.deepEqual(await page.evaluate(whatIsCut), [], `${hash} on a phone`);
        assert.deepEqual(await page.evaluate(outOfReach), [], `${hash} on a phone`);
      }
      await page.emulateMedia({ colorScheme: 'dark' });
      await page.waitForFunction(() => getComputedStyle(document.body).backgroundColor === 'rgb(20, 23, 26)');
      await shot(page, `phone-${way}`);
      await page.evaluate(() => {
        const ground = () => getComputedStyle(document.body).backgroundColor;
        addEventListener('beforeprint', () => (window.paper = ground()), { once: true });
      });
      await page.pdf();
      assert.equal(await page.evaluate(() => window.paper), 'rgb(255, 255, 255)');
      assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(20, 23, 26)');
      await page.emulateMedia({ colorScheme: 'light', media: 'print' });
      assert.ok(await page.locator('header.top').isHidden());
      await page.emulateMedia({ media: 'screen' });
      await page.setViewportSize({ width: 1280, height: 900 });
    });
  });
}

pagesOf('file', async () => [url('rig.html'), url('walk.html')]);
pagesOf('server', async () => [(await started('rig.db')).address, (await started('walk.db')).address]);
