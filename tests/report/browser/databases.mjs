// The databases that most tests of the pages look at: a diagnosis, rig.db, and a quadruped's run, walk.db.
import { copyExperiments, lacuna, shortRun } from './support.mjs';

const ensemble = ['--set', 'estimation.ensemble=3'];

export function makeDatabases() {
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
