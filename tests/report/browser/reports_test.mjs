// Reports in one file: what is in them, what is said of what is not, other robots, names that would be markup.
import assert from 'node:assert/strict';
import { copyFileSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { browser, prepare } from './databases.mjs';
import {
  at,
  edit,
  go,
  lacuna,
  newPage,
  noFaults,
  picture,
  shot,
  source,
  started,
  url,
} from './support.mjs';

prepare();

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
