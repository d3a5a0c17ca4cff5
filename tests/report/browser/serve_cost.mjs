// What a viewer costs a run: the same run alone and watched, in turns (tools/serve_cost). The run has one thread, so that
// the server and the browser have processors of their own; what is measured is what they take from it all the same.
import { spawn } from 'node:child_process';
import { copyExperiments, folder, go, lacuna, newPage, program, serve, startBrowser } from './support.mjs';

const kPairs = Number(process.argv[2] ?? 7);
const keys = ['experiment.passes=4', 'estimation.parameters.generations=40', 'exploration.parameters.generations=10'];
const words = (database) => [
  'run',
  'walk.toml',
  '--db',
  database,
  '--threads',
  '1',
  '--json',
  ...keys.flatMap((one) => ['--set', one]),
];

/** The seconds of a run from its beginning to its end. */
function run(database) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, words(database), { cwd: folder });
    let lines = '';
    child.stdout.on('data', (text) => {
      lines += text;
    });
    child.on('exit', (code) => {
      const end = lines.split('\n').find((line) => line.includes('"event":"end"'));
      if (code === 0 && end) resolve(JSON.parse(end).process_seconds);
      else reject(new Error(`the run ended with ${code}`));
    });
  });
}

/** The same run, shown live by a server to a page that is open all the time. */
async function watchedRun(browser, database) {
  lacuna('run', 'walk.toml', '--db', database, '--quiet', '--set', 'experiment.passes=1');
  const server = await serve(database);
  const page = await newPage(browser);
  await go(page, server.address, '#/run');
  const seconds = await run(database);
  await page.close();
  await server.stop();
  return seconds;
}

copyExperiments();
const browser = await startBrowser();
const ratios = [];
for (let i = 0; i < kPairs; ++i) {
  lacuna('run', 'walk.toml', '--db', `alone${i}.db`, '--quiet', '--set', 'experiment.passes=1');
  const alone = await run(`alone${i}.db`);
  const watched = await watchedRun(browser, `watched${i}.db`);
  ratios.push(watched / alone);
  console.log(`alone ${alone.toFixed(2)} s, watched ${watched.toFixed(2)} s, ratio ${(watched / alone).toFixed(3)}`);
}
await browser.close();
ratios.sort((a, b) => a - b);
console.log(`median ratio ${ratios[Math.floor(ratios.length / 2)].toFixed(3)} of ${kPairs} pairs`);
