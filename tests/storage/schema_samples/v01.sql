-- Schema version 1, written by the program of commit 375ccd55: what sqlite3's .dump prints, and the header's numbers.
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE schema_text (
  name TEXT NOT NULL PRIMARY KEY,
  sha256 TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO schema_text VALUES('views','8354e64f780f39b4f26e10938667b82cefc908c18bec7e619bdbcc4feeb5941c');
CREATE TABLE experiment (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO experiment VALUES(1099511627777,'rig');
CREATE TABLE experiment_text (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  file TEXT NOT NULL,
  text TEXT NOT NULL,
  overrides TEXT NOT NULL CHECK (json_valid(overrides)),
  UNIQUE (experiment, digest)
) STRICT;
INSERT INTO experiment_text VALUES(1099511627777,1099511627777,'f785f7e4841723bda85e9488dd88a39ff8abdf5ab786d0296a7119bc1cd05feb','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = []\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(3298534883329,1099511627777,'a144ca3b3641da5d7fba9c74b68c24c44edb238fe9872a0db3d59f5ec978afa5','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = [\n  { id = "coulomb_friction", effect = "coulomb_friction", where = "joint.hinge" },\n]\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
CREATE TABLE run (
  number INTEGER PRIMARY KEY CHECK (number BETWEEN 1 AND 8388607),
  identity TEXT NOT NULL UNIQUE CHECK (length(identity) = 32),
  experiment_text INTEGER REFERENCES experiment_text (id),
  command TEXT NOT NULL,
  seed INTEGER NOT NULL,
  threads INTEGER NOT NULL,
  started TEXT NOT NULL,
  ended TEXT,
  ending TEXT CHECK (ending IN ('done', 'failed', 'interrupted'))
) STRICT;
INSERT INTO run VALUES(1,'7c8bc29ca3d51f83a14a8fec3ca02bdd',1099511627777,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:31:44Z','2026-11-28T12:31:44Z','done');
INSERT INTO run VALUES(2,'d4b73a4e0e3b38021dd85b3b7557fbc6',1099511627777,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:31:44Z','2026-11-28T12:31:44Z','done');
INSERT INTO run VALUES(3,'45d0bd5302ac65a08b21b9c3df859aeb',3298534883329,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:31:44Z','2026-11-28T12:31:45Z','done');
INSERT INTO run VALUES(4,'e3d7d08f2ff60a326f3f2958292dbfdb',3298534883329,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:31:45Z','2026-11-28T12:31:45Z','done');
INSERT INTO run VALUES(5,'d6cd7145dfdf2415f9c7785b3f23a0bb',3298534883329,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:31:45Z','2026-11-28T12:31:45Z','done');
INSERT INTO run VALUES(6,'2ac48aa33ffc48ea256030483cf32cb2',1099511627777,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:31:45Z','2026-11-28T12:31:45Z','done');
CREATE TABLE provenance (
  run INTEGER PRIMARY KEY REFERENCES run (number),
  program TEXT NOT NULL,
  source_revision TEXT NOT NULL,
  compiler TEXT NOT NULL,
  build_type TEXT NOT NULL,
  ode TEXT NOT NULL,
  sqlite TEXT NOT NULL,
  eigen TEXT NOT NULL,
  processor TEXT NOT NULL,
  system TEXT NOT NULL
) STRICT;
INSERT INTO provenance VALUES(1,'0.1.0','375ccd55f7704d6f53bba4d5a4f31b7250dacf32','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(2,'0.1.0','375ccd55f7704d6f53bba4d5a4f31b7250dacf32','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(3,'0.1.0','375ccd55f7704d6f53bba4d5a4f31b7250dacf32','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(4,'0.1.0','375ccd55f7704d6f53bba4d5a4f31b7250dacf32','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(5,'0.1.0','375ccd55f7704d6f53bba4d5a4f31b7250dacf32','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(6,'0.1.0','375ccd55f7704d6f53bba4d5a4f31b7250dacf32','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
CREATE TABLE plugin_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  build_id TEXT NOT NULL,
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
CREATE TABLE revision (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  parent INTEGER REFERENCES revision (id),
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  robot TEXT NOT NULL,
  robot_text TEXT NOT NULL CHECK (json_valid(robot_text)),
  free TEXT NOT NULL CHECK (json_valid(free)),
  effects TEXT NOT NULL CHECK (json_valid(effects)),
  engine TEXT NOT NULL CHECK (json_valid(engine)),
  fit_data_digest TEXT NOT NULL,
  added TEXT NOT NULL CHECK (json_valid(added)),
  removed TEXT NOT NULL CHECK (json_valid(removed)),
  change TEXT NOT NULL,
  UNIQUE (experiment, number),
  UNIQUE (experiment, digest)
) STRICT;
INSERT INTO revision VALUES(1099511627777,1099511627777,1,NULL,'929edcca3bcb384318fc844e5413b6e8ef05c33432672564ccd2b5e3c9d15530','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2}]','[]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[]','[]','rigid');
INSERT INTO revision VALUES(3298534883329,1099511627777,2,1099511627777,'247367bc1617e252ebace98c1c7d3fce4e7ccc172c30f79f35cb1ca3f108ab59','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2},{"address":"effect.coulomb_friction.torque","lower":0.0,"start":0.0,"unit":"N*m","upper":10000.0}]','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.0},"where":["joint.hinge"]}]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.0},"where":["joint.hinge"]}]','[]','coulomb_friction');
CREATE TABLE revision_use (
  run INTEGER NOT NULL REFERENCES run (number),
  position INTEGER NOT NULL,
  revision INTEGER NOT NULL REFERENCES revision (id),
  PRIMARY KEY (run, position)
) STRICT, WITHOUT ROWID;
INSERT INTO revision_use VALUES(1,0,1099511627777);
INSERT INTO revision_use VALUES(2,0,1099511627777);
INSERT INTO revision_use VALUES(3,0,3298534883329);
INSERT INTO revision_use VALUES(4,0,3298534883329);
INSERT INTO revision_use VALUES(5,0,3298534883329);
INSERT INTO revision_use VALUES(6,0,1099511627777);
CREATE TABLE trial (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  name TEXT NOT NULL,
  file TEXT NOT NULL,
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  held_out INTEGER NOT NULL CHECK (held_out IN (0, 1)),
  duration REAL NOT NULL,
  samples INTEGER NOT NULL,
  UNIQUE (experiment, digest, name, held_out)
) STRICT;
INSERT INTO trial VALUES(1099511627777,1099511627777,'sine.csv','sine.csv','e3ebed47fa02f514f6bc6550bccbd376892c54496379f41872dc75297a1e4cdd',0,1.830000000000000071,62);
INSERT INTO trial VALUES(1099511627778,1099511627777,'steps.csv','steps.csv','ab6bc9493e69a859ca0776df276c8e2e3a993fd6f3cbe042acf2fb6dfbae564c',0,1.830000000000000071,62);
INSERT INTO trial VALUES(1099511627779,1099511627777,'chirp.csv','chirp.csv','336df2d7813e9a0bec213a5bbf62831db7c9326effc1d35d1aa03cfd1e85853e',1,0.9000000000000000222,31);
CREATE TABLE fit (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  settings TEXT NOT NULL,
  method TEXT NOT NULL,
  loss TEXT NOT NULL,
  loss_scale REAL,
  converged INTEGER NOT NULL CHECK (converged IN (0, 1)),
  residual REAL,
  samples INTEGER NOT NULL,
  simulations INTEGER NOT NULL,
  invalid_simulations INTEGER NOT NULL,
  starts INTEGER NOT NULL,
  agreeing INTEGER NOT NULL,
  correlation_time REAL,
  covariance TEXT CHECK (json_valid(covariance)),
  cannot_tell TEXT NOT NULL CHECK (json_valid(cannot_tell)),
  notes TEXT NOT NULL CHECK (json_valid(notes))
) STRICT;
INSERT INTO fit VALUES(1099511627777,1099511627777,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 375ccd55f7704d6f53bba4d5a4f31b7250dacf32 d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2 6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','free_run','huber',3.0,1,13.04615285016976145,116,144,0,1,1,0.43924859889936407331,'[[3.82337252454309e-05,-7.720817428151313e-06],[-7.720817428151313e-06,3.5639873537629597e-06]]','[]','["residuals are correlated over 0.44 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.017, joint.hinge.damping by -0.0065; the intervals reach as far, more substeps make them narrower"]');
INSERT INTO fit VALUES(3298534883329,3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 375ccd55f7704d6f53bba4d5a4f31b7250dacf32 3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5 d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2 6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','free_run','huber',3.0,1,5.5882476127079359073,116,292,0,1,1,0.76051753163209534491,'[[2.1668595402525917e-05,-2.916904770515823e-06,-7.676754316814443e-07],[-2.9169047705158178e-06,1.9459218308467908e-06,-1.418805292706623e-06],[-7.676754316814435e-07,-1.4188052927066205e-06,2.051320461874769e-06]]','[]','["residuals are correlated over 0.76 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.022, effect.coulomb_friction.torque by -0.012; the intervals reach as far, more substeps make them narrower"]');
CREATE TABLE fit_stage (
  fit INTEGER NOT NULL REFERENCES fit (id),
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  segment REAL NOT NULL,
  segments INTEGER NOT NULL,
  starts INTEGER NOT NULL,
  agreeing INTEGER NOT NULL,
  iterations INTEGER NOT NULL,
  converged INTEGER NOT NULL CHECK (converged IN (0, 1)),
  residual REAL,
  fitted TEXT NOT NULL CHECK (json_valid(fitted)),
  PRIMARY KEY (fit, position)
) STRICT, WITHOUT ROWID;
INSERT INTO fit_stage VALUES(1099511627777,0,'free run',0.0,2,1,1,3,1,13.04615285016976145,'[0.5548900339404571,0.030963922380422337]');
INSERT INTO fit_stage VALUES(3298534883329,0,'free run',0.0,2,1,1,6,1,5.5882476127079359073,'[0.555260637977362,0.019733594528820838,0.018263814449411723]');
CREATE TABLE fitted_value (
  fit INTEGER NOT NULL REFERENCES fit (id),
  position INTEGER NOT NULL,
  address TEXT NOT NULL,
  unit TEXT NOT NULL,
  start REAL,
  value REAL,
  standard_error REAL,
  lower REAL,
  upper REAL,
  at_bound TEXT CHECK (at_bound IN ('lower', 'upper')),
  identifiable INTEGER NOT NULL CHECK (identifiable IN (0, 1)),
  PRIMARY KEY (fit, position)
) STRICT, WITHOUT ROWID;
INSERT INTO fitted_value VALUES(1099511627777,0,'body.arm.mass','kg',0.5,0.55489003394045710582,0.0061833425625167255657,0.54111268814177326813,0.58591794440984890091,NULL,1);
INSERT INTO fitted_value VALUES(1099511627777,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.030963922380422337354,0.0018878525773383257775,0.020304820955041269492,0.035170320054812284626,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,0,'body.arm.mass','kg',0.5,0.55526063797736202598,0.0046549538561113492154,0.54473040076926459995,0.58780188460308024911,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.019733594528820837948,0.0013949630213187698152,0.016161726347844157514,0.022889220119335716707,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,2,'effect.coulomb_friction.torque','N*m',0.0,0.018263814449411722856,0.001432243157384516588,0.0032222778729582377682,0.02150377356675782503,NULL,1);
CREATE TABLE holdout_look (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  revision INTEGER NOT NULL REFERENCES revision (id),
  command TEXT NOT NULL,
  time TEXT NOT NULL,
  UNIQUE (experiment, number)
) STRICT;
INSERT INTO holdout_look VALUES(1099511627777,1099511627777,1,1099511627777,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T12:31:44Z');
INSERT INTO holdout_look VALUES(4398046511105,1099511627777,2,3298534883329,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T12:31:45Z');
CREATE TABLE comparison (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  kind TEXT NOT NULL CHECK (kind IN ('refitted', 'as_written')),
  fit INTEGER REFERENCES fit (id),
  look INTEGER,
  step REAL,
  findings TEXT NOT NULL CHECK (json_valid(findings))
) STRICT;
INSERT INTO comparison VALUES(1099511627777,1099511627777,'refitted',1099511627777,1,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(2199023255553,1099511627777,'refitted',1099511627777,NULL,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(3298534883329,3298534883329,'refitted',3298534883329,NULL,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(4398046511105,3298534883329,'refitted',3298534883329,2,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(6597069766657,1099511627777,'refitted',1099511627777,NULL,0.029999999999999998889,'[]');
CREATE TABLE comparison_score (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  horizon REAL NOT NULL CHECK (horizon >= 0),
  unit TEXT NOT NULL,
  samples INTEGER NOT NULL,
  rmse REAL,
  normalised_rmse REAL,
  theil_u REAL,
  bias REAL,
  bias_share REAL,
  magnitude_share REAL,
  phase_share REAL,
  max_error REAL,
  max_error_time REAL,
  floor REAL,
  as_written_rmse REAL,
  PRIMARY KEY (comparison, trial, channel, horizon)
) STRICT, WITHOUT ROWID;
INSERT INTO comparison_score VALUES(1099511627777,1099511627777,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(1099511627777,1099511627777,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(1099511627777,1099511627777,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(1099511627777,1099511627778,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(1099511627777,1099511627778,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(1099511627777,1099511627778,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(1099511627777,1099511627779,'angle',0.0,'rad',27,0.015162070498811047736,0.1042460068989459615,NULL,-0.012462288829920111984,NULL,NULL,NULL,0.024381254691390213951,0.63000000000000000444,0.0040768215043348789844,0.047776292017303920167);
INSERT INTO comparison_score VALUES(1099511627777,1099511627779,'angle',0.10000000000000000555,'rad',0,0.0011094311322454245959,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(1099511627777,1099511627779,'angle',0.5,'rad',0,0.01214601702322436888,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,1099511627777,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(2199023255553,1099511627777,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,1099511627777,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,1099511627778,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(2199023255553,1099511627778,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,1099511627778,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,1099511627777,'angle',0.0,'rad',58,0.0044163238863508449266,0.013359357647497868346,NULL,0.002495740569623871273,NULL,NULL,NULL,0.0086644043903566503317,1.080000000000000071,0.0070594231438803837358,0.085104174720160588596);
INSERT INTO comparison_score VALUES(3298534883329,1099511627777,'angle',0.10000000000000000555,'rad',0,0.0011724676471666093183,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,1099511627777,'angle',0.5,'rad',0,0.0030635430441543266312,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,1099511627778,'angle',0.0,'rad',58,0.0059254418643508912495,0.016433670487370551083,NULL,0.0044453475149773729116,NULL,NULL,NULL,0.012780744619230899328,1.3799999999999998934,0.00097334009209633343649,0.11406395905448198091);
INSERT INTO comparison_score VALUES(3298534883329,1099511627778,'angle',0.10000000000000000555,'rad',0,0.001738584420524602386,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,1099511627778,'angle',0.5,'rad',0,0.0051809709788639213626,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,1099511627777,'angle',0.0,'rad',58,0.0044163238863508449266,0.013359357647497868346,NULL,0.002495740569623871273,NULL,NULL,NULL,0.0086644043903566503317,1.080000000000000071,0.0070594231438803837358,0.085104174720160588596);
INSERT INTO comparison_score VALUES(4398046511105,1099511627777,'angle',0.10000000000000000555,'rad',0,0.0011724676471666093183,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,1099511627777,'angle',0.5,'rad',0,0.0030635430441543266312,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,1099511627778,'angle',0.0,'rad',58,0.0059254418643508912495,0.016433670487370551083,NULL,0.0044453475149773729116,NULL,NULL,NULL,0.012780744619230899328,1.3799999999999998934,0.00097334009209633343649,0.11406395905448198091);
INSERT INTO comparison_score VALUES(4398046511105,1099511627778,'angle',0.10000000000000000555,'rad',0,0.001738584420524602386,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,1099511627778,'angle',0.5,'rad',0,0.0051809709788639213626,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,1099511627779,'angle',0.0,'rad',27,0.0020006530120296531216,0.013755383060037528267,NULL,0.00029964873140976154737,NULL,NULL,NULL,0.0049768588010344894101,0.9000000000000000222,0.0042121656482632611334,0.047776292017303920167);
INSERT INTO comparison_score VALUES(4398046511105,1099511627779,'angle',0.10000000000000000555,'rad',0,0.00086616836156381096008,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,1099511627779,'angle',0.5,'rad',0,0.0011800901360702114803,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,1099511627777,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(6597069766657,1099511627777,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,1099511627777,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,1099511627778,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(6597069766657,1099511627778,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,1099511627778,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE noise_floor (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  unit TEXT NOT NULL,
  floor REAL,
  sensor REAL,
  input REAL,
  process REAL,
  origin TEXT NOT NULL,
  PRIMARY KEY (comparison, trial, channel)
) STRICT, WITHOUT ROWID;
INSERT INTO noise_floor VALUES(1099511627777,1099511627777,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(1099511627777,1099511627778,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(1099511627777,1099511627779,'angle','rad',0.0040768215043348789844,0.00093507523005767695725,0.0,0.0039681365768254360862,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 3.97 mrad');
INSERT INTO noise_floor VALUES(2199023255553,1099511627777,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(2199023255553,1099511627778,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(3298534883329,1099511627777,'angle','rad',0.0070594231438803837358,0.00093507523005767695725,0.0,0.0069972201221975708143,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 7.00 mrad');
INSERT INTO noise_floor VALUES(3298534883329,1099511627778,'angle','rad',0.00097334009209633343649,0.00093507523005767695725,0.0,0.00027023184308049529034,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 270 µrad');
INSERT INTO noise_floor VALUES(4398046511105,1099511627777,'angle','rad',0.0070594231438803837358,0.00093507523005767695725,0.0,0.0069972201221975708143,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 7.00 mrad');
INSERT INTO noise_floor VALUES(4398046511105,1099511627778,'angle','rad',0.00097334009209633343649,0.00093507523005767695725,0.0,0.00027023184308049529034,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 270 µrad');
INSERT INTO noise_floor VALUES(4398046511105,1099511627779,'angle','rad',0.0042121656482632611334,0.00093507523005767695725,0.0,0.0041070638858607547497,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 4.11 mrad');
INSERT INTO noise_floor VALUES(6597069766657,1099511627777,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(6597069766657,1099511627778,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
CREATE TABLE numerical_error (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  horizon REAL NOT NULL,
  error REAL NOT NULL,
  PRIMARY KEY (comparison, trial, channel, horizon)
) STRICT, WITHOUT ROWID;
INSERT INTO numerical_error VALUES(1099511627777,1099511627777,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(1099511627777,1099511627778,'angle',0.0,0.0098317772017466279615);
INSERT INTO numerical_error VALUES(1099511627777,1099511627779,'angle',0.0,0.0046597907412987736933);
INSERT INTO numerical_error VALUES(2199023255553,1099511627777,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(2199023255553,1099511627778,'angle',0.0,0.0098317772017466279615);
INSERT INTO numerical_error VALUES(3298534883329,1099511627777,'angle',0.0,0.0076946195673142292123);
INSERT INTO numerical_error VALUES(3298534883329,1099511627778,'angle',0.0,0.011394794036997182851);
INSERT INTO numerical_error VALUES(4398046511105,1099511627777,'angle',0.0,0.0076946195673142292123);
INSERT INTO numerical_error VALUES(4398046511105,1099511627778,'angle',0.0,0.011394794036997182851);
INSERT INTO numerical_error VALUES(4398046511105,1099511627779,'angle',0.0,0.0049262601434250557);
INSERT INTO numerical_error VALUES(6597069766657,1099511627777,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(6597069766657,1099511627778,'angle',0.0,0.0098317772017466279615);
CREATE TABLE trace (
  id INTEGER PRIMARY KEY,
  trial INTEGER NOT NULL REFERENCES trial (id),
  comparison INTEGER REFERENCES comparison (id),
  kind TEXT NOT NULL CHECK (kind IN ('measured', 'commands', 'predicted')),
  channels TEXT NOT NULL CHECK (json_valid(channels)),
  sample_count INTEGER NOT NULL,
  precision TEXT NOT NULL CHECK (precision IN ('float32', 'float64')),
  times BLOB NOT NULL,
  samples BLOB NOT NULL,
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  CHECK ((kind = 'predicted') = (comparison IS NOT NULL))
) STRICT;
INSERT INTO trace VALUES(1099511627777,1099511627777,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fa8305cb673d9823fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f3435fe473946ac3fd221337f7cd9b23f182d4454fb21b93f5e3855297a6abf3fd562aa3d043ec33f806a2125532bc73fb530de412b7dcb3f6179cce701cfcf3f4d4080e1b042d23fa46477349c6bd43ffa886e878794d63f15eccc9573bdd83f68cf4c2ad781da3fbbb2ccbe3a46dc3f89b499b5d273dd3f12d7c311266fde3fd956a28baed3de3f5bf7dd6af205df3f9377fff069a1de3f0b55d59416a6dd3fbbb2ccbe3a46dc3f68cf4c2ad781da3fcccbb23ca726d83ff0c5084cf066d53fcc9f44026d10d23fc234bb3b4a0fcd3f6f25cd6cac34c53f182d4454fb21b93f503db83b776a9f3fee20ad669e6ba4bf3435fe473946bcbf806a2125532bc7bf6179cce701cfcfbf22c43b555839d4bf4a2b775d63f4d7bf36d119216fafdbbfd956a28baed3debf5a2e26beb2c9e0bf2830f3b44af7e1bfd221337f7cd9e2bffa72376a6a89e3bfa02300761407e4bf22c43b555839e4bf22c43b555839e4bf','4dc4de9d3675c04cae360a1e78f8918d71f463db13dc449d11b1bace9d0bb135');
INSERT INTO trace VALUES(1099511627778,1099511627777,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(1099511627779,1099511627778,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000df40d09def21693f89292cf2826a8f3f503db83b776a9f3f2631214e1ab4aa3fd9a321fc8ba2b33f2631214e1ab4ba3fc85ecd43e5abc13f75a7bbe9bbfdc53f23f0a98f924fca3f58b666ac6aa1ce3f827f2aa9a079d13f5703e61c4870d33f28462ad26702d53ffa886e878794d63fc88a3b7e1fc2d73f15eccc9573bdd83f9acd7f333f54d93f1b6ebb128386d93f1b6ebb128386d93f182d4454fb21d93f934b91b62f8bd83f4a2b775d63f4d73fc2084d0110f9d63f7266442b3499d53f5703e61c4870d33ffa5c004d4d7ed03f1faf32d10aebc93fc85ecd43e5abc13fc41d56855d47b13fa8305cb673d982bffc248a60bdfdb5bf6ae455ae24d0c4bf5375efede23ccebf5703e61c4870d3bf47eaff9edb8fd7bf6b10c4e85ee6dabf0b55d59416a6ddbf6179cce701cfdfbfd98deade6e97e0bffd9d770bd5e2e0bffd9d770bd5e2e0bf98bd4cef4c7ee0bfe0d89008be9cdfbf0b55d59416a6ddbf6f513ba7e64adbbf12ab55d7eb58d8bf28462ad26702d5bf7bfd3b2c91b0d0bf7c29aa66cbc6c6bfe02510799b6bb4bf182d4454fb21993fc85ecd43e5abc13fb57d5db2084cd03f47eaff9edb8fd73f9377fff069a1de3f5081f79f38a7e23fb236e21a56b2e53faf0ba279eb58e83fea6f88091bb4ea3f','dbeaec820e7395155e17a615b3f207c5f182be74a2c0f1c659b1d5c4ef58e26c');
INSERT INTO trace VALUES(1099511627780,1099511627778,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(1099511627781,1099511627779,NULL,'measured','[{"name":"angle","unit":"rad"}]',31,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fdf40d09def21893fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f4239db4158d8ad3fd9a321fc8ba2b33f1faf32d10aebb93f32dd21d3c419c03fd9a321fc8ba2c33f83ab98e3da8fc73fb530de412b7dcb3f6179cce701cfcf3fcc9f44026d10d23f22c43b555839d43f78e832a84362d63f12ab55d7eb58d83fe62e114b934fda3f3a1291dff613dc3f','f6d97370b1a91e9b8be4be92322cc4dd59ee3408a3267f809f0ba669f3e105e6');
INSERT INTO trace VALUES(1099511627782,1099511627779,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'0000000000000000000000000000000077346037ab90a638f32d97393a37483abad8dc3ab7d5573bed5fc03baed91f3cce9a7a3c033dbb3c2f33063d0f93393db485783d8bada13d69e8cc3d577efd3dbc67193ec60b363e2a3e543e938a733e32b9893ef8bb993e638fa93e29f4b83e3aafc73e7689d53eee50e23e','d67fe685148f8d12ff6a7a250b3edb562df299aa27fbaaf64a3dffb94b717e66');
INSERT INTO trace VALUES(2199023255553,1099511627777,2199023255553,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(2199023255554,1099511627778,2199023255553,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(3298534883329,1099511627777,3298534883329,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000112cd8268a1b07286526bd28da6a512984a9ca29b06ad3380b4e183a0f86e43ade53813b367df73bf60f543c34c8a73c0fdcf93c5d49313d65d1713d01819f3d057bcc3d3ea6ff3d16481c3e39413b3e98415c3ebdab7e3eade3903e0262a23e325eb33e925ec33ee4e5d13e9176de3ee793e83e39caef3eb7adf33e08e2f33ea69bf03eb6a0e93e47ccde3e1813d03ec780bd3e633da73e42898d3e467e613e1ca3223e7f1cbf3df05bcb3cdc093abdecdcedbd098a3ebeda0882befb2ba3be2f27c2be6d84debe77dff7be61f506bf463510bf1f9c17bfff1f1dbfd6bf20bf068222bf068222bf','99549e70fc123ae35cd55228e183a20e5cb58e88d99a3987f29e4bfd68b0cbc3');
INSERT INTO trace VALUES(3298534883330,1099511627778,3298534883329,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'12803cb912803cb912803cb98b63753bbf23613cefebf03cb08f4d3d915a9a3d9445d53d5bd60a3e79ca2c3e707a4f3e83e2713edd83893e80ff983eaff9a63e9215b33e0606bd3e1d8fc43e2087c93e1cd7cb3e1cd7cb3e97b6c93ee38dc53e1f83bf3e0fc9b73ea7b5ac3e63089b3e345f833e70064d3e47c60a3ed72e843d97312cbc4ae3b2bdd69d27be7c0773be8ecb9cbe6fb6bcbec275d8bec05fefbeb47800bfa46706bfb96209bf926309bfa7b706bfea7b01bfe7bbf3be5e36e0be33ffc8be3b20aebe9cd18abe912f3fbe957db7bd63b48b3ca8fb043ef6477b3e1a74b83e8251f13e4865133fc0d02b3f0e68413f98c3533f','a966291dbbd6fc5b6446388d8ed53a9498684fbbbf303241ad8606cced80321b');
INSERT INTO trace VALUES(4398046511105,1099511627777,4398046511105,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000112cd8268a1b07286526bd28da6a512984a9ca29b06ad3380b4e183a0f86e43ade53813b367df73bf60f543c34c8a73c0fdcf93c5d49313d65d1713d01819f3d057bcc3d3ea6ff3d16481c3e39413b3e98415c3ebdab7e3eade3903e0262a23e325eb33e925ec33ee4e5d13e9176de3ee793e83e39caef3eb7adf33e08e2f33ea69bf03eb6a0e93e47ccde3e1813d03ec780bd3e633da73e42898d3e467e613e1ca3223e7f1cbf3df05bcb3cdc093abdecdcedbd098a3ebeda0882befb2ba3be2f27c2be6d84debe77dff7be61f506bf463510bf1f9c17bfff1f1dbfd6bf20bf068222bf068222bf','99549e70fc123ae35cd55228e183a20e5cb58e88d99a3987f29e4bfd68b0cbc3');
INSERT INTO trace VALUES(4398046511106,1099511627778,4398046511105,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'12803cb912803cb912803cb98b63753bbf23613cefebf03cb08f4d3d915a9a3d9445d53d5bd60a3e79ca2c3e707a4f3e83e2713edd83893e80ff983eaff9a63e9215b33e0606bd3e1d8fc43e2087c93e1cd7cb3e1cd7cb3e97b6c93ee38dc53e1f83bf3e0fc9b73ea7b5ac3e63089b3e345f833e70064d3e47c60a3ed72e843d97312cbc4ae3b2bdd69d27be7c0773be8ecb9cbe6fb6bcbec275d8bec05fefbeb47800bfa46706bfb96209bf926309bfa7b706bfea7b01bfe7bbf3be5e36e0be33ffc8be3b20aebe9cd18abe912f3fbe957db7bd63b48b3ca8fb043ef6477b3e1a74b83e8251f13e4865133fc0d02b3f0e68413f98c3533f','a966291dbbd6fc5b6446388d8ed53a9498684fbbbf303241ad8606cced80321b');
INSERT INTO trace VALUES(4398046511107,1099511627779,4398046511105,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000112cd8268a1b07283a2cd828f3f279295892f6298ece9039f1df983a05c2493b9ff3d23b2faf3f3c37f69d3cc43cf23ce47e2f3d2ac8723d8984a13d1dcdcf3d63db013e44461e3ea2bc3c3eaec75c3e5be17d3e07c08f3eba8ba03ee30ab13e9cf7c03e1c0fd03e6313de3e','027037dfddf650a9fc3f98bde24b98042a7f10c103873eb797eff1750b061939');
INSERT INTO trace VALUES(6597069766657,1099511627777,6597069766657,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(6597069766658,1099511627778,6597069766657,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
CREATE TABLE work_time (
  kind TEXT NOT NULL CHECK (kind IN ('fit', 'comparison')),
  id INTEGER NOT NULL,
  seconds REAL NOT NULL,
  PRIMARY KEY (kind, id)
) STRICT, WITHOUT ROWID;
INSERT INTO work_time VALUES('comparison',1099511627777,0.18992892699999999739);
INSERT INTO work_time VALUES('comparison',2199023255553,0.14743084800000000322);
INSERT INTO work_time VALUES('comparison',3298534883329,0.20855473199999999267);
INSERT INTO work_time VALUES('comparison',4398046511105,0.25024613000000001106);
INSERT INTO work_time VALUES('comparison',6597069766657,0.14659007900000001201);
INSERT INTO work_time VALUES('fit',1099511627777,0.09575094500000000397);
INSERT INTO work_time VALUES('fit',3298534883329,0.18232116200000000882);
CREATE INDEX fit_by_revision ON fit (revision);
CREATE INDEX comparison_by_revision ON comparison (revision, kind);
CREATE INDEX trace_by_trial ON trace (trial, kind);
CREATE VIEW runs AS
SELECT run.number AS run, experiment.name AS experiment, run.command, run.started, run.ended,
       coalesce(run.ending, 'not ended') AS ending, run.seed, run.threads,
       provenance.program, provenance.source_revision, provenance.processor, run.identity
FROM run
LEFT JOIN experiment_text ON experiment_text.id = run.experiment_text
LEFT JOIN experiment ON experiment.id = experiment_text.experiment
LEFT JOIN provenance ON provenance.run = run.number;
CREATE VIEW revisions AS
SELECT experiment.name AS experiment, revision.number, parent.number AS parent, revision.change,
       (SELECT group_concat(json_extract(value, '$.effect'), ', ') FROM json_each(revision.effects)) AS effects,
       json_array_length(revision.free) AS free_values, revision.robot,
       revision.id >> 40 AS first_run, revision.digest, revision.id
FROM revision
JOIN experiment ON experiment.id = revision.experiment
LEFT JOIN revision AS parent ON parent.id = revision.parent;
CREATE VIEW latest_comparison AS
SELECT experiment.name AS experiment, revision.number AS revision, trial.name AS trial, trial.held_out,
       score.channel, score.unit, score.rmse, score.floor, score.rmse / score.floor AS times_floor,
       score.normalised_rmse, score.max_error, score.max_error_time, numerical_error.error AS numerical_error,
       score.as_written_rmse, score.samples, comparison.id AS comparison
FROM comparison
JOIN revision ON revision.id = comparison.revision
JOIN experiment ON experiment.id = revision.experiment
JOIN comparison_score AS score ON score.comparison = comparison.id AND score.horizon = 0
JOIN trial ON trial.id = score.trial
LEFT JOIN numerical_error ON numerical_error.comparison = score.comparison
  AND numerical_error.trial = score.trial AND numerical_error.channel = score.channel
  AND numerical_error.horizon = score.horizon
WHERE comparison.id = (
  SELECT max(newer.id) FROM comparison AS newer
  JOIN comparison_score AS newer_score ON newer_score.comparison = newer.id AND newer_score.horizon = 0
  JOIN trial AS newer_trial ON newer_trial.id = newer_score.trial
  WHERE newer.revision = comparison.revision AND newer.kind = 'refitted'
    AND newer_trial.held_out = trial.held_out);
CREATE VIEW error_by_revision AS
WITH pooled AS (
  SELECT experiment, revision, channel, unit, held_out,
         sum(rmse IS NULL) AS failed,
         iif(sum(rmse IS NULL) = 0, sqrt(sum(samples * rmse * rmse) / sum(samples)), NULL) AS rmse,
         iif(sum(rmse IS NOT NULL AND floor IS NULL) = 0,
             sqrt(sum(iif(rmse IS NULL, NULL, samples * floor * floor)) / sum(iif(rmse IS NULL, NULL, samples))),
             NULL) AS floor
  FROM latest_comparison
  WHERE samples > 0
  GROUP BY experiment, revision, channel, unit, held_out),
sides AS (
  SELECT experiment, revision, channel, unit, max(held_out) AS looked, sum(failed) AS failed_trials,
         max(iif(held_out = 0, rmse, NULL)) AS fit_rmse, max(iif(held_out = 1, rmse, NULL)) AS held_out_rmse,
         max(iif(held_out = 0, floor, NULL)) AS fit_floor, max(iif(held_out = 1, floor, NULL)) AS held_out_floor
  FROM pooled
  GROUP BY experiment, revision, channel, unit)
SELECT sides.experiment, sides.revision, revision.change, sides.channel, sides.unit, fit_rmse, held_out_rmse,
       coalesce(held_out_floor, fit_floor) AS floor,
       iif(looked, held_out_rmse / held_out_floor, fit_rmse / fit_floor) AS times_floor, failed_trials
FROM sides
JOIN experiment ON experiment.name = sides.experiment
JOIN revision ON revision.experiment = experiment.id AND revision.number = sides.revision;
CREATE VIEW fitted_parameters AS
SELECT experiment.name AS experiment, revision.number AS revision, fitted_value.position, fitted_value.address,
       fitted_value.value, fitted_value.unit, fitted_value.standard_error, fitted_value.lower, fitted_value.upper,
       fitted_value.start, fitted_value.at_bound, fitted_value.identifiable, fit.converged, fit.id AS fit
FROM fit
JOIN revision ON revision.id = fit.revision
JOIN experiment ON experiment.id = revision.experiment
JOIN fitted_value ON fitted_value.fit = fit.id
WHERE fit.id = (SELECT max(id) FROM fit AS newer WHERE newer.revision = fit.revision);
CREATE VIEW holdout_looks AS
SELECT experiment.name AS experiment, holdout_look.number, revision.number AS revision, holdout_look.time,
       holdout_look.command, holdout_look.id >> 40 AS run
FROM holdout_look
JOIN experiment ON experiment.id = holdout_look.experiment
JOIN revision ON revision.id = holdout_look.revision;
CREATE VIEW noise_floors AS
SELECT experiment.name AS experiment, revision.number AS revision, trial.name AS trial, noise_floor.channel,
       noise_floor.floor, noise_floor.unit, noise_floor.sensor, noise_floor.input, noise_floor.process,
       noise_floor.origin
FROM noise_floor
JOIN trial ON trial.id = noise_floor.trial
JOIN comparison ON comparison.id = noise_floor.comparison
JOIN revision ON revision.id = comparison.revision
JOIN experiment ON experiment.id = revision.experiment
WHERE comparison.id = (SELECT max(newer.id) FROM comparison AS newer WHERE newer.revision = comparison.revision);
CREATE VIEW traces AS
SELECT experiment.name AS experiment, trial.name AS trial, trial.held_out, trace.kind, revision.number AS revision,
       (SELECT group_concat(json_extract(value, '$.name'), ', ') FROM json_each(trace.channels)) AS channels,
       trace.sample_count, trial.duration, length(trace.times) + length(trace.samples) AS bytes, trace.id
FROM trace
JOIN trial ON trial.id = trace.trial
JOIN experiment ON experiment.id = trial.experiment
LEFT JOIN comparison ON comparison.id = trace.comparison
LEFT JOIN revision ON revision.id = comparison.revision;
COMMIT;
PRAGMA application_id = 1281450862;
PRAGMA user_version = 1;
