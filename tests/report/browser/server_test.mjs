// The server of the pages: whom it answers, and a run that goes on while it is watched.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { copyFileSync, existsSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { browser, prepare } from './databases.mjs';
import {
  at,
  folder,
  go,
  lacuna,
  newPage,
  noFaults,
  pause,
  picture,
  program,
  serve,
  shortRun,
  started,
  untilStored,
  upToDate,
  url,
} from './support.mjs';

prepare();

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
