// The pictures of docs/how-to/read-the-report.md: node pictures.mjs FOLDER (tools/report_pictures).
import { pathToFileURL } from 'node:url';
import { at, copyExperiments, go, lacuna, newPage, noFaults, startBrowser } from './support.mjs';

copyExperiments();
for (const experiment of ['damped-flap.toml', 'first-steps.toml']) {
  lacuna('compare', experiment, '--db', 'rig.db', '--quiet');
  lacuna('diagnose', experiment, '--db', 'rig.db', '--quiet');
}
lacuna('add', 'first-steps.toml', 'coulomb_friction', '--where', 'joint.hinge', '--db', 'rig.db', '--quiet');
lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
lacuna(
  'run',
  'walk.toml',
  '--db',
  'walk.db',
  '--replicates',
  '2',
  '--set',
  'estimation.parameters.generations=6',
  '--quiet',
);
for (const name of ['rig', 'walk']) lacuna('report', `${name}.db`, '--out', `${name}.html`, '--quiet');

const browser = await startBrowser();
const page = await newPage(browser, { viewport: { width: 1180, height: 760 } });
const url = (name) => pathToFileURL(at(`${name}.html`)).href;
const pictures = [
  ['overview', 'rig', '#/overview', 640],
  ['compare', 'rig', '#/compare?experiment=damped-flap&revision=1&finding=0', 760],
  ['diagnose', 'rig', '#/diagnose', 760],
  ['history', 'rig', '#/history?experiment=first-steps', 700],
  ['run', 'walk', '#/run?run=2', 760],
  ['replay', 'walk', '#/replay?run=2&trial=3&t=0.7', 640],
  [
    'sql',
    'rig',
    `#/sql?q=${encodeURIComponent("SELECT time, value FROM samples WHERE trace = (SELECT max(id) FROM traces) AND channel = 'angle'")}&x=time&y=value&as=line`,
    760,
  ],
];
for (const [name, database, hash, height] of pictures) {
  await page.setViewportSize({ width: 1180, height });
  await go(page, url(database), hash);
  await page.waitForTimeout(700);
  await page.screenshot({ path: `${process.argv[2]}/report-${name}.png` });
}
noFaults(page);
await browser.close();
