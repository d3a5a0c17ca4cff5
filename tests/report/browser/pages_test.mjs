// Every page, from the file and from the server, on a diagnosis and on a quadruped's run; names that would be markup; a
// run that goes on while it is watched.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { copyFileSync, existsSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { pathToFileURL } from 'node:url';
import {
  at,
  copyExperiments,
  edit,
  folder,
  go,
  lacuna,
  newPage,
  noFaults,
  pause,
  program,
  serve,
  shortRun,
  shots,
  source,
  startBrowser,
  untilStored,
  upToDate,
} from './support.mjs';
import { pageModule } from './page_modules.mjs';

const url = (name) => pathToFileURL(at(name)).href;
let browser;
const servers = [];

const ensemble = ['--set', 'estimation.ensemble=3'];

before(async () => {
  copyExperiments();
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('add', 'first-steps.toml', 'coulomb_friction', '--where', 'joint.hinge', '--db', 'rig.db', '--quiet');
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('compare', 'damped-flap.toml', '--db', 'rig.db', '--quiet');
  lacuna('diagnose', 'damped-flap.toml', '--db', 'rig.db', '--quiet');
  lacuna('run', 'walk.toml', '--db', 'walk.db', '--replicates', '2', ...shortRun, ...ensemble, '--quiet');
  lacuna('report', 'rig.db', '--out', 'rig.html', '--quiet');
  lacuna('report', 'walk.db', '--out', 'walk.html', '--quiet');
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  for (const server of servers) await server.stop();
});

async function started(...words) {
  const server = await serve(...words);
  servers.push(server);
  return server;
}

const picture = (page, selector) => page.$eval(selector, (canvas) => canvas.toDataURL());
const shot = (page, name) => page.screenshot({ path: `${shots}/${name}.png`, fullPage: true });

/** What a phone does not show: wider than the page, and in no box of its own that scrolls sideways; a link to a page that
 *  is out of sight at first, or too small for a finger. */
function whatIsCut() {
  const { clientWidth } = document.documentElement;
  const scrolls = (node) =>
    node && (/auto|scroll/.test(getComputedStyle(node).overflowX) || scrolls(node.parentElement));
  const found = [];
  if (document.documentElement.scrollWidth > clientWidth) found.push('the page scrolls sideways');
  for (const node of document.querySelectorAll('body *')) {
    const { left, right, width, height } = node.getBoundingClientRect();
    if (width === 0 || height === 0 || node.closest('.found, .tabulator-header, title, option')) continue; // a table's header follows it
    if ((right > clientWidth + 1 || left < -1) && !scrolls(node.parentElement))
      found.push(`${node.tagName} ${node.className.baseVal ?? node.className}: ${left} to ${right}`);
  }
  for (const link of document.querySelectorAll('nav a')) {
    const { left, right, height } = link.getBoundingClientRect();
    if (left < 0 || right > clientWidth || height < 30) found.push(`link ${link.textContent}: ${left} to ${right}`);
  }
  return found;
}

/** Controls that a finger does not reach: out of sight, or over another one. */
function outOfReach() {
  const { clientWidth } = document.documentElement;
  const controls = [...document.querySelectorAll('main input, main select, main button, header button, header input')]
    .map((node) => ({ node, box: node.getBoundingClientRect() }))
    .filter(({ node, box }) => box.width > 0 && box.height > 0 && !node.closest('.tabulator'));
  const name = ({ node, box }) =>
    `${node.tagName} ${node.getAttribute('aria-label') ?? node.textContent.slice(0, 20)} at ${Math.round(box.left)} to ${Math.round(box.right)}`;
  const hidden = controls.filter(({ box }) => box.left < 0 || box.right > clientWidth + 1);
  const over = controls.filter((one, i) =>
    controls.some(({ node, box }, j) => {
      const [wide, high] = [
        Math.min(one.box.right, box.right) - Math.max(one.box.left, box.left),
        Math.min(one.box.bottom, box.bottom) - Math.max(one.box.top, box.top),
      ];
      const fixed = (of) => of.closest('header') !== null; // the page scrolls below it
      return j < i && wide > 1 && high > 1 && fixed(node) === fixed(one.node);
    }),
  );
  return [...hidden.map((one) => `out of sight: ${name(one)}`), ...over.map((one) => `over another: ${name(one)}`)];
}

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
      const moves = async (key) => {
        const before = await clock();
        await page.keyboard.press(key);
        await page.waitForFunction((old) => document.querySelector('.clock').textContent !== old, before);
      };
      await page.locator('button.primary').click();
      await page.locator('button.primary').click();
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

