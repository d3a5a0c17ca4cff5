// How quick the pages are on large databases. What is promised is promised of a machine at rest: the limits grow with
// what else runs on this one. The figures are printed.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { statSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { pathToFileURL } from 'node:url';
import { at, copyExperiments, edit, go, lacuna, newPage, noFaults, serve, shortRun, startBrowser } from './support.mjs';

const slack = 1 + 2 * (loadavg()[0] / cpus().length);
const kFirstCurve = 1000, kFrame = 50; // ms
const kFrames = 60;
let browser, server;

before(async () => {
  console.log(`load ${loadavg()[0].toFixed(1)} on ${cpus().length} cores: limits times ${slack.toFixed(1)}`);
  copyExperiments();
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('run', 'walk.toml', '--db', 'walk.db', ...shortRun, '--quiet');
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

/** 31 000 models on 16 trials and more scores, as a run of the paper leaves them. */
const manyScores = (database) => database.run(`
  WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 31250)
  INSERT INTO model SELECT (SELECT max(id) FROM model) + i, (SELECT max(pass) FROM model), i / 1000, NULL, NULL, randomblob(136), 'full', 0, 1.0 + abs(random() % 1000) / 1000.0 FROM n;
  WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 14)
  INSERT INTO trial SELECT 100 + i, experiment, 'made up ' || i, '', printf('%064d', i), 0, 1.0, 10 FROM n, (SELECT experiment FROM trial LIMIT 1);
  WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 14)
  INSERT OR IGNORE INTO model_score SELECT model.id, 100 + i, (SELECT metric FROM model_score LIMIT 1), abs(random() % 1000000) / 1e6 FROM model, n;
  INSERT OR IGNORE INTO model_score SELECT model.id, trial.id, (SELECT metric FROM model_score LIMIT 1), abs(random() % 1000000) / 1e6 FROM model, trial WHERE trial.id >> 40 = 1;`);

const kSamples = 60_000, kChannels = 8;

/** A trial of 60 000 samples of 8 channels in the place of the first one. */
function longTrial(database) {
  const names = JSON.stringify(Array.from({ length: kChannels }, (_, c) => ({ name: `channel ${c}`, unit: 'rad' })));
  const times = new Uint8Array(Float64Array.of(0, 0.001).buffer);
  const series = (noise) => {
    const values = new Float32Array(kSamples * kChannels);
    for (let i = 0; i < values.length; ++i) values[i] = Math.sin(i / 8 / 900 + (i % 8)) + noise * Math.sin(i * 12.9898);
    return new Uint8Array(values.buffer);
  };
  const trial = database.exec('SELECT min(id) FROM trial')[0].values[0][0];
  const comparison = database.exec('SELECT max(id) FROM comparison')[0].values[0][0];
  database.run('DELETE FROM trace WHERE trial = ? AND (kind = ? OR comparison = ?)', [trial, 'measured', comparison]);
  const insert = "INSERT INTO trace (trial, comparison, kind, channels, sample_count, precision, times, samples, digest) VALUES (?, ?, ?, ?, ?, 'float32', ?, ?, printf('%064d', 1))";
  database.run(insert, [trial, null, 'measured', names, kSamples, times, series(0.05)]);
  database.run(insert, [trial, comparison, 'predicted', names, kSamples, times, series(0)]);
}

/** From the begin of loading to the first line that is painted, ms. */
async function firstCurve(page, address, selector) {
  await page.goto('about:blank');
  await page.goto(address, { waitUntil: 'commit' });
  await page.waitForSelector(selector, { state: 'attached' });
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => done(performance.now()))));
}

describe('speed', () => {
  it('the first curve of 500 000 scores comes within a second', async () => {
    await edit('walk.db', 'many.db', manyScores);
    lacuna('report', 'many.db', '--out', 'many.html', '--no-robots', '--quiet');
    const [{ scores }] = JSON.parse(lacuna('sql', 'many.db', '--json', 'SELECT count(*) AS scores FROM model_score'));
    assert.ok(scores >= 500_000, `${scores} scores`);
    server = await serve('many.db');
    const page = await newPage(browser);
    for (const [way, base] of [['file', pathToFileURL(at('many.html')).href], ['server', server.address]]) {
      const ms = await firstCurve(page, `${base}#/run`, '.chart path.line');
      console.log(`first curve from the ${way}: ${ms.toFixed(0)} ms (${scores} scores, ${(statSync(at('many.html')).size / 1e6).toFixed(1)} MB)`);
      assert.ok(ms < slack * kFirstCurve, `${ms} ms`);
    }
    noFaults(page);
  });

  it('60 000 samples of 8 channels pan without a long frame', async () => {
    await edit('rig.db', 'long.db', longTrial);
    lacuna('report', 'long.db', '--out', 'long.html', '--quiet');
    const page = await newPage(browser);
    await go(page, pathToFileURL(at('long.html')).href, '#/compare');
    await page.waitForFunction(() => document.querySelectorAll('.trial-curves canvas').length >= 16);
    await page.keyboard.press('+');
    await page.waitForTimeout(300);
    // What a frame takes of the page's own thread, whatever else the machine does meanwhile.
    const clock = await page.context().newCDPSession(page);
    await clock.send('Performance.enable', { timeDomain: 'threadTicks' });
    const worked = async () => (await clock.send('Performance.getMetrics')).metrics.find((one) => one.name === 'TaskDuration').value;
    const before = await worked();
    const frames = await page.evaluate((count) => new Promise((done) => {
      const times = [];
      let last = performance.now();
      const step = (now) => {
        times.push(now - last);
        last = now;
        if (times.length === count) return done(times.slice(2));
        dispatchEvent(new KeyboardEvent('keydown', { key: times.length % 20 < 10 ? 'ArrowRight' : 'ArrowLeft', bubbles: true }));
        requestAnimationFrame(step);
      };
      requestAnimationFrame(step);
    }), kFrames);
    const work = (1000 * (await worked() - before)) / kFrames;
    frames.sort((a, b) => a - b);
    const longest = frames[frames.length - 1];
    console.log(`frames while panning: ${work.toFixed(1)} ms of work, median ${frames[frames.length >> 1].toFixed(1)} ms apart, longest ${longest.toFixed(1)} ms`);
    assert.ok(work < kFrame, `${work} ms of work a frame`);
    assert.ok(longest < slack * kFrame, `${longest} ms`);
    noFaults(page);
  });
});
