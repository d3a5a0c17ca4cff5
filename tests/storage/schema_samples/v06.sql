-- Schema version 6, written by the program of commit 43f12e9a: what sqlite3's .dump prints, and the header's numbers.
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE schema_text (
  name TEXT NOT NULL PRIMARY KEY,
  sha256 TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO schema_text VALUES('views','0684820bc09163b6d6c82914c9a2f26e1dd3c1499dc8beb9cf4a37c0e9525269');
CREATE TABLE experiment (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO experiment VALUES(1099511627777,'evolve');
INSERT INTO experiment VALUES(2199023255553,'rig');
CREATE TABLE experiment_text (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  file TEXT NOT NULL,
  text TEXT NOT NULL,
  overrides TEXT NOT NULL CHECK (json_valid(overrides)),
  UNIQUE (experiment, digest)
) STRICT;
INSERT INTO experiment_text VALUES(1099511627777,1099511627777,'8bdd35edb8794f17d99f6b83979f8589a7209806b772a284a9036508442122e6','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 1\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] } }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(2199023255553,2199023255553,'f785f7e4841723bda85e9488dd88a39ff8abdf5ab786d0296a7119bc1cd05feb','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = []\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(5497558138881,2199023255553,'a144ca3b3641da5d7fba9c74b68c24c44edb238fe9872a0db3d59f5ec978afa5','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = [\n  { id = "coulomb_friction", effect = "coulomb_friction", where = "joint.hinge" },\n]\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(9895604649985,1099511627777,'76cdb4f736daa823513ff4ce4b225823cb20aad525eacccaa8ea4a0c83b85660','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 1\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] } }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'["engine.substeps=20000","estimation.parameters.generations=20"]');
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
INSERT INTO run VALUES(1,'b1838dd12c9640e5366536af5e6f5970',1099511627777,'lacuna run evolve.toml --db sample.db --threads 1',1,1,'2026-11-28T13:16:06Z','2026-11-28T13:16:06Z','done');
INSERT INTO run VALUES(2,'ea01f94f4c21e3f1fb02ba0f6096b209',2199023255553,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T13:16:07Z','2026-11-28T13:16:08Z','done');
INSERT INTO run VALUES(3,'a4f8079d244fdcd7fb4fedabc98215d5',2199023255553,'lacuna diagnose rig.toml --db sample.db --threads 1 --among coulomb_friction joint_offset_torque',1,1,'2026-11-28T13:16:09Z','2026-11-28T13:16:15Z','done');
INSERT INTO run VALUES(4,'84d9b419df7e85d89640120f24bbd19b',2199023255553,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T13:16:16Z','2026-11-28T13:16:16Z','done');
INSERT INTO run VALUES(5,'abc0230a3f26ac7165e7b0815f698fdc',5497558138881,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T13:16:16Z','2026-11-28T13:16:18Z','done');
INSERT INTO run VALUES(6,'0df8c89bd71b99083f91de9326937aa5',5497558138881,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T13:16:18Z','2026-11-28T13:16:20Z','done');
INSERT INTO run VALUES(7,'bcf22b846f76ca4767713977abddd211',5497558138881,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T13:16:20Z','2026-11-28T13:16:20Z','done');
INSERT INTO run VALUES(8,'6833717b2686f8c2511be081834e56ea',2199023255553,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T13:16:20Z','2026-11-28T13:16:21Z','done');
INSERT INTO run VALUES(9,'546df39e2d602eb991b8eb4aaf71e301',9895604649985,'lacuna run evolve.toml --db sample.db --threads 1 --seed 2 --set engine.substeps=20000 --set estimation.parameters.generations=20',2,1,'2026-11-28T13:16:21Z','2026-11-28T13:16:28Z','interrupted');
INSERT INTO run VALUES(10,'2bbae42644b46f474f36bc379496dbcd',1099511627777,'lacuna trial evolve.toml --db sample.db --threads 1 --test ''triangle motor 0.3 N*m 4 Hz 0.3 s''',1,1,'2026-11-28T13:16:28Z','2026-11-28T13:16:28Z','done');
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
INSERT INTO provenance VALUES(1,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(2,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(3,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(4,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(5,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(6,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(7,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(8,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(9,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(10,'0.1.0','43f12e9ae52873cffca6c6e0e8e6442a2a2000f5','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
CREATE TABLE plugin_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  build_id TEXT NOT NULL,
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/command_series.so','74c95cd7c64a9647cb16ee5be2bb6f00ffc99fe680092adfe490570ae7b3aa42','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','ba13622b32d7549b29472abb525034d463c231099a52d83b73e0836a8022edec','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','f518fa0c03f615df874cb191f716ae3a21fede86045895a3ba44fc61c1750f86','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','48ca666b4682ca4ac6d1773fa74cc3d073c1fc11a0564f7f87808e240639b16c','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','36e73dad4b0eb5e0e0a2b036c6f4b3b78b9e2f68dae8516f67b8b487a15cf282','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameters.so','39447a182d571b5889fafc22750950684518edcc956d8938848a2ca48e773fc8','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/simulated.so','c365f82c2dba5404438a2bd0d088bf82c4351e5a97c3e0506b824798bd6f6ffd','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/truncation.so','acc6b76c817d7c4f568c88de94fb40b6cba1e12e83c6a2fa99bb61eabd3fd15b','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','9172e338ce46c7cce81ae2cfb8e5d6473e2c718216fcaaad1a17742169508eba','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/recorded.so','523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/command_series.so','74c95cd7c64a9647cb16ee5be2bb6f00ffc99fe680092adfe490570ae7b3aa42','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','ba13622b32d7549b29472abb525034d463c231099a52d83b73e0836a8022edec','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','f518fa0c03f615df874cb191f716ae3a21fede86045895a3ba44fc61c1750f86','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','48ca666b4682ca4ac6d1773fa74cc3d073c1fc11a0564f7f87808e240639b16c','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','36e73dad4b0eb5e0e0a2b036c6f4b3b78b9e2f68dae8516f67b8b487a15cf282','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/parameters.so','39447a182d571b5889fafc22750950684518edcc956d8938848a2ca48e773fc8','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/simulated.so','c365f82c2dba5404438a2bd0d088bf82c4351e5a97c3e0506b824798bd6f6ffd','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/truncation.so','acc6b76c817d7c4f568c88de94fb40b6cba1e12e83c6a2fa99bb61eabd3fd15b','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','9172e338ce46c7cce81ae2cfb8e5d6473e2c718216fcaaad1a17742169508eba','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/declared.so','1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/simulated.so','c365f82c2dba5404438a2bd0d088bf82c4351e5a97c3e0506b824798bd6f6ffd','0.1.0');
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
INSERT INTO revision VALUES(2199023255553,2199023255553,1,NULL,'929edcca3bcb384318fc844e5413b6e8ef05c33432672564ccd2b5e3c9d15530','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2}]','[]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[]','[]','rigid');
INSERT INTO revision VALUES(5497558138881,2199023255553,2,2199023255553,'247367bc1617e252ebace98c1c7d3fce4e7ccc172c30f79f35cb1ca3f108ab59','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2},{"address":"effect.coulomb_friction.torque","lower":0.0,"start":0.0,"unit":"N*m","upper":10000.0}]','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.0},"where":["joint.hinge"]}]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.0},"where":["joint.hinge"]}]','[]','coulomb_friction');
CREATE TABLE revision_use (
  run INTEGER NOT NULL REFERENCES run (number),
  position INTEGER NOT NULL,
  revision INTEGER NOT NULL REFERENCES revision (id),
  PRIMARY KEY (run, position)
) STRICT, WITHOUT ROWID;
INSERT INTO revision_use VALUES(2,0,2199023255553);
INSERT INTO revision_use VALUES(3,0,2199023255553);
INSERT INTO revision_use VALUES(4,0,2199023255553);
INSERT INTO revision_use VALUES(5,0,5497558138881);
INSERT INTO revision_use VALUES(6,0,5497558138881);
INSERT INTO revision_use VALUES(7,0,5497558138881);
INSERT INTO revision_use VALUES(8,0,2199023255553);
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
INSERT INTO trial VALUES(1099511627777,1099511627777,'run 1, trial 0','','54b47ae0faadefb4701103b219ed7ab8c7a3385cad39197cc36dce6830b23f92',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(1099511627778,1099511627777,'run 1, trial 1','','bb0e6668c800e33e81fb40f962b8eaf1778855bd42b83e17e75d65f3a416fd1b',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(2199023255553,2199023255553,'sine.csv','sine.csv','e3ebed47fa02f514f6bc6550bccbd376892c54496379f41872dc75297a1e4cdd',0,1.830000000000000071,62);
INSERT INTO trial VALUES(2199023255554,2199023255553,'steps.csv','steps.csv','ab6bc9493e69a859ca0776df276c8e2e3a993fd6f3cbe042acf2fb6dfbae564c',0,1.830000000000000071,62);
INSERT INTO trial VALUES(2199023255555,2199023255553,'chirp.csv','chirp.csv','336df2d7813e9a0bec213a5bbf62831db7c9326effc1d35d1aa03cfd1e85853e',1,0.9000000000000000222,31);
INSERT INTO trial VALUES(9895604649985,1099511627777,'run 9, trial 0','','357d04006265dc35d69c56580494972d84b0456be87ce5f5d226368c7c4b78f9',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(10995116277761,1099511627777,'trial-1','','995ee74ee5b05c230135e288a64d4b7d4ba6ee0d909c48945437ab8dfc324365',0,0.29999999999999998889,16);
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
INSERT INTO fit VALUES(2199023255553,2199023255553,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 43f12e9ae52873cffca6c6e0e8e6442a2a2000f5 1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd 523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','free_run','huber',3.0,1,13.04615285016976145,116,144,0,1,1,0.43924859889936407331,'[[3.82337252454309e-05,-7.720817428151313e-06],[-7.720817428151313e-06,3.5639873537629597e-06]]','[]','["residuals are correlated over 0.44 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.017, joint.hinge.damping by -0.0065; the intervals reach as far, more substeps make them narrower"]');
INSERT INTO fit VALUES(5497558138881,5497558138881,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 43f12e9ae52873cffca6c6e0e8e6442a2a2000f5 9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50 1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd 523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7','free_run','huber',3.0,1,5.5882476127079359073,116,292,0,1,1,0.76051753163209534491,'[[2.1668595402525917e-05,-2.916904770515823e-06,-7.676754316814443e-07],[-2.9169047705158178e-06,1.9459218308467908e-06,-1.418805292706623e-06],[-7.676754316814435e-07,-1.4188052927066205e-06,2.051320461874769e-06]]','[]','["residuals are correlated over 0.76 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.022, effect.coulomb_friction.torque by -0.012; the intervals reach as far, more substeps make them narrower"]');
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
INSERT INTO fit_stage VALUES(2199023255553,0,'free run',0.0,2,1,1,3,1,13.04615285016976145,'[0.5548900339404571,0.030963922380422337]');
INSERT INTO fit_stage VALUES(5497558138881,0,'free run',0.0,2,1,1,6,1,5.5882476127079359073,'[0.555260637977362,0.019733594528820838,0.018263814449411723]');
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
INSERT INTO fitted_value VALUES(2199023255553,0,'body.arm.mass','kg',0.5,0.55489003394045710582,0.0061833425625167255657,0.54111268814177326813,0.58591794440984890091,NULL,1);
INSERT INTO fitted_value VALUES(2199023255553,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.030963922380422337354,0.0018878525773383257775,0.020304820955041269492,0.035170320054812284626,NULL,1);
INSERT INTO fitted_value VALUES(5497558138881,0,'body.arm.mass','kg',0.5,0.55526063797736202598,0.0046549538561113492154,0.54473040076926459995,0.58780188460308024911,NULL,1);
INSERT INTO fitted_value VALUES(5497558138881,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.019733594528820837948,0.0013949630213187698152,0.016161726347844157514,0.022889220119335716707,NULL,1);
INSERT INTO fitted_value VALUES(5497558138881,2,'effect.coulomb_friction.torque','N*m',0.0,0.018263814449411722856,0.001432243157384516588,0.0032222778729582377682,0.02150377356675782503,NULL,1);
CREATE TABLE holdout_look (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  revision INTEGER NOT NULL REFERENCES revision (id),
  command TEXT NOT NULL,
  time TEXT NOT NULL,
  UNIQUE (experiment, number)
) STRICT;
INSERT INTO holdout_look VALUES(2199023255553,2199023255553,1,2199023255553,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T13:16:07Z');
INSERT INTO holdout_look VALUES(6597069766657,2199023255553,2,5497558138881,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T13:16:18Z');
CREATE TABLE comparison (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  kind TEXT NOT NULL CHECK (kind IN ('refitted', 'as_written')),
  fit INTEGER REFERENCES fit (id),
  look INTEGER,
  step REAL,
  findings TEXT NOT NULL CHECK (json_valid(findings))
) STRICT;
INSERT INTO comparison VALUES(2199023255553,2199023255553,'refitted',2199023255553,1,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(4398046511105,2199023255553,'refitted',2199023255553,NULL,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(5497558138881,5497558138881,'refitted',5497558138881,NULL,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(6597069766657,5497558138881,'refitted',5497558138881,2,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(8796093022209,2199023255553,'refitted',2199023255553,NULL,0.029999999999999998889,'[]');
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
INSERT INTO comparison_score VALUES(2199023255553,2199023255553,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(2199023255553,2199023255553,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,2199023255553,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,2199023255554,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(2199023255553,2199023255554,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,2199023255554,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,2199023255555,'angle',0.0,'rad',27,0.015162070498811047736,0.1042460068989459615,NULL,-0.012462288829920111984,NULL,NULL,NULL,0.024381254691390213951,0.63000000000000000444,0.0040768215043348789844,0.047776292017303920167);
INSERT INTO comparison_score VALUES(2199023255553,2199023255555,'angle',0.10000000000000000555,'rad',0,0.0011094311322454245959,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(2199023255553,2199023255555,'angle',0.5,'rad',0,0.01214601702322436888,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,2199023255553,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(4398046511105,2199023255553,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,2199023255553,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,2199023255554,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(4398046511105,2199023255554,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,2199023255554,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,2199023255553,'angle',0.0,'rad',58,0.0044163238863508449266,0.013359357647497868346,NULL,0.002495740569623871273,NULL,NULL,NULL,0.0086644043903566503317,1.080000000000000071,0.0070594231438803837358,0.085104174720160588596);
INSERT INTO comparison_score VALUES(5497558138881,2199023255553,'angle',0.10000000000000000555,'rad',0,0.0011724676471666093183,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,2199023255553,'angle',0.5,'rad',0,0.0030635430441543266312,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,2199023255554,'angle',0.0,'rad',58,0.0059254418643508912495,0.016433670487370551083,NULL,0.0044453475149773729116,NULL,NULL,NULL,0.012780744619230899328,1.3799999999999998934,0.00097334009209633343649,0.11406395905448198091);
INSERT INTO comparison_score VALUES(5497558138881,2199023255554,'angle',0.10000000000000000555,'rad',0,0.001738584420524602386,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,2199023255554,'angle',0.5,'rad',0,0.0051809709788639213626,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,2199023255553,'angle',0.0,'rad',58,0.0044163238863508449266,0.013359357647497868346,NULL,0.002495740569623871273,NULL,NULL,NULL,0.0086644043903566503317,1.080000000000000071,0.0070594231438803837358,0.085104174720160588596);
INSERT INTO comparison_score VALUES(6597069766657,2199023255553,'angle',0.10000000000000000555,'rad',0,0.0011724676471666093183,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,2199023255553,'angle',0.5,'rad',0,0.0030635430441543266312,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,2199023255554,'angle',0.0,'rad',58,0.0059254418643508912495,0.016433670487370551083,NULL,0.0044453475149773729116,NULL,NULL,NULL,0.012780744619230899328,1.3799999999999998934,0.00097334009209633343649,0.11406395905448198091);
INSERT INTO comparison_score VALUES(6597069766657,2199023255554,'angle',0.10000000000000000555,'rad',0,0.001738584420524602386,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,2199023255554,'angle',0.5,'rad',0,0.0051809709788639213626,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,2199023255555,'angle',0.0,'rad',27,0.0020006530120296531216,0.013755383060037528267,NULL,0.00029964873140976154737,NULL,NULL,NULL,0.0049768588010344894101,0.9000000000000000222,0.0042121656482632611334,0.047776292017303920167);
INSERT INTO comparison_score VALUES(6597069766657,2199023255555,'angle',0.10000000000000000555,'rad',0,0.00086616836156381096008,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,2199023255555,'angle',0.5,'rad',0,0.0011800901360702114803,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,2199023255553,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(8796093022209,2199023255553,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,2199023255553,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,2199023255554,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(8796093022209,2199023255554,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,2199023255554,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
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
INSERT INTO noise_floor VALUES(2199023255553,2199023255553,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(2199023255553,2199023255554,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(2199023255553,2199023255555,'angle','rad',0.0040768215043348789844,0.00093507523005767695725,0.0,0.0039681365768254360862,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 3.97 mrad');
INSERT INTO noise_floor VALUES(4398046511105,2199023255553,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(4398046511105,2199023255554,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(5497558138881,2199023255553,'angle','rad',0.0070594231438803837358,0.00093507523005767695725,0.0,0.0069972201221975708143,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 7.00 mrad');
INSERT INTO noise_floor VALUES(5497558138881,2199023255554,'angle','rad',0.00097334009209633343649,0.00093507523005767695725,0.0,0.00027023184308049529034,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 270 µrad');
INSERT INTO noise_floor VALUES(6597069766657,2199023255553,'angle','rad',0.0070594231438803837358,0.00093507523005767695725,0.0,0.0069972201221975708143,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 7.00 mrad');
INSERT INTO noise_floor VALUES(6597069766657,2199023255554,'angle','rad',0.00097334009209633343649,0.00093507523005767695725,0.0,0.00027023184308049529034,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 270 µrad');
INSERT INTO noise_floor VALUES(6597069766657,2199023255555,'angle','rad',0.0042121656482632611334,0.00093507523005767695725,0.0,0.0041070638858607547497,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 4.11 mrad');
INSERT INTO noise_floor VALUES(8796093022209,2199023255553,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(8796093022209,2199023255554,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
CREATE TABLE numerical_error (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  horizon REAL NOT NULL,
  error REAL NOT NULL,
  PRIMARY KEY (comparison, trial, channel, horizon)
) STRICT, WITHOUT ROWID;
INSERT INTO numerical_error VALUES(2199023255553,2199023255553,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(2199023255553,2199023255554,'angle',0.0,0.0098317772017466279615);
INSERT INTO numerical_error VALUES(2199023255553,2199023255555,'angle',0.0,0.0046597907412987736933);
INSERT INTO numerical_error VALUES(4398046511105,2199023255553,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(4398046511105,2199023255554,'angle',0.0,0.0098317772017466279615);
INSERT INTO numerical_error VALUES(5497558138881,2199023255553,'angle',0.0,0.0076946195673142292123);
INSERT INTO numerical_error VALUES(5497558138881,2199023255554,'angle',0.0,0.011394794036997182851);
INSERT INTO numerical_error VALUES(6597069766657,2199023255553,'angle',0.0,0.0076946195673142292123);
INSERT INTO numerical_error VALUES(6597069766657,2199023255554,'angle',0.0,0.011394794036997182851);
INSERT INTO numerical_error VALUES(6597069766657,2199023255555,'angle',0.0,0.0049262601434250557);
INSERT INTO numerical_error VALUES(8796093022209,2199023255553,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(8796093022209,2199023255554,'angle',0.0,0.0098317772017466279615);
CREATE TABLE work_time (
  kind TEXT NOT NULL CHECK (kind IN ('fit', 'comparison')),
  id INTEGER NOT NULL,
  seconds REAL NOT NULL,
  PRIMARY KEY (kind, id)
) STRICT, WITHOUT ROWID;
INSERT INTO work_time VALUES('comparison',2199023255553,0.84618666300000000557);
INSERT INTO work_time VALUES('comparison',4398046511105,0.70662800000000003386);
INSERT INTO work_time VALUES('comparison',5497558138881,0.93624470999999997999);
INSERT INTO work_time VALUES('comparison',6597069766657,1.0343274860000000181);
INSERT INTO work_time VALUES('comparison',8796093022209,0.54652472200000001834);
INSERT INTO work_time VALUES('fit',2199023255553,0.49564736599999997812);
INSERT INTO work_time VALUES('fit',5497558138881,0.79720758199999997017);
CREATE TABLE metric (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO metric VALUES(1,'mean_absolute_difference');
INSERT INTO metric VALUES(2,'model_disagreement');
CREATE TABLE eea_run (
  run INTEGER PRIMARY KEY REFERENCES run (number),
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  replicate INTEGER NOT NULL CHECK (replicate >= 1),
  passes INTEGER NOT NULL CHECK (passes >= 0),
  metric INTEGER NOT NULL REFERENCES metric (id),
  fitness INTEGER REFERENCES metric (id),
  model_genes TEXT NOT NULL CHECK (json_valid(model_genes)),
  test_genes TEXT NOT NULL CHECK (json_valid(test_genes))
, fitness_unit TEXT) STRICT;
INSERT INTO eea_run VALUES(1,1099511627777,1,1,1,2,'["joint.hinge.damping","effect.coulomb_friction.torque"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
INSERT INTO eea_run VALUES(9,1099511627777,1,1,1,2,'["joint.hinge.damping","effect.coulomb_friction.torque"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
CREATE TABLE free_value (
  run INTEGER NOT NULL REFERENCES eea_run (run),
  position INTEGER NOT NULL CHECK (position >= 0),
  address TEXT NOT NULL,
  unit TEXT NOT NULL,
  lower REAL,
  upper REAL,
  start REAL,
  truth REAL,
  PRIMARY KEY (run, position)
) STRICT, WITHOUT ROWID;
INSERT INTO free_value VALUES(1,0,'joint.hinge.damping','N*m*s/rad',0.0,0.2000000000000000111,0.010000000000000000208,0.048908311008618268744);
INSERT INTO free_value VALUES(1,1,'effect.coulomb_friction.torque','N*m',0.0,0.10000000000000000555,0.0,0.029999999999999998889);
INSERT INTO free_value VALUES(9,0,'joint.hinge.damping','N*m*s/rad',0.0,0.2000000000000000111,0.010000000000000000208,0.048908311008618268744);
INSERT INTO free_value VALUES(9,1,'effect.coulomb_friction.torque','N*m',0.0,0.10000000000000000555,0.0,0.029999999999999998889);
CREATE TABLE pass (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES eea_run (run),
  number INTEGER NOT NULL CHECK (number >= 0),
  ended INTEGER NOT NULL CHECK (ended IN (0, 1)),
  best_model INTEGER REFERENCES model (id),
  best_score REAL,
  best_test INTEGER REFERENCES test (id),
  best_fitness REAL,
  evaluations INTEGER NOT NULL,
  abandoned INTEGER NOT NULL,
  reused INTEGER NOT NULL,
  invalid INTEGER NOT NULL,
  steps INTEGER NOT NULL,
  test_evaluations INTEGER NOT NULL,
  invalid_tests INTEGER NOT NULL,
  test_steps INTEGER NOT NULL,
  CHECK (id = (run << 40) + 1 + number)
) STRICT;
INSERT INTO pass VALUES(1099511627778,1,1,1,1099511627777,0.0010872996778533170012,1099511627781,45260.425488638727983,6,1,0,0,87,6,0,180);
INSERT INTO pass VALUES(9895604649986,9,1,0,NULL,NULL,NULL,NULL,0,0,0,0,0,0,0,0);
CREATE TABLE best_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO best_value VALUES(1099511627778,0,0.033924456635926018843);
INSERT INTO best_value VALUES(1099511627778,1,0.036878912835683806681);
CREATE TABLE objective_score (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO objective_score VALUES(1099511627778,0,'joint.hinge.damping','N*m*s/rad',0.014983854372692249901);
INSERT INTO objective_score VALUES(1099511627778,1,'effect.coulomb_friction.torque','N*m',0.0068789128356838077915);
CREATE TABLE test (
  id INTEGER PRIMARY KEY,
  pass INTEGER NOT NULL REFERENCES pass (id),
  generation INTEGER NOT NULL CHECK (generation >= 0),
  parent INTEGER REFERENCES test (id),
  other_parent INTEGER REFERENCES test (id),
  genome BLOB NOT NULL CHECK (length(genome) % 8 = 0),
  valid INTEGER NOT NULL CHECK (valid IN (0, 1)),
  CHECK (pass >> 40 = id >> 40)
) STRICT;
INSERT INTO test VALUES(1099511627777,1099511627778,0,NULL,NULL,X'000000000000084048da9553beefe13f0000000000000000d8793b8c61eafc3f2c3b3c797c61f53f0000000000c06a40',1);
INSERT INTO test VALUES(1099511627778,1099511627778,0,NULL,NULL,X'0000000000000000478312443c1fb23fee4ace9b951cadbf025e726c76dce63f4530f667f778c63f0000000000a07240',1);
INSERT INTO test VALUES(1099511627779,1099511627778,0,NULL,NULL,X'000000000000004046dd36978a28e33f0000000000000000e73476e6775dc53f48df1efd05d1c63f0000000000406e40',1);
INSERT INTO test VALUES(1099511627780,1099511627778,0,NULL,NULL,X'000000000000f03fa2f36e4019c7d83f000000000000000019a1b4bb904d0d40b87b4c3b84ac07400000000000388b40',1);
INSERT INTO test VALUES(1099511627781,1099511627778,0,NULL,NULL,X'000000000000f03f0fb90643a570e03f00548f5a32257abf16bfa922bde9ed3fdf1d117ab649d33f0000000000e07840',1);
INSERT INTO test VALUES(1099511627782,1099511627778,1,1099511627780,NULL,X'000000000000f03fa2f36e4019c7d83f00000000000000006053a370d1b4d33f0e7d12d09562bf3f0000000000388b40',1);
INSERT INTO test VALUES(1099511627783,1099511627778,1,1099511627781,NULL,X'000000000000f03f0fb90643a570e03f00548f5a32257abf16bfa922bde9ed3fdf1d117ab649d33f0000000000e07840',1);
INSERT INTO test VALUES(9895604649985,9895604649986,0,NULL,NULL,X'0000000000000000e6e9bc8b6d92ce3fc18d084abd5cc13f0ad449cdaf55f63f678505b0dcfa0b400000000000807540',1);
CREATE TABLE test_score (
  test INTEGER NOT NULL REFERENCES test (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (test, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO test_score VALUES(1099511627777,2,NULL);
INSERT INTO test_score VALUES(1099511627778,2,37.665914400697388941);
INSERT INTO test_score VALUES(1099511627779,2,151.35262973400782016);
INSERT INTO test_score VALUES(1099511627780,2,20552.327017300271109);
INSERT INTO test_score VALUES(1099511627781,2,45260.425488638727983);
INSERT INTO test_score VALUES(1099511627782,2,20552.327017300271109);
INSERT INTO test_score VALUES(1099511627783,2,45260.425488638727983);
INSERT INTO test_score VALUES(9895604649985,2,NULL);
CREATE TABLE invalid_test (
  test INTEGER PRIMARY KEY REFERENCES test (id),
  reason TEXT NOT NULL
) STRICT;
CREATE TABLE trial_condition (
  trial INTEGER PRIMARY KEY REFERENCES trial (id),
  hold TEXT NOT NULL CHECK (hold IN ('zero_order', 'first_order')),
  initial TEXT NOT NULL CHECK (json_valid(initial)),
  sensor_noise TEXT NOT NULL CHECK (json_valid(sensor_noise)),
  command_noise TEXT NOT NULL CHECK (json_valid(command_noise))
) STRICT;
INSERT INTO trial_condition VALUES(1099511627777,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(1099511627778,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(9895604649985,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(10995116277761,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
CREATE TABLE target_trial (
  run INTEGER NOT NULL REFERENCES eea_run (run),
  number INTEGER NOT NULL CHECK (number >= 0),
  trial INTEGER NOT NULL REFERENCES trial (id),
  test INTEGER REFERENCES test (id),
  for_transfer INTEGER NOT NULL CHECK (for_transfer IN (0, 1)),
  predicted_fitness REAL,
  measured_fitness REAL,
  PRIMARY KEY (run, number),
  UNIQUE (run, trial),
  CHECK (test >> 40 = run)
) STRICT, WITHOUT ROWID;
INSERT INTO target_trial VALUES(1,0,1099511627777,1099511627777,0,NULL,NULL);
INSERT INTO target_trial VALUES(1,1,1099511627778,1099511627781,1,45260.425488638727983,NULL);
INSERT INTO target_trial VALUES(9,0,9895604649985,9895604649985,0,NULL,NULL);
CREATE TABLE model (
  id INTEGER PRIMARY KEY,
  pass INTEGER NOT NULL REFERENCES pass (id),
  generation INTEGER NOT NULL CHECK (generation >= 0),
  parent INTEGER REFERENCES model (id),
  other_parent INTEGER REFERENCES model (id),
  genome BLOB NOT NULL CHECK (length(genome) % 8 = 0),
  kind TEXT NOT NULL CHECK (kind IN ('full', 'abandoned', 'invalid')),
  reused INTEGER NOT NULL CHECK (reused IN (0, 1)),
  score REAL,
  CHECK (pass >> 40 = id >> 40)
) STRICT;
INSERT INTO model VALUES(1099511627777,1099511627778,0,NULL,NULL,X'df5d92df8b5ea13fd32415f9cae1a23f','full',0,0.0010872996778533170012);
INSERT INTO model VALUES(1099511627778,1099511627778,0,NULL,NULL,X'53a27bed32e2b63f9226462049c49b3f','full',0,0.0055879766674469880105);
INSERT INTO model VALUES(1099511627779,1099511627778,0,NULL,NULL,X'1ce8aaab2f2dae3f0d662290c040b83f','full',0,0.02229289030518150777);
INSERT INTO model VALUES(1099511627780,1099511627778,0,NULL,NULL,X'8ab1b73be931c73f283f43e7c09f9d3f','full',0,0.017713776536285658763);
INSERT INTO model VALUES(1099511627781,1099511627778,1,1099511627777,NULL,X'8064129a3865623f51889923a25fa63f','full',0,0.0043544716156057646644);
INSERT INTO model VALUES(1099511627782,1099511627778,1,1099511627777,1099511627778,X'ec04fe586d94ae3f9d756eb5595dac3f','abandoned',0,0.005643393116933148948);
CREATE TABLE model_score (
  model INTEGER NOT NULL REFERENCES model (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (model, trial, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO model_score VALUES(1099511627777,1099511627777,1,0.0010872996778533170012);
INSERT INTO model_score VALUES(1099511627778,1099511627777,1,0.0055879766674469880105);
INSERT INTO model_score VALUES(1099511627779,1099511627777,1,0.02229289030518150777);
INSERT INTO model_score VALUES(1099511627780,1099511627777,1,0.017713776536285658763);
INSERT INTO model_score VALUES(1099511627781,1099511627777,1,0.0043544716156057646644);
INSERT INTO model_score VALUES(1099511627782,1099511627777,1,0.005643393116933148948);
CREATE TABLE invalid_model (
  model INTEGER PRIMARY KEY REFERENCES model (id),
  reason TEXT NOT NULL
) STRICT;
CREATE TABLE checkpoint (
  run INTEGER PRIMARY KEY REFERENCES eea_run (run),
  commits INTEGER NOT NULL,
  seconds REAL NOT NULL,
  state BLOB NOT NULL CHECK (length(state) % 8 = 0),
  digest TEXT NOT NULL CHECK (length(digest) = 64)
) STRICT;
INSERT INTO checkpoint VALUES(1,1,0.023408717999999998499,X'000000000000f03f0000000000001040000000000000004000000000000018400000000000001c40000000000000f03f000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000f03f000000000000104000000000000018404146dc59050000000fb90643a570e03f00548f5a32257abf16bfa922bde9ed3fdf1d117ab649d33f0000000000e0784085599a9d8d19e640000000000000004000000000000000000000000000000040df5d92df8b5ea13fd32415f9cae1a23f0000000000000040df5d92df8b5ea13fd32415f9cae1a23f0951ab2377d0513f000000000000104000000000000000408064129a3865623f51889923a25fa63f00000000000000408064129a3865623f51889923a25fa63f86dde292fed5713f','e623cdc2dee849da6fb1e08fa9738b54ea8f2364a7e54cd3088333548566d4dc');
INSERT INTO checkpoint VALUES(9,1,6.6769843440000000711,X'000000000000f03f000000000000f03f000000000000f03f0000000000000000000000000000f03f000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000','0394f1eba2cf4ff00baee29a160f196c7b852f326c64d1f0df78185269b6c49e');
CREATE TABLE IF NOT EXISTS "trace" (
  id INTEGER PRIMARY KEY,
  trial INTEGER NOT NULL REFERENCES trial (id),
  comparison INTEGER REFERENCES comparison (id),
  model INTEGER REFERENCES model (id),
  kind TEXT NOT NULL CHECK (kind IN ('measured', 'commands', 'predicted', 'centre_of_mass')),
  channels TEXT NOT NULL CHECK (json_valid(channels)),
  sample_count INTEGER NOT NULL,
  precision TEXT NOT NULL CHECK (precision IN ('float32', 'float64')),
  times BLOB NOT NULL,
  samples BLOB NOT NULL,
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  CHECK (kind <> 'predicted' OR (comparison IS NULL) <> (model IS NULL)),
  CHECK (kind = 'predicted' OR comparison IS NULL),
  CHECK (kind IN ('predicted', 'centre_of_mass') OR model IS NULL)
) STRICT;
INSERT INTO trace VALUES(1099511627777,1099511627777,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000000000000000000000182d4454fb21693f182d4454fb21793f182d4454fb21893f75a7bbe9bbfd953f00dfeec95c47a13f182d4454fb21a93f690091a46c10b23f182d4454fb21b93f98bd4cef4c7ec03f5875c82124d0c43fcc3d95418386c93f8cf510745ad8cd3f00dfeec95c47d13f','c52b075022f95f6a885ae5023bbd45cd9f64b0ec575bbdf10a7bb4e4fbeb4dff');
INSERT INTO trace VALUES(1099511627778,1099511627777,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000004651419103aeae3f3d51419103aebe3ff0fcf0ac8202c73f4251419103aece3fc7d2c83ac22cd33ff0fcf0ac8202d73f1927191f43d8da3f4251419103aede3fb4bdb401e241e13fc9e1626cbab2e03f68999d66b48fdd3f406f75f4f3b9d93f17454d8233e4d53fee1a2510730ed23fee1a2510730ed23f','4c86058b84c957953a33055e2b7ccca04b9f2e284c0ca754599b9eb19b54c931');
INSERT INTO trace VALUES(1099511627779,1099511627777,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf000000000000000000000000000000003dfe9e999999c9bfe44eb2568f4114bf0000000000000000bf4ea3999999c9bf7317d600001c39bf0000000000000000610977959899c9bfd2594be1386351bf0000000000000000ad512d468d99c9bf387fcc6c346662bf0000000000000000d6a87c475699c9bf3d80cda749a270bf000000000000000067e51298a398c9bfe229b5a9411b7bbf0000000000000000085f620bdc96c9bfbe295baf4f8284bf00000000000000003b9397710193c9bffc4f4091835a8dbf000000000000000068387548968bc9bf5077192c4b1c94bf00000000000000009a0183b9877ec9bfb65a25703b669abf00000000000000005aae0610c369c9bf40d1370effa1a0bf000000000000000063e049afda4bc9bf722700dd4e37a4bf00000000000000003772d6964824c9bf687b95317cd0a7bf00000000000000006e663b56a1f3c8bfe55f1f78bc4cabbf0000000000000000aab0cfa3a0bbc8bf','10a8cc454b37888d89241aa209c88eecaad7b4d6c8e4c3fc98bbd8c57de6e817');
INSERT INTO trace VALUES(1099511627780,1099511627778,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000182d4454fb2179bfd221337f7cd992bfd221337f7cd9a2bf5e3855297a6aafbfdec85dc4cbc6b6bff516b34e6aa1bebfef5326471407c4bf182d4454fb21c9bff516b34e6aa1cebf690091a46c10d2bfb2fd70186802d5bffbfa508c63f4d7bf44f830005fe6dabf8cf510745ad8ddbf6b79f8f32a65e0bf','bc1bc5d559fe0888bb7954bede8024b5f65ca8a3a1ff9d79bcb1edd3390d1a08');
INSERT INTO trace VALUES(1099511627781,1099511627778,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'b7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bf','11a4d3e6d7bf498b02a294423254e4aa25d9a57f566b8692a4898376dfb5d740');
INSERT INTO trace VALUES(1099511627782,1099511627778,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf7e0175dbf3bc543f00000000000000003dfe9e999999c9bfab883219d7a56e3f00000000000000007f1492750f99c9bf9c9457dc65217e3f0000000000000000716e9312b996c9bf68acbad839a1883f00000000000000007edac1a6c790c9bfd004df85e113923f0000000000000000cfe537091185c9bf5957a7e90fb5983f0000000000000000d172c5454471c9bf6fdbe0bdf209a03f00000000000000003c1a68671e53c9bf2bc60ee8b706a43f0000000000000000a62c0c429c28c9bfc24a53d35f3ea83f00000000000000004021c61126f0c8bfe3c0fc5fe79dac3f000000000000000068efae1eb2a8c8bf1a9169d72289b03f000000000000000041602d3edc51c8bfc1e1e8717dc4b23f00000000000000009f6fb4f8f0ebc7bffc46bc2d4ef8b43f0000000000000000aa41d031ec77c7bf034dd45ea91cb73f000000000000000042e27d496cf7c6bfe796c7f99f2ab93f000000000000000042ed5ca19b6cc6bf','4170bb6aca2441d63ac518ad71c8b75854e4c91e07d2e71c16a2547f0eaa87e8');
INSERT INTO trace VALUES(1099511627783,1099511627777,NULL,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000000000001a849d39a52adb3a24179f3bebd82c3cbbff9e3c9532033d8780483da5aa903d7fa8c73db4e8033ea742273e958f4c3e437f723e22e48b3e','358253ae13223b0f9508568eb2218eb3976ebc31ed965ce04889c46fa7ab2044');
INSERT INTO trace VALUES(1099511627784,1099511627777,NULL,1099511627777,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe0000000000000000cdcc4cbe91067cb800000000cdcc4cbe5255afb900000000c7cc4cbe678b7eba000000007dcc4cbef2460abb00000000faca4cbe3a647ebb00000000dcc54cbeb7e5d1bb000000006eb84cbe095d20bc00000000b79a4cbe3e5767bc0000000088604cbec98c9fbc00000000abf84bbe7b9fd2bc000000006c514bbe8b5805bd00000000e15d4abe17c422bd000000004d1849be607940bd00000000fd8347be826a5dbd00000000fcad45be','fb6a10d57022722b84b154e39412b68d3eb08a957beee4896ac83020edb37cc5');
INSERT INTO trace VALUES(1099511627785,1099511627778,NULL,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'000000009277cebbfd0b99bc41f116bd2e9577bd8e5ab6bd792dfabdf41723be6d9d4cbe6f0c79bedae293be1014acbeafc9c4be2eb5ddbeca8af6be418107bf','b4e271ca1d8111df0665b99060cce8ff0501bc2eac371716b001659eca2c4ba9');
INSERT INTO trace VALUES(1099511627786,1099511627778,NULL,1099511627777,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe982ca53a00000000cdcc4cbeb7df743b0000000080c84cbe0e7df13b00000000bcb54cbe0b01463c00000000a7854cbe83c3913c000000002a264cbe53ccc73c000000008b834bbe7e10023d000000001f8a4abe66d6223d00000000ee2749bed3a2453d00000000394e47bea0d9693d00000000bcf244be006e873d000000009c1042beae069a3d00000000f3a83ebe296cac3d00000000e4c23abeae59be3d00000000576b36be6192cf3d0000000048b431be','815fb0d6c7c9575f39062e27b9725dfd0ce51856c6a642f2a0892726c2d47e1d');
INSERT INTO trace VALUES(2199023255553,2199023255553,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fa8305cb673d9823fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f3435fe473946ac3fd221337f7cd9b23f182d4454fb21b93f5e3855297a6abf3fd562aa3d043ec33f806a2125532bc73fb530de412b7dcb3f6179cce701cfcf3f4d4080e1b042d23fa46477349c6bd43ffa886e878794d63f15eccc9573bdd83f68cf4c2ad781da3fbbb2ccbe3a46dc3f89b499b5d273dd3f12d7c311266fde3fd956a28baed3de3f5bf7dd6af205df3f9377fff069a1de3f0b55d59416a6dd3fbbb2ccbe3a46dc3f68cf4c2ad781da3fcccbb23ca726d83ff0c5084cf066d53fcc9f44026d10d23fc234bb3b4a0fcd3f6f25cd6cac34c53f182d4454fb21b93f503db83b776a9f3fee20ad669e6ba4bf3435fe473946bcbf806a2125532bc7bf6179cce701cfcfbf22c43b555839d4bf4a2b775d63f4d7bf36d119216fafdbbfd956a28baed3debf5a2e26beb2c9e0bf2830f3b44af7e1bfd221337f7cd9e2bffa72376a6a89e3bfa02300761407e4bf22c43b555839e4bf22c43b555839e4bf','4dc4de9d3675c04cae360a1e78f8918d71f463db13dc449d11b1bace9d0bb135');
INSERT INTO trace VALUES(2199023255554,2199023255553,2199023255553,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(2199023255555,2199023255554,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000df40d09def21693f89292cf2826a8f3f503db83b776a9f3f2631214e1ab4aa3fd9a321fc8ba2b33f2631214e1ab4ba3fc85ecd43e5abc13f75a7bbe9bbfdc53f23f0a98f924fca3f58b666ac6aa1ce3f827f2aa9a079d13f5703e61c4870d33f28462ad26702d53ffa886e878794d63fc88a3b7e1fc2d73f15eccc9573bdd83f9acd7f333f54d93f1b6ebb128386d93f1b6ebb128386d93f182d4454fb21d93f934b91b62f8bd83f4a2b775d63f4d73fc2084d0110f9d63f7266442b3499d53f5703e61c4870d33ffa5c004d4d7ed03f1faf32d10aebc93fc85ecd43e5abc13fc41d56855d47b13fa8305cb673d982bffc248a60bdfdb5bf6ae455ae24d0c4bf5375efede23ccebf5703e61c4870d3bf47eaff9edb8fd7bf6b10c4e85ee6dabf0b55d59416a6ddbf6179cce701cfdfbfd98deade6e97e0bffd9d770bd5e2e0bffd9d770bd5e2e0bf98bd4cef4c7ee0bfe0d89008be9cdfbf0b55d59416a6ddbf6f513ba7e64adbbf12ab55d7eb58d8bf28462ad26702d5bf7bfd3b2c91b0d0bf7c29aa66cbc6c6bfe02510799b6bb4bf182d4454fb21993fc85ecd43e5abc13fb57d5db2084cd03f47eaff9edb8fd73f9377fff069a1de3f5081f79f38a7e23fb236e21a56b2e53faf0ba279eb58e83fea6f88091bb4ea3f','dbeaec820e7395155e17a615b3f207c5f182be74a2c0f1c659b1d5c4ef58e26c');
INSERT INTO trace VALUES(2199023255556,2199023255554,2199023255553,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(2199023255557,2199023255555,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',31,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fdf40d09def21893fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f4239db4158d8ad3fd9a321fc8ba2b33f1faf32d10aebb93f32dd21d3c419c03fd9a321fc8ba2c33f83ab98e3da8fc73fb530de412b7dcb3f6179cce701cfcf3fcc9f44026d10d23f22c43b555839d43f78e832a84362d63f12ab55d7eb58d83fe62e114b934fda3f3a1291dff613dc3f','f6d97370b1a91e9b8be4be92322cc4dd59ee3408a3267f809f0ba669f3e105e6');
INSERT INTO trace VALUES(2199023255558,2199023255555,2199023255553,NULL,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'0000000000000000000000000000000077346037ab90a638f32d97393a37483abad8dc3ab7d5573bed5fc03baed91f3cce9a7a3c033dbb3c2f33063d0f93393db485783d8bada13d69e8cc3d577efd3dbc67193ec60b363e2a3e543e938a733e32b9893ef8bb993e638fa93e29f4b83e3aafc73e7689d53eee50e23e','d67fe685148f8d12ff6a7a250b3edb562df299aa27fbaaf64a3dffb94b717e66');
INSERT INTO trace VALUES(4398046511105,2199023255553,4398046511105,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(4398046511106,2199023255554,4398046511105,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(5497558138881,2199023255553,5497558138881,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000112cd8268a1b07286526bd28da6a512984a9ca29b06ad3380b4e183a0f86e43ade53813b367df73bf60f543c34c8a73c0fdcf93c5d49313d65d1713d01819f3d057bcc3d3ea6ff3d16481c3e39413b3e98415c3ebdab7e3eade3903e0262a23e325eb33e925ec33ee4e5d13e9176de3ee793e83e39caef3eb7adf33e08e2f33ea69bf03eb6a0e93e47ccde3e1813d03ec780bd3e633da73e42898d3e467e613e1ca3223e7f1cbf3df05bcb3cdc093abdecdcedbd098a3ebeda0882befb2ba3be2f27c2be6d84debe77dff7be61f506bf463510bf1f9c17bfff1f1dbfd6bf20bf068222bf068222bf','99549e70fc123ae35cd55228e183a20e5cb58e88d99a3987f29e4bfd68b0cbc3');
INSERT INTO trace VALUES(5497558138882,2199023255554,5497558138881,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'12803cb912803cb912803cb98b63753bbf23613cefebf03cb08f4d3d915a9a3d9445d53d5bd60a3e79ca2c3e707a4f3e83e2713edd83893e80ff983eaff9a63e9215b33e0606bd3e1d8fc43e2087c93e1cd7cb3e1cd7cb3e97b6c93ee38dc53e1f83bf3e0fc9b73ea7b5ac3e63089b3e345f833e70064d3e47c60a3ed72e843d97312cbc4ae3b2bdd69d27be7c0773be8ecb9cbe6fb6bcbec275d8bec05fefbeb47800bfa46706bfb96209bf926309bfa7b706bfea7b01bfe7bbf3be5e36e0be33ffc8be3b20aebe9cd18abe912f3fbe957db7bd63b48b3ca8fb043ef6477b3e1a74b83e8251f13e4865133fc0d02b3f0e68413f98c3533f','a966291dbbd6fc5b6446388d8ed53a9498684fbbbf303241ad8606cced80321b');
INSERT INTO trace VALUES(6597069766657,2199023255553,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000112cd8268a1b07286526bd28da6a512984a9ca29b06ad3380b4e183a0f86e43ade53813b367df73bf60f543c34c8a73c0fdcf93c5d49313d65d1713d01819f3d057bcc3d3ea6ff3d16481c3e39413b3e98415c3ebdab7e3eade3903e0262a23e325eb33e925ec33ee4e5d13e9176de3ee793e83e39caef3eb7adf33e08e2f33ea69bf03eb6a0e93e47ccde3e1813d03ec780bd3e633da73e42898d3e467e613e1ca3223e7f1cbf3df05bcb3cdc093abdecdcedbd098a3ebeda0882befb2ba3be2f27c2be6d84debe77dff7be61f506bf463510bf1f9c17bfff1f1dbfd6bf20bf068222bf068222bf','99549e70fc123ae35cd55228e183a20e5cb58e88d99a3987f29e4bfd68b0cbc3');
INSERT INTO trace VALUES(6597069766658,2199023255554,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'12803cb912803cb912803cb98b63753bbf23613cefebf03cb08f4d3d915a9a3d9445d53d5bd60a3e79ca2c3e707a4f3e83e2713edd83893e80ff983eaff9a63e9215b33e0606bd3e1d8fc43e2087c93e1cd7cb3e1cd7cb3e97b6c93ee38dc53e1f83bf3e0fc9b73ea7b5ac3e63089b3e345f833e70064d3e47c60a3ed72e843d97312cbc4ae3b2bdd69d27be7c0773be8ecb9cbe6fb6bcbec275d8bec05fefbeb47800bfa46706bfb96209bf926309bfa7b706bfea7b01bfe7bbf3be5e36e0be33ffc8be3b20aebe9cd18abe912f3fbe957db7bd63b48b3ca8fb043ef6477b3e1a74b83e8251f13e4865133fc0d02b3f0e68413f98c3533f','a966291dbbd6fc5b6446388d8ed53a9498684fbbbf303241ad8606cced80321b');
INSERT INTO trace VALUES(6597069766659,2199023255555,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000112cd8268a1b07283a2cd828f3f279295892f6298ece9039f1df983a05c2493b9ff3d23b2faf3f3c37f69d3cc43cf23ce47e2f3d2ac8723d8984a13d1dcdcf3d63db013e44461e3ea2bc3c3eaec75c3e5be17d3e07c08f3eba8ba03ee30ab13e9cf7c03e1c0fd03e6313de3e','027037dfddf650a9fc3f98bde24b98042a7f10c103873eb797eff1750b061939');
INSERT INTO trace VALUES(8796093022209,2199023255553,8796093022209,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(8796093022210,2199023255554,8796093022209,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(9895604649985,9895604649985,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000000000000000000000000000000000008000000000000000800000000000000000182d4454fb21693f182d4454fb21893f75a7bbe9bbfd953fd221337f7cd9a23fbbb2ccbe3a46ac3fd221337f7cd9b23faf0ba279eb58b83f8cf510745ad8bd3f4cce9ddcd4e2c03fd221337f7cd9c23fef5326471407c43f','2bc473e180dae2dd4c30840875118384fd914750896ee7054586913dcb213bff');
INSERT INTO trace VALUES(9895604649986,9895604649985,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'8afe5dce2a18b4bfb048716da62991bf9fa2f4dc5642b23f72ede6a9f6d3c53fde3d67b28ae0d03fd536e70c4f6cd53feab8aa900ec4d73f6ebe408e1580d73fb80092d024acd43fb289ffbad28acf3fd33a7a2baf49c33f0482c9293ecdaa3f889388b37a2ca0bf4a8be2d9102cb6bf4ab86883606bbabf4ab86883606bbabf','00138b9a0bc7786d23a1699327d8207a7de244f67ea6e8a5bb208c9fbc60b38e');
INSERT INTO trace VALUES(9895604649987,9895604649985,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf795ff9cae9bf103f00000000000000001a94ae839999c9bf78d1f4e6cc5e263f00000000000000003c1e37fd9899c9bfa837e5b55bbc243f000000000000000015cf3b139999c9bf70c6676eafea1abf0000000000000000fa62ff609999c9bfc3029928d9af4bbf0000000000000000f83fc2a08a99c9bfa9a7b3a88c8062bf000000000000000020a85f9e2e99c9bf1271e0834e3472bf00000000000000000c26584dfb97c9bf4c796bf927467ebf0000000000000000e4eaa68f1f95c9bfda0758dd167886bf00000000000000009eb86565bb8fc9bf42f7dedb26a28ebf0000000000000000bb9830fe3e87c9bfe5b9c1ab058493bf0000000000000000548411f8c67bc9bf4e31de5e4d8397bf00000000000000008383f6ca436ec9bfee3ceeb457059bbf00000000000000008febb4f14e60c9bfdfd9720202d49dbf0000000000000000f9b99bd7b753c9bf054fb8a481d49fbf0000000000000000200ea29ff649c9bf','10418d80a32e4f711a9d0dd5f086598e927be170135fc395abd9843066526282');
INSERT INTO trace VALUES(10995116277761,10995116277761,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000008000000000000000800000000000000000182d4454fb21693fd221337f7cd9823fd221337f7cd9923fbbb2ccbe3a469c3f00dfeec95c47a13fa46477349c6ba43f75a7bbe9bbfda53f75a7bbe9bbfda53fa46477349c6ba43f00dfeec95c47a13fbbb2ccbe3a469c3f75a7bbe9bbfd953fd221337f7cd9923f','06ce5587e16d161c219c735c66a359e70ade2fcab9cafcf4794da79b3cac5436');
INSERT INTO trace VALUES(10995116277762,10995116277761,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000fb7e6abc7493b83ffb7e6abc7493c83f3bdf4f8d976ed23fd6cef753e3a5cb3fb61e85eb51b8be3f007f6abc7493983f40df4f8d976eb2bf1b2fdd240681c5bf4b37894160e5d0bfb61e85eb51b8cebf40df4f8d976ec2bf007f6abc7493a8bf007f6abc7493a83f40df4f8d976ec23f40df4f8d976ec23f','918dd5350a1f18fbddf009cb1aeb7a7f9d3b855209d768e631f4cceb3388ddf2');
INSERT INTO trace VALUES(10995116277763,10995116277761,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf000000000000000000000000000000003dfe9e999999c9bfa4ad08021b5726bf0000000000000000bf4ea3999999c9bf8387b57dbea148bf00000000000000000f66af529599c9bf2ca77e513a2660bf00000000000000000ad7b05a6d99c9bf3e09da60098e6dbf0000000000000000a5969797de98c9bf8428047e410876bf00000000000000007b8a9057c197c9bfc9f405f6c0b67cbf00000000000000000e7d02463696c9bf980726bcd5de80bf000000000000000037dda07dac94c9bf533626314e0b82bf00000000000000004da704d0c593c9bf2b1b7e6a4ab781bf0000000000000000aee958b1e593c9bfa38ab0e17a1080bf0000000000000000ab192b88f494c9bfc7b2c79758517bbf000000000000000096ad12e46296c9bf2cd64ecd1f1f76bf0000000000000000f9c4bbdcaf97c9bf12fb582f1aa271bf000000000000000073b9c6bd8f98c9bfadb7fbf941ce6dbf0000000000000000a1e2e68cef98c9bf','8f469510a10ea4604b775b50290c3a5f6725a6369732a2b5f43dd618e410a28a');
CREATE TABLE robot_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO robot_file VALUES(1,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
INSERT INTO robot_file VALUES(9,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
INSERT INTO robot_file VALUES(10,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
CREATE TABLE carried_out (
  trial INTEGER PRIMARY KEY REFERENCES trial (id),
  run INTEGER NOT NULL REFERENCES run (number),
  test TEXT NOT NULL,
  target TEXT NOT NULL CHECK (length(target) = 64)
) STRICT;
INSERT INTO carried_out VALUES(10995116277761,10,'triangle motor 0.3 N*m 4 Hz 0.3 s','f8115daa0c03f33109d03b0a8bea08381f5d83115673d6960f369f1f132a2973');
CREATE TABLE diagnosis (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  settings TEXT NOT NULL,
  verdict TEXT NOT NULL CHECK (verdict IN ('nothing_missing', 'effect_found', 'not_in_library', 'cannot_tell')),
  probability REAL,
  calibrated INTEGER NOT NULL CHECK (calibrated IN (0, 1)),
  chance REAL,
  hypotheses INTEGER NOT NULL,
  base_times_floor REAL,
  document TEXT NOT NULL CHECK (json_valid(document))
) STRICT;
INSERT INTO diagnosis VALUES(3298534883329,2199023255553,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 43f12e9ae52873cffca6c6e0e8e6442a2a2000f5 1908c4a44d4fe1b0465147537f6fc141ecc119f248f0f2bea1a8ebf2f06f64dd 523da673ea879f220204f0b960bc83c047721f77254a6e4542a479e693b957a7 diagnosis among [coulomb_friction,joint_offset_torque] bf833e151f81c4c9589fe5f53eaaab8ae3aaacb141199e7d7530e37c8cb7fc69 453e0b80f64f109a55e7e9a2e0cea0686a8a49a9f215c8bb3775d9173cfb770a 9f2ecb2a1f102e1bf194d4cba4e12780d99736fd92bba6f56958ecb896261b50 f817d99863a4b3d0529fae39e378c29acce0b26268ab6b49d2d9c60638e436d5 aa7145b9ed0babbf82948d56779999e03de484ceb3b4bf31e8f85ab2214d3bdf f81e33b37e72b4180cc8a2d73b2450eefb8058a9dda652768fa2fa8718fd6f1e 7d9364fd423efcffc96b0ee4ac5ced2f6b6d666d06bb61efa9318af78c615e0d bf07568e673ccaa061f421441eabc12c39cbc077aeea4d6e5d6935186d05bfb6 0e64cd9fbf2ff62c4f5f9bc0eb8d52b7691838e5a257dabbe842a39f378c66f4 7e29a507370a2451853173c01367a75b8126245c160ae2991d389a0650af54bc','effect_found',0.99999999895759705825,0,0.0005000000000000000104,2,2.6912247312194530479,replace('{\n  "verdict": "effect_found",\n  "probability": 0.9999999989575971,\n  "calibrated": false,\n  "noise_floor": {\n    "angle": 0.004119622063335332\n  },\n  "units": {\n    "angle": "rad"\n  },\n  "random_forces": [\n    {\n      "joint": "joint.hinge",\n      "deviation": 0.013872408142878262,\n      "unit": "N*m",\n      "duration_s": 0.025\n    }\n  ],\n  "base": {\n    "fit_rmse": {\n      "angle": 0.007890198351058145\n    },\n    "cv_rmse": {\n      "angle": 0.011086828780125357\n    },\n    "ratio_to_floor": 2.691224731219453\n  },\n  "ranking": [\n    {\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.02388998335120204,\n              "ci95": [\n                0.01687807449405245,\n                0.030901892208351628\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "class": [],\n      "fit_rmse": {\n        "angle": 0.0031908245968171496\n      },\n      "cv_rmse": {\n        "angle": 0.004296509080423733\n      },\n      "ratio_to_floor": 1.0429376807796757,\n      "gain": 20.681737235394372,\n      "gain_ci95": [\n        9.767568215752156,\n        33.99008321655835\n      ],\n      "gain_standard_error": 6.50931334078289,\n      "probability": 0.9999999989124078\n    },\n    {\n      "effects": [\n        {\n          "effect": "joint_offset_torque",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.002784283693496634,\n              "ci95": [\n                -0.002322070884250399,\n                0.007890638271243667\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "class": [],\n      "fit_rmse": {\n        "angle": 0.007416975412427461\n      },\n      "cv_rmse": {\n        "angle": 0.011921087145847876\n      },\n      "ratio_to_floor": 2.8937332023599067,\n      "gain": -3.1384266024084218,\n      "gain_ci95": [\n        -8.34774097397154,\n        1.5065835131108996\n      ],\n      "gain_standard_error": 2.7023027815796947,\n      "probability": 4.518916189663253e-11\n    }\n  ],\n  "p_by_chance": 0.0005,\n  "chance_95": 2.353080098055022,\n  "free_force": {\n    "p": 0.8501458814883441,\n    "gain": {\n      "value": 5.83364234996467,\n      "standard_error": 3.3796697501459123,\n      "ci95": [\n        1.0956436541521781,\n        12.952201138730825\n      ]\n    }\n  },\n  "formulas": [],\n  "residual_force": [],\n  "hypotheses": 2,\n  "findings": [\n    "what is left depends on no joint''s position, velocity or command",\n    "joint.hinge.damping (29.4 mN*m*s/rad → 20.1 mN*m*s/rad) had soaked it up"\n  ],\n  "next_test": "",\n  "next_test_worth": "",\n  "not_testable": [],\n  "seconds": 6.445354061\n}\n','\n',char(10)));
CREATE TABLE candidate_model (
  diagnosis INTEGER NOT NULL REFERENCES diagnosis (id),
  rank INTEGER NOT NULL CHECK (rank >= 1),
  effects TEXT NOT NULL CHECK (json_valid(effects)),
  look_alikes TEXT NOT NULL CHECK (json_valid(look_alikes)),
  gain REAL,
  gain_lower REAL,
  gain_upper REAL,
  times_floor REAL,
  probability REAL,
  PRIMARY KEY (diagnosis, rank)
) STRICT, WITHOUT ROWID;
INSERT INTO candidate_model VALUES(3298534883329,1,'["coulomb_friction @ joint.hinge"]','[]',20.681737235394372475,9.7675682157521563908,33.990083216558346634,1.0429376807796757464,0.9999999989124077615);
INSERT INTO candidate_model VALUES(3298534883329,2,'["joint_offset_torque @ joint.hinge"]','[]',-3.1384266024084217505,-8.3477409739715398018,1.5065835131108995526,2.8937332023599067198,4.5189161896632527087e-11);
CREATE TABLE candidate_value (
  diagnosis INTEGER NOT NULL REFERENCES diagnosis (id),
  rank INTEGER NOT NULL,
  position INTEGER NOT NULL,
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  value REAL,
  lower REAL,
  upper REAL,
  PRIMARY KEY (diagnosis, rank, position)
) STRICT, WITHOUT ROWID;
INSERT INTO candidate_value VALUES(3298534883329,1,0,'coulomb_friction','joint.hinge','torque','N*m',0.023889983351202039724,0.016878074494052451581,0.030901892208351627866);
INSERT INTO candidate_value VALUES(3298534883329,2,0,'joint_offset_torque','joint.hinge','torque','N*m',0.0027842836934966340607,-0.0023220708842503988943,0.0078906382712436665821);
CREATE INDEX fit_by_revision ON fit (revision);
CREATE INDEX comparison_by_revision ON comparison (revision, kind);
CREATE INDEX trace_by_trial ON trace (trial, kind);
CREATE INDEX diagnosis_by_revision ON diagnosis (revision, settings);
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
CREATE VIEW diagnoses AS
SELECT experiment.name AS experiment, revision.number AS revision, diagnosis.verdict, diagnosis.probability,
       diagnosis.calibrated, diagnosis.chance, diagnosis.hypotheses,
       iif(diagnosis.verdict = 'effect_found',
           (SELECT group_concat(value, ' + ') FROM json_each(best.effects)), NULL) AS answer,
       diagnosis.base_times_floor, best.times_floor, diagnosis.id >> 40 AS run, diagnosis.id
FROM diagnosis
JOIN revision ON revision.id = diagnosis.revision
JOIN experiment ON experiment.id = revision.experiment
LEFT JOIN candidate_model AS best ON best.diagnosis = diagnosis.id AND best.rank = 1;
CREATE VIEW effect_ranking AS
SELECT experiment.name AS experiment, revision.number AS revision, candidate_model.rank,
       (SELECT group_concat(value, ' + ') FROM json_each(candidate_model.effects)) AS effects,
       candidate_model.gain, candidate_model.gain_lower, candidate_model.gain_upper, candidate_model.times_floor,
       candidate_model.probability,
       (SELECT group_concat(value, ', ') FROM json_each(candidate_model.look_alikes)) AS look_alikes,
       diagnosis.id AS diagnosis
FROM diagnosis
JOIN candidate_model ON candidate_model.diagnosis = diagnosis.id
JOIN revision ON revision.id = diagnosis.revision
JOIN experiment ON experiment.id = revision.experiment
WHERE diagnosis.id = (SELECT max(id) FROM diagnosis AS newer WHERE newer.revision = diagnosis.revision);
CREATE VIEW traces AS
SELECT experiment.name AS experiment, trial.name AS trial, trial.held_out, trace.kind, revision.number AS revision,
       (SELECT group_concat(json_extract(value, '$.name'), ', ') FROM json_each(trace.channels)) AS channels,
       trace.sample_count, trial.duration, length(trace.times) + length(trace.samples) AS bytes, trace.id,
       trace.model >> 40 AS run, (trace.model & 1099511627775) - 1 AS model
FROM trace
JOIN trial ON trial.id = trace.trial
JOIN experiment ON experiment.id = trial.experiment
LEFT JOIN comparison ON comparison.id = trace.comparison
LEFT JOIN revision ON revision.id = comparison.revision;
CREATE VIEW eea_runs AS
WITH last AS (
  SELECT run, max(number) AS number, count(*) AS passes, sum(evaluations) AS evaluations, sum(steps) AS steps
  FROM pass WHERE ended GROUP BY run)
SELECT eea_run.run, experiment.name AS experiment, eea_run.replicate, coalesce(run.ending, 'not ended') AS ending,
       coalesce(last.passes, 0) AS passes_done, eea_run.passes,
       (SELECT best_score FROM pass WHERE pass.id BETWEEN eea_run.run << 40 AND (eea_run.run << 40) + 1099511627775
          AND ended AND best_model IS NOT NULL ORDER BY id DESC LIMIT 1) AS best_score,
       metric.name AS metric, fitness.name AS fitness,
       (SELECT coalesce(max(id) & 1099511627775, 0) FROM model
        WHERE id BETWEEN eea_run.run << 40 AND (eea_run.run << 40) + 1099511627775) AS models,
       (SELECT coalesce(max(id) & 1099511627775, 0) FROM test
        WHERE id BETWEEN eea_run.run << 40 AND (eea_run.run << 40) + 1099511627775) AS tests,
       (SELECT count(*) FROM target_trial WHERE target_trial.run = eea_run.run) AS trials,
       coalesce(last.evaluations, 0) AS evaluations, coalesce(last.steps, 0) AS steps, checkpoint.seconds, run.seed
FROM eea_run
JOIN run ON run.number = eea_run.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN metric ON metric.id = eea_run.metric
LEFT JOIN metric AS fitness ON fitness.id = eea_run.fitness
LEFT JOIN last ON last.run = eea_run.run
LEFT JOIN checkpoint ON checkpoint.run = eea_run.run;
CREATE VIEW error_by_pass AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass,
       (SELECT count(*) FROM model_score WHERE model_score.model = pass.best_model
          AND model_score.metric = eea_run.metric) AS trials,
       pass.best_score AS error, metric.name AS metric,
       (pass.best_model & 1099511627775) - 1 AS best_model,
       sum(pass.evaluations) OVER so_far AS evaluations_so_far, sum(pass.steps) OVER so_far AS steps_so_far
FROM pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN metric ON metric.id = eea_run.metric
WHERE pass.ended
WINDOW so_far AS (PARTITION BY pass.run ORDER BY pass.number);
CREATE VIEW best_model AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass,
       (pass.best_model & 1099511627775) - 1 AS model, model.generation, free_value.position, free_value.address,
       best_value.value, free_value.unit, free_value.truth, best_value.value - free_value.truth AS error,
       free_value.lower, free_value.upper, pass.best_score
FROM pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN model ON model.id = pass.best_model
JOIN best_value ON best_value.pass = pass.id
JOIN free_value ON free_value.run = pass.run AND free_value.position = best_value.position;
CREATE VIEW parameter_error_by_pass AS
SELECT experiment, run, replicate, pass, address, abs(error) AS error, unit
FROM best_model
WHERE truth IS NOT NULL AND NOT EXISTS (
  SELECT * FROM objective_score
  WHERE objective_score.pass = (best_model.run << 40) + 1 + best_model.pass AND objective_score.name = best_model.address)
UNION ALL
SELECT experiment.name, pass.run, eea_run.replicate, pass.number, objective_score.name, objective_score.value,
       objective_score.unit
FROM objective_score
JOIN pass ON pass.id = objective_score.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment;
CREATE VIEW transfer_gap AS
SELECT experiment.name AS experiment, target_trial.run, eea_run.replicate, pass.number AS pass,
       target_trial.number AS trial, (test.id & 1099511627775) - 1 AS test, fitness.name AS fitness,
       fitness_unit AS unit, predicted_fitness AS predicted, measured_fitness AS measured, measured_fitness - predicted_fitness AS gap,
       for_transfer
FROM target_trial
JOIN eea_run ON eea_run.run = target_trial.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN test ON test.id = target_trial.test
JOIN pass ON pass.id = test.pass
LEFT JOIN metric AS fitness ON fitness.id = eea_run.fitness
WHERE predicted_fitness IS NOT NULL;
CREATE VIEW evaluations AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass, evaluations, abandoned, reused,
       invalid, steps, test_evaluations, invalid_tests, test_steps
FROM pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
WHERE ended;
CREATE VIEW invalid_evaluations AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass, failed.generation, failed.kind,
       failed.number, failed.reason
FROM (SELECT 'model' AS kind, pass, generation, (id & 1099511627775) - 1 AS number, reason
      FROM invalid_model JOIN model ON model.id = invalid_model.model
      UNION ALL
      SELECT 'test', pass, generation, (id & 1099511627775) - 1, reason
      FROM invalid_test JOIN test ON test.id = invalid_test.test) AS failed
JOIN pass ON pass.id = failed.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment;
COMMIT;
PRAGMA application_id = 1281450862;
PRAGMA user_version = 6;