describe('a report', () => {
  it('opens the newest diagnosis, whatever it found, with one probability', async () => {
    await edit('rig.db', 'newest.db', (database) => {
      const [[text]] = database.exec('SELECT document FROM diagnosis ORDER BY id DESC LIMIT 1')[0].values;
      const newest = {
        ...JSON.parse(text),
        verdict: 'nothing_missing',
        probability: 0.93,
        calibrated: true,
        formulas: [],
      };
      const columns = database.exec("SELECT name FROM pragma_table_info('diagnosis')")[0].values.flat();
      const copied = columns.map((name) => ({ id: 'id + 1', document: '?' })[name] ?? name).join();
      database.run(`INSERT INTO diagnosis SELECT ${copied} FROM diagnosis ORDER BY id DESC LIMIT 1`, [
        JSON.stringify(newest),
      ]);
    });
    lacuna('report', 'newest.db', '--out', 'newest.html', '--quiet');
    const page = await newPage(browser);
    await go(page, url('newest.html'), '#/diagnose');
    assert.match(await page.textContent('.lead'), /Nothing is missing.*probability that this verdict is right: 0\.93 \(calibrated/);
    assert.doesNotMatch(await page.textContent('table.grid'), /weight/);
    noFaults(page);
    await page.close();
  });

  it('is small, and the same each time', () => {
    lacuna('report', 'rig.db', '--out', 'again.html', '--quiet');
    assert.ok(statSync(at('rig.html')).size < 3e6 + statSync(at('rig.db')).size);
    assert.ok(readFileSync(at('again.html')).equals(readFileSync(at('rig.html'))));
  });

  it('says where the fitted model fails, not the one as it is written', async () => {
    const document =
      '{"findings": [{"kind": "x", "share": 1, "sentence": "1 as written", "view": "error"}], "where": null}';
    await edit('rig.db', 'as-is.db', (database) => {
      const into = "INSERT INTO comparison SELECT max(id) + 1, revision, 'as_written', NULL, NULL, step, findings";
      database.run(`${into} FROM comparison WHERE revision = (SELECT max(revision) FROM comparison)`);
      database.run('INSERT INTO where_it_fails SELECT max(id), ? FROM comparison', [document]);
    });
    lacuna('report', 'as-is.db', '--out', 'as-is.html', '--quiet');
    const page = await newPage(browser);
    await go(page, url('as-is.html'), '#/compare?experiment=damped-flap');
    await page.waitForSelector('.finding');
    assert.doesNotMatch(await page.textContent('.findings'), /as written/);
    noFaults(page);
    await page.close();
  });

  it('tells a model that was not analysed from one whose error shows no pattern', async () => {
    for (const [name, change, said] of [
      ['not-analysed', 'DELETE FROM where_it_fails', /Not analysed for this revision/],
      [
        'no-pattern',
        `UPDATE where_it_fails SET document = json('{"findings": [], "where": {"views": []}}')`,
        /no significant dependence/,
      ],
    ]) {
      await edit('rig.db', `${name}.db`, (database) => database.run(change));
      lacuna('report', `${name}.db`, '--out', `${name}.html`, '--quiet');
      const page = await newPage(browser);
      await go(page, url(`${name}.html`), '#/compare?experiment=damped-flap');
      await page.waitForSelector('aside.side .empty');
      assert.match(await page.textContent('aside.side .empty'), said);
      noFaults(page);
      await page.close();
    }
  });

  it('survives a query without an end', async () => {
    const page = await newPage(browser);
    const endless = 'WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n';
    await go(page, url('rig.html'), '#/history');
    await page.goto(`${url('rig.html')}#/sql?q=${encodeURIComponent(endless)}`);
    await page.waitForFunction(() =>
      /longer than 10 s/.test(document.querySelector('[role=alert]')?.textContent ?? ''),
    );
    await page.keyboard.press('2');
    await page.waitForSelector('.trial-curves canvas');
    noFaults(page);
    await page.close();
  });

  it('says that a replay asked for is not in it', async () => {
    const page = await newPage(browser);
    await go(page, url('walk.html'), '#/replay?run=2&trial=99');
    assert.match(await page.textContent('main'), /No motion is stored for run 2, trial 99\./);
    assert.equal(await page.locator('.stage').count(), 0);
    noFaults(page);
    await page.close();
  });

  it('of a large database is a selection that says so', async () => {
    await edit('walk.db', 'large.db', (database) =>
      database.run(`
      WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 20000)
      INSERT INTO model SELECT (SELECT max(id) FROM model WHERE id >> 40 = 1) + i, (SELECT min(pass) FROM model), 0, NULL, NULL, zeroblob(800), 'full', 0, 1.0 FROM n`),
    );
    lacuna('report', 'large.db', '--out', 'large.html', '--most-megabytes', '5', '--no-robots', '--quiet');
    const page = await newPage(browser);
    await go(page, url('large.html'), '#/run?run=1');
    assert.match(await page.textContent('.notes'), /shows a selection of it, [0-4]\.\d MB/);
    const [{ models }] = JSON.parse(lacuna('sql', 'large.db', '--json', 'SELECT models FROM eea_runs WHERE run = 1'));
    assert.ok(models > 20_000);
    assert.ok((await page.textContent('.facts')).replace(/[^0-9a-z]/g, '').includes(`models${models}`));
    assert.equal(await page.locator('.figure-title:has-text("Spread")').count(), 0);
    assert.match(await page.textContent('.notes'), /The newest run is complete\. Of the other run, only the best models and tests of each pass are in this report/);
    await page.waitForSelector('.figure-title:has-text("Error of the best model")');
    await go(page, url('large.html'), '#/replay');
    assert.match(await page.textContent('.empty'), /--no-robots/);
    noFaults(page);
    await page.close();
  });

  it('shows the run that got on last, and experiments in their colours whatever is filtered', async () => {
    await edit('walk.db', 'dead.db', (database) => {
      database.run('UPDATE run SET ended = NULL, ending = NULL WHERE number = 1');
      database.run("UPDATE run SET started = '2020-01-01T00:00:00Z' WHERE number = 1");
      database.run("INSERT INTO experiment VALUES (99, 'walk-two')");
      database.run('UPDATE eea_run SET experiment = 99 WHERE run = 2');
    });
    lacuna('report', 'dead.db', '--out', 'dead.html', '--no-robots', '--quiet');
    const page = await newPage(browser);
    await go(page, url('dead.html'), '#/run');
    assert.match(await page.textContent('.lead'), /Run 2 of walk-two.*done/);
    await go(page, url('dead.html'), '#/run?run=1');
    assert.match(await page.textContent('.lead'), /not ended when this report was made/);
    await go(page, url('dead.html'), '#/runs');
    const colour = () => page.locator('.legend .key', { hasText: 'walk-two' }).first().getAttribute('class');
    const before = await colour();
    await page.locator('main .search').fill('walk-two');
    await page.waitForFunction(() => document.querySelector('main').textContent.includes('1 of 2 runs'));
    assert.equal(await colour(), before);
    noFaults(page);
    await page.close();
  });
});

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

describe('on other robots and machines', () => {
  it('robots of cylinders move, with their contacts', async () => {
    copyFileSync(join(source, 'experiments/topology-range-1.toml'), at('cylinders.toml'));
    const small = ['generations=2', 'population=10', 'pairs=5'].flatMap((one) => [
      '--set',
      `estimation.parameters.${one}`,
    ]);
    const words = ['--replicates', '1', '--set', 'experiment.passes=1', ...small, '--quiet'];
    lacuna('run', 'cylinders.toml', '--db', 'cylinders.db', ...words);
    lacuna('report', 'cylinders.db', '--out', 'cylinders.html', '--quiet');
    const page = await newPage(browser);
    await go(page, url('cylinders.html'), '#/replay');
    await page.waitForSelector('.stage canvas');
    assert.match(await page.textContent('main'), /and the target.*touch the ground are highlighted/s);
    await shot(page, 'cylinders');
    noFaults(page);
    await page.close();
  });

  it('a cart moves along its rail, model over target', async () => {
    copyFileSync(join(source, 'experiments/outside-cart-pole.toml'), at('cart.toml'));
    const target = '{kind="simulated",file="robots/cart-pole.toml",hidden={"body.cart.mass"={uniform=[0.5,2.0]}}}';
    const keys = [`target=${target}`, 'experiment.passes=1', 'estimation.parameters.generations=3'];
    lacuna('run', 'cart.toml', '--db', 'cart.db', ...keys.flatMap((one) => ['--set', one]), '--quiet');
    lacuna('report', 'cart.db', '--out', 'cart.html', '--quiet');
    const page = await newPage(browser);
    await go(page, url('cart.html'), '#/replay');
    await page.waitForSelector('.stage canvas');
    assert.match(await page.textContent('main'), /and the target/);
    const start = await picture(page, '.stage canvas');
    await page.locator('input[type=range]').fill('2');
    await page.waitForFunction((before) => document.querySelector('.stage canvas').toDataURL() !== before, start);
    await shot(page, 'cart');
    noFaults(page);
    await page.close();
  });

  it('a finger pans curves and leaves the page to scroll', async () => {
    const page = await newPage(browser, { hasTouch: true, viewport: { width: 390, height: 800 } });
    await go(page, url('rig.html'), '#/compare?experiment=damped-flap');
    await page.waitForSelector('.trial-curves canvas');
    await page.keyboard.press('+');
    await page.waitForTimeout(300);
    const before = await picture(page, '.trial-curves canvas');
    await page.evaluate(() => {
      const over = document.querySelector('.u-over');
      const touch = (type, x) => {
        const finger = new Touch({ identifier: 1, target: over, clientX: x, clientY: 100 });
        over.dispatchEvent(new TouchEvent(type, { touches: [finger], bubbles: true }));
      };
      touch('touchstart', 250);
      touch('touchmove', 150);
    });
    await page.waitForFunction((old) => document.querySelector('.trial-curves canvas').toDataURL() !== old, before);
    assert.equal(await page.$eval('.u-over', (over) => getComputedStyle(over).touchAction), 'pan-y');
    noFaults(page);
    await page.close();
  });
});

describe('hostile names', () => {
  const kNames = {
    experiment: '<script>window.bad = 1</script>',
    change: `"><img src=x onerror="window.bad = 2">`,
    trial: '\u202Eevil \u05D0\u05D1\u05D2 ' + 'long '.repeat(800),
    channel: `an'gle"</script><script>window.bad = 3</script>`,
    sentence: '<iframe srcdoc="<script>parent.bad = 4</script>"></iframe>',
  };
  it('are shown as what they are', async () => {
    await edit('rig.db', 'hostile.db', (database) => {
      const run = (sql, ...values) => database.run(sql, values);
      run('UPDATE experiment SET name = ? WHERE name = ?', kNames.experiment, 'damped-flap');
      run('UPDATE revision SET change = ?', kNames.change);
      run('UPDATE trial SET name = ? || id', kNames.trial);
      run('UPDATE comparison_score SET channel = ?', kNames.channel);
      run(
        "UPDATE trace SET channels = json_array(json_object('name', ?, 'unit', '<b>rad</b>')) WHERE kind <> 'commands'",
        kNames.channel,
      );
      run('UPDATE noise_floor SET channel = ?', kNames.channel);
      run("UPDATE where_it_fails SET document = json_set(document, '$.findings[0].sentence', ?)", kNames.sentence);
      run(
        "UPDATE diagnosis SET document = json_set(document, '$.formulas[0].text', ?, '$.findings[0]', ?)",
        kNames.sentence,
        kNames.change,
      );
      run('UPDATE run SET command = ?', kNames.sentence);
    });
    await edit('walk.db', 'hostile-walk.db', (database) => {
      const run = (sql, ...values) => database.run(sql, values);
      run("UPDATE experiment SET name = ? || char(0) || 'x'", kNames.experiment);
      run('UPDATE metric SET name = ? || id', kNames.sentence);
      run('UPDATE free_value SET address = ? || position, unit = ?', kNames.change, '<b>kg</b>');
      run('UPDATE objective_score SET name = ? || position', kNames.channel);
      run('UPDATE target_trial SET predicted_fitness = 0.1');
      run('UPDATE ensemble_model SET structure = ?', kNames.sentence);
      run('UPDATE pass SET stopped = ?', kNames.change);
      run('UPDATE run SET command = ?', kNames.sentence + kNames.trial);
    });
    for (const name of ['hostile', 'hostile-walk']) lacuna('report', `${name}.db`, '--out', `${name}.html`, '--quiet');
    const server = await started('hostile.db'),
      walk = await started('hostile-walk.db');
    for (const base of [url('hostile.html'), server.address, url('hostile-walk.html'), walk.address]) {
      const page = await newPage(browser);
      for (const one of ['overview', 'compare', 'diagnose', 'history', 'run', 'runs', 'replay', 'sql']) {
        await go(page, base, `#/${one}`);
        await page.waitForTimeout(100);
        assert.equal(await page.evaluate(() => window.bad), undefined, one);
        assert.equal(await page.locator('main script, main img, main iframe').count(), 0, one);
        const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(over <= 0, `${one} is ${over} px too wide`);
      }
      if (base.includes('walk') || base === walk.address) {
        await go(page, base, '#/run');
        for (const name of [kNames.experiment, kNames.sentence, kNames.change])
          await page.waitForFunction((wanted) => document.querySelector('main').textContent.includes(wanted), name);
      } else {
        await go(page, base, `#/compare?experiment=${encodeURIComponent(kNames.experiment)}`);
        assert.ok((await page.textContent('main')).includes(kNames.channel));
        await shot(page, 'hostile');
      }
      await go(
        page,
        base,
        `#/sql?q=${encodeURIComponent("SELECT 'a' || char(0) || '<b>b</b>' AS \"<i>x</i>\", '" + '<script>'.repeat(3) + "' AS y")}`,
      );
      await page.waitForSelector('.tabulator-row');
      assert.equal(await page.locator('.tabulator b, .tabulator i').count(), 0);
      const table = await page.textContent('.tabulator');
      for (const text of ['<i>x</i>', '<b>b</b>']) assert.ok(table.includes(text), `${text} is cut from ${table}`);
      noFaults(page);
      await page.close();
    }
  });
});

describe('the server', () => {
  it('answers only with its token, by its name, to its own pages, and reads only', async () => {
    const { address } = await started('rig.db');
    const { origin, searchParams } = new URL(address);
    const token = searchParams.get('token');
    assert.match(token, /^[0-9a-f]{32}$/);
    assert.equal((await fetch(`${origin}/`)).status, 403);
    assert.equal((await fetch(`${origin}/?token=${'0'.repeat(32)}`)).status, 403);
    assert.equal((await fetch(address)).status, 200);
    const ask = (path, body, headers = {}) =>
      fetch(`${origin}/${path}`, {
        method: 'POST',
        body: JSON.stringify(body),
        headers: { 'Content-Type': 'application/json', 'X-Lacuna-Token': token, ...headers },
      });
    const { request } = await import('node:http');
    const status = await new Promise((resolve) =>
      request(address, { headers: { Host: 'evil.example' } }, (answer) => resolve(answer.statusCode)).end(),
    );
    assert.equal(status, 403);
    const one = { sql: 'SELECT 1' };
    assert.equal((await ask('sql', one)).status, 200);
    assert.equal((await ask('sql', one, { 'X-Lacuna-Token': '' })).status, 403);
    assert.equal((await ask('sql', one, { Origin: 'http://evil.example' })).status, 403);
    assert.match((await (await ask('sql', one, { 'Content-Type': 'text/plain' })).json()).error, /application\/json/);
    assert.match((await (await ask('sql', { sql: "SELECT load_extension('x')" })).json()).error, /not authorized/);
    assert.equal((await (await ask('sql', { sql: 'SELECT * FROM run', most: 1 })).json()).cut, true);
  });

  it('can be opened from another page, as from a message, and not be framed by one', async () => {
    const { address } = await started('rig.db');
    writeFileSync(at('message.html'), `<a href="${address}#/history">open</a><iframe src="${address}"></iframe>`);
    const page = await newPage(browser);
    await page.goto(url('message.html'));
    await page.waitForTimeout(500);
    const framed = page.frames().find((one) => one !== page.mainFrame());
    assert.equal(await framed.locator('main').count(), 0);
    await page.locator('a').click();
    await page.waitForFunction(() => document.title.startsWith('History'));
    page.faults = page.faults.filter((one) => !/status of 403|in a frame/.test(one)); // it was refused
    noFaults(page);
    await page.close();
  });

  it('shows pages while endless queries run and wait', async () => {
    const { address } = await started('rig.db');
    const { origin, searchParams } = new URL(address);
    const headers = { 'Content-Type': 'application/json', 'X-Lacuna-Token': searchParams.get('token') };
    const gone = new AbortController();
    const endless = Array.from({ length: 16 }, (_, i) => {
      const sql = `WITH RECURSIVE n(i) AS (SELECT ${i} UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n`;
      const question = { method: 'POST', headers, body: JSON.stringify({ sql }), signal: gone.signal };
      return fetch(`${origin}/sql`, question).catch(() => null);
    });
    await pause(300);
    const page = await newPage(browser);
    const begin = Date.now();
    await go(page, address, '#/history');
    await page.waitForSelector('.side-by-side td');
    assert.ok(Date.now() - begin < 8000, `${Date.now() - begin} ms`);
    gone.abort();
    await Promise.all(endless);
    noFaults(page);
    await page.close();
  });

  it('elsewhere warns', async () => {
    const server = await started('rig.db', '--host', '0.0.0.0');
    assert.match(server.messages(), /warning: anybody who can reach/);
    assert.equal((await fetch(new URL(server.address).origin)).status, 403);
    const page = await newPage(browser);
    await go(page, server.address, '#/history');
    noFaults(page);
    await page.close();
  });

  it('follows a run to its end, and a database that is replaced', async () => {
    lacuna('run', 'walk.toml', '--db', 'live.db', ...shortRun, '--set', 'experiment.passes=1', '--quiet');
    const [server, unseen] = [await started('live.db'), await started('live.db')];
    const pages = [await newPage(browser), await newPage(browser)];
    for (const page of pages) {
      await go(page, server.address, '#/run');
      assert.match(await page.textContent('.facts'), /1 of 1/);
    }
    const words = ['--seed', '2', '--set', 'experiment.passes=5', '--quiet'];
    const run = spawn(program, ['run', 'walk.toml', '--db', 'live.db', ...shortRun, ...words], { cwd: folder });
    const ended = new Promise((resolve) => run.on('exit', resolve));
    const isSeen = async (page) => /Run 2 .*running/.test(await page.textContent('.lead'));
    while (run.exitCode === null && !(await Promise.all(pages.map(isSeen))).every(Boolean)) {
      await untilStored(unseen);
      run.kill('SIGSTOP'); // or a fast machine has done it before it is told of
      await upToDate(server, unseen);
      run.kill('SIGCONT');
    }
    for (const page of pages) assert.ok(await isSeen(page), await page.textContent('.lead'));
    assert.equal(await ended, 0);
    for (const page of pages) {
      await page.waitForFunction(() => /Run 2 .*done/.test(document.querySelector('.lead').textContent));
      assert.match(await page.textContent('.facts'), /5 of 5/);
    }
    const watcher = await newPage(browser);
    await go(watcher, server.address, '#/replay?run=1&trial=0');
    await watcher.waitForFunction(() => /the best of pass 1/.test(document.querySelector('main').textContent));
    rmSync(at('live.db'));
    for (const tail of ['-wal', '-shm']) if (existsSync(at(`live.db${tail}`))) rmSync(at(`live.db${tail}`));
    await pages[0].waitForSelector('.live.broken');
    lacuna('run', 'walk.toml', '--db', 'other.db', ...shortRun, '--set', 'experiment.passes=3', '--quiet');
    renameSync(at('other.db'), at('live.db'));
    await pages[0].waitForFunction(() => document.querySelector('.facts')?.textContent.includes('3 of 3'));
    // The same run and trial of another database is another replay.
    await watcher.waitForFunction(() => /the best of pass 3/.test(document.querySelector('main').textContent));
    noFaults(watcher);
    await watcher.close();
    await pages[1].close();
    await go(pages[0], server.address, '#/runs');
    noFaults(pages[0]);
    await pages[0].close();
  });

  it('shows a replicate that is under way, says when it stops, and follows the next run', async () => {
    copyFileSync(at('walk.db'), at('killed.db'));
    const begin = (...words) =>
      spawn(program, ['run', 'walk.toml', '--db', 'killed.db', '--quiet', ...words], { cwd: folder });
    const first = begin('--replicates', '4', '--threads', '1');
    const [server, unseen] = [await started('killed.db'), await started('killed.db')];
    const page = await newPage(browser);
    await page.clock.install();
    await page.goto(`${server.address}#/run`);
    await page.waitForFunction(() => /Run 3 .*running/.test(document.querySelector('.lead')?.textContent ?? ''));
    assert.match(await page.textContent('.facts'), /left, about/);
    first.kill('SIGKILL');
    await upToDate(server, unseen); // else the change would come after a gap of two minutes
    await page.clock.runFor(120_000); // beyond three times the longest gap of a busy machine
    assert.match(await page.textContent('.lead'), /no progress seen for .*--resume/);
    assert.doesNotMatch(await page.textContent('.facts'), /left, about|per second/);
    assert.equal(await new Promise((resolve) => begin(...shortRun, '--seed', '3').on('exit', resolve)), 0);
    await page.waitForFunction(() => /Run 7 .*done/.test(document.querySelector('.lead').textContent), null, {
      timeout: 90_000,
    });
    noFaults(page);
    await page.close();
  });

  it('leaves what a viewer does as it is when something else is stored', async () => {
    copyFileSync(at('rig.db'), at('seen.db'));
    const server = await started('seen.db');
    const page = await newPage(browser),
      other = await newPage(browser);
    await go(page, server.address, '#/compare?experiment=damped-flap&revision=1');
    await page.waitForSelector('.trial-curves canvas');
    await page.keyboard.press('+');
    await page.waitForTimeout(300);
    const zoomed = await picture(page, '.trial-curves canvas');
    await go(other, server.address, '#/runs');
    await other.waitForSelector('.tabulator-row');
    await other.evaluate(() => {
      document.querySelector('.tabulator').dataset.before = 'yes';
    });
    lacuna('fit', 'first-steps.toml', '--db', 'seen.db', '--quiet');
    await other.waitForFunction(() => /lacuna fit/.test(document.querySelector('.tabulator').textContent));
    assert.equal(await other.evaluate(() => document.querySelector('.tabulator').dataset.before), 'yes');
    await page.waitForTimeout(2500);
    assert.equal(await picture(page, '.trial-curves canvas'), zoomed);
    noFaults(page);
    await page.close();
    await other.close();
  });

  it('ends with Ctrl-C, and leaves nothing beside a database that it read alone', async () => {
    copyFileSync(at('rig.db'), at('alone.db'));
    const server = await serve('alone.db');
    await (await fetch(server.address)).text();
    assert.equal((await server.stop()).code, 0);
    lacuna('report', 'alone.db', '--out', 'alone.html', '--no-robots', '--quiet');
    for (const tail of ['-wal', '-shm']) assert.ok(!existsSync(at(`alone.db${tail}`)), tail);
    assert.ok(readFileSync(at('alone.db')).equals(readFileSync(at('rig.db'))));
  });

  it('waits for a database that is about to be made; a report refuses one that is empty', async () => {
    writeFileSync(at('none.db'), '');
    assert.throws(() => lacuna('report', 'none.db', '--out', 'none.html'), /none\.db: is empty/);
    assert.ok(!existsSync(at('none.html')));
    const starting = serve('late.db');
    await new Promise((resolve) => setTimeout(resolve, 300));
    copyFileSync(at('rig.db'), at('draft.db'));
    renameSync(at('draft.db'), at('late.db'));
    const server = await starting;
    assert.match(server.messages(), /waiting until .* makes late\.db/);
    assert.equal((await server.stop()).code, 0);
  });
});
