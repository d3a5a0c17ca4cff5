// What most tests of the pages look at: a diagnosis, rig.db, a quadruped's run, walk.db, a report of each, and a browser.
import { after, before } from 'node:test';
import { copyExperiments, lacuna, shortRun, startBrowser, stopServers } from './support.mjs';

export let browser;

const ensemble = ['--set', 'estimation.ensemble=3'];

function makeDatabases() {
  copyExperiments();
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('add', 'first-steps.toml', 'coulomb_friction', '--where', 'joint.hinge', '--db', 'rig.db', '--quiet');
  lacuna('compare', 'first-steps.toml', '--db', 'rig.db', '--quiet');
  lacuna('compare', 'damped-flap.toml', '--db', 'rig.db', '--quiet');
  lacuna('diagnose', 'damped-flap.toml', '--db', 'rig.db', '--quiet');
  lacuna('run', 'walk.toml', '--db', 'walk.db', '--replicates', '2', ...shortRun, ...ensemble, '--quiet');
  lacuna('report', 'rig.db', '--out', 'rig.html', '--quiet');
  lacuna('report', 'walk.db', '--out', 'walk.html', '--quiet');
}

/** Makes them before the tests of a file, and ends the browser and the servers after these. */
export function prepare() {
  before(async () => {
    makeDatabases();
    browser = await startBrowser();
  });
  after(async () => {
    await browser?.close();
    await stopServers();
  });
}
