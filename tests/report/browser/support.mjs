// What the tests of the pages share: the program, the browser, and databases to look at.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { copyFileSync, cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const env = (name) => process.env[name] ?? '';
export const program = env('LACUNA_PROGRAM');
export const source = env('LACUNA_SOURCE');
export const shots = env('LACUNA_SHOTS');
const require = createRequire(join(env('LACUNA_WEB'), 'package.json'));
const kSkipped = 77;

if (!existsSync(env('LACUNA_CHROMIUM'))) {
  console.log('Skipped\nthere is no chromium: apt-get install chromium');
  process.exit(kSkipped);
}

export const folder = mkdtempSync(join(tmpdir(), 'lacuna-pages-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
mkdirSync(shots, { recursive: true });

export const at = (name) => join(folder, name);
export const url = (name) => pathToFileURL(at(name)).href;
export const picture = (page, selector) => page.$eval(selector, (canvas) => canvas.toDataURL());
export const shot = (page, name) => page.screenshot({ path: `${shots}/${name}.png`, fullPage: true });

export function lacuna(...words) {
  return execFileSync(program, words, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** Both experiments that the databases are made of. */
export function copyExperiments() {
  for (const file of ['first-steps.toml', 'damped-flap.toml'])
    copyFileSync(join(source, 'experiments', file), at(file));
  for (const part of ['robots', 'data']) cpSync(join(source, 'experiments', part), at(part), { recursive: true });
  copyFileSync(join(source, 'experiments/smoke/quadruped-parametric.toml'), at('walk.toml'));
}

export const shortRun = [
  '--set',
  'experiment.passes=2',
  '--set',
  'estimation.parameters.generations=4',
  '--set',
  'exploration.parameters.generations=3',
];

export async function startBrowser() {
  const { chromium } = require('playwright-core');
  return chromium.launch({
    executablePath: env('LACUNA_CHROMIUM'),
    headless: true,
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
    ],
  });
}

/** A page that may ask 127.0.0.1 alone, and whose errors are errors of the test. */
export async function newPage(browser, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(`exception: ${error.message}`));
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(`console: ${message.text()}`);
  });
  page.on('request', (request) => {
    if (!/^(file:|data:|blob:|http:\/\/127\.0\.0\.1[:/])/.test(request.url()))
      page.faults.push(`asks ${request.url()}`);
  });
  page.setDefaultTimeout(20_000);
  return page;
}

export const noFaults = (page) => assert.deepEqual(page.faults, []);

export async function go(page, base, hash) {
  await page.goto('about:blank');
  await page.goto(base + hash);
  await page.waitForSelector('main *');
  await page.waitForFunction(() => !document.querySelector('.loading'));
}

/** A server of the program; `stop` ends it and says how it ended. */
export async function serve(database, ...more) {
  const child = spawn(program, ['serve', database, ...more], { cwd: folder });
  let out = '',
    err = '';
  child.stderr.on('data', (text) => {
    err += text;
  });
  const address = await new Promise((resolve, reject) => {
    child.stdout.on('data', (text) => {
      out += text;
      if (out.includes('\n')) resolve(out.slice(0, out.indexOf('\n')));
    });
    child.on('exit', () => reject(new Error(err)));
  });
  const stop = () =>
    new Promise((resolve) => {
      child.on('exit', (code) => resolve({ code, err }));
      child.kill('SIGINT');
    });
  return { address, stop, messages: () => err };
}

const servers = [];

/** A server that `stopServers` ends. */
export async function started(...words) {
  const server = await serve(...words);
  servers.push(server);
  return server;
}

export async function stopServers() {
  for (const server of servers) await server.stop();
}

export const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

async function stampOf({ address }) {
  const { origin, searchParams } = new URL(address);
  const headers = { 'Content-Type': 'application/json', 'X-Lacuna-Token': searchParams.get('token') };
  return (await (await fetch(`${origin}/state`, { method: 'POST', headers, body: '{}' })).json()).stamp;
}

/** Waits until a program has stored something: `unseen` is a server without viewers, which tells at once. */
export async function untilStored(unseen) {
  const before = await stampOf(unseen);
  while ((await stampOf(unseen)) === before) await pause(20);
}

/** Waits until the viewers of a server show the database as it is: it tells them of a change late, so that a run is not
 *  slowed, whereas one without viewers, `unseen`, tells at once. */
export async function upToDate(server, unseen) {
  while ((await stampOf(server)) !== (await stampOf(unseen))) await pause(200);
  await pause(2000); // pages ask every second, and then for what they show
}

let sqlJs = null;
/** Changes a database with SQL; `work` gets one of sql.js. */
export async function edit(file, to, work) {
  sqlJs ??= await require('sql.js')({
    locateFile: (name) => join(env('LACUNA_WEB'), 'node_modules/sql.js/dist', name),
  });
  const bytes = readFileSync(at(file));
  bytes[18] = bytes[19] = 1; // sql.js reads no write-ahead log, and there is none left
  const database = new sqlJs.Database(bytes);
  work(database);
  writeFileSync(at(to), database.export());
  database.close();
}
