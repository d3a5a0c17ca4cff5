-- Schema version 2, written by the program of commit ddcb83dd: what sqlite3's .dump prints, and the header's numbers.
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE schema_text (
  name TEXT NOT NULL PRIMARY KEY,
  sha256 TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO schema_text VALUES('views','cd7c1d7a09879445e12d90aaa6a49413b090a4b729af106d35b19f63a65c5da1');
CREATE TABLE experiment (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO experiment VALUES(1099511627777,'walk');
INSERT INTO experiment VALUES(2199023255553,'evolve');
INSERT INTO experiment VALUES(3298534883329,'rig');
CREATE TABLE experiment_text (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  file TEXT NOT NULL,
  text TEXT NOT NULL,
  overrides TEXT NOT NULL CHECK (json_valid(overrides)),
  UNIQUE (experiment, digest)
) STRICT;
INSERT INTO experiment_text VALUES(1099511627777,1099511627777,'78b627758e2474e0f92bb1a0bc74fe459fa879863a9763ec05bc58e95561da15','walk.toml',replace('# A quadruped on soft ground, in a very small run.\n\n[experiment]\nname = "walk"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nrobot = "quadruped"\nset = { "body.torso.mass" = 2.5 }\nhidden_seed = 7\n\n[target.hidden]\n"body.*_lower.mass" = { uniform = [1.0, 7.0] }\n\n[model]\nrobot = "quadruped"\n\n[model.free]\n"body.*_lower.mass" = [1.0, 7.0]\n\n[engine]\nstep = "10 ms"\ndelay_rounding = "step"\ncontact = { stiffness = 2e4, damping = 300.0 }\n\n[test]\nencoding = "recurrent_network"\nparameters = { hidden = 1 }\nduration = "0.1 s"\n\n[estimation]\nsearch = "truncation"\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nsearch = "truncation"\nparameters = { population = 4, keep = 2, generations = 2 }\nfitness = "forward_distance"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(2199023255553,2199023255553,'46212fedd2a107ef1d342f27ee8989e4177ea9865bf64bf4adfa957e1165e16d','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nrobot = "declared"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] } }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "recurrent_network"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nfitness = "random"\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(3298534883329,3298534883329,'f785f7e4841723bda85e9488dd88a39ff8abdf5ab786d0296a7119bc1cd05feb','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = []\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(5497558138881,3298534883329,'a144ca3b3641da5d7fba9c74b68c24c44edb238fe9872a0db3d59f5ec978afa5','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = [\n  { id = "coulomb_friction", effect = "coulomb_friction", where = "joint.hinge" },\n]\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(9895604649985,2199023255553,'70966fe0ef3966e001396c4cf1b1f17e7390c4c4bcc90cc0946ce9013f465b36','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nrobot = "declared"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] } }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "recurrent_network"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nfitness = "random"\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'["engine.substeps=20000","estimation.parameters.generations=20"]');
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
INSERT INTO run VALUES(1,'b664bc1f1c06f30fe80fceeaa6fa75d1',1099511627777,'lacuna run walk.toml --db sample.db --threads 1',1,1,'2026-11-28T12:30:04Z','2026-11-28T12:30:04Z','done');
INSERT INTO run VALUES(2,'13844dd832d41258ccb954ae981bd4b1',2199023255553,'lacuna run evolve.toml --db sample.db --threads 1',1,1,'2026-11-28T12:30:04Z','2026-11-28T12:30:04Z','done');
INSERT INTO run VALUES(3,'1d8cabab392f19dc672d10d2f78d76aa',3298534883329,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:30:04Z','2026-11-28T12:30:05Z','done');
INSERT INTO run VALUES(4,'4d8b1fe410edd05b30e132ee53d9bea9',3298534883329,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:30:05Z','2026-11-28T12:30:05Z','done');
INSERT INTO run VALUES(5,'8e391ec60fe328e7bc67c8ee6ca9fa04',5497558138881,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:30:05Z','2026-11-28T12:30:06Z','done');
INSERT INTO run VALUES(6,'891757c321d6d902f5b90cc5894bfb33',5497558138881,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:30:06Z','2026-11-28T12:30:06Z','done');
INSERT INTO run VALUES(7,'37d6480c0615794f96dc94c537e56555',5497558138881,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:30:06Z','2026-11-28T12:30:06Z','done');
INSERT INTO run VALUES(8,'71661ad742e1284cd92a4575cdbdec6e',3298534883329,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:30:06Z','2026-11-28T12:30:07Z','done');
INSERT INTO run VALUES(9,'6629d29b7cf5384cc2eff41cb0a882dd',9895604649985,'lacuna run evolve.toml --db sample.db --threads 1 --seed 2 --set engine.substeps=20000 --set estimation.parameters.generations=20',2,1,'2026-11-28T12:30:07Z','2026-11-28T12:30:10Z','interrupted');
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
INSERT INTO provenance VALUES(1,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(2,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(3,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(4,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(5,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(6,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(7,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(8,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(9,'0.1.0','ddcb83dd97b1d8236431e141684fa153b72e619c','clang 14.0.6 ','Debug','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
CREATE TABLE plugin_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  build_id TEXT NOT NULL,
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/forward_distance.so','4eb362b83d4687d0f328fea12c62f54dfbcf3b53c1531cb90f20cfcd4c85ec37','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','03c6fbfe4afe36d82f9e20c03cb44431a740bafedbd90cc8209e3aec41658221','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','80179463ae7271d62cb937e9c756deec708197db4c7da7887d75e90acaef4a41','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','41ac8b477bac1328cb928e10588b9334f1c254bb5d0a4d27ca705b4718b01c81','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameters.so','14107ceff658bb071040e9087a07191e089e42a970fb6d6738119c3f4865c722','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/quadruped.so','89bc0a7163bd009b6046a8e917f17d91d7a4bc6351823dec7c66f29fcba58cd8','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/recurrent_network.so','8f08b456548fe924a27ebb60a5ab33eaf7920f9bc7b3827564aad2c486c726a6','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/simulated.so','353961006adbdedab551f04a0d99d49daaddc6e989e0e387501f970d2635b46c','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/truncation.so','ffbb56ed05d66c48a4ccb282a3ee9dab5194a6754ff7a1d66d93b0883b319be1','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','327e51961278892a965040621a9f3ccb495135a60a59d4b07728d0445f8e6e4f','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','03c6fbfe4afe36d82f9e20c03cb44431a740bafedbd90cc8209e3aec41658221','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','80179463ae7271d62cb937e9c756deec708197db4c7da7887d75e90acaef4a41','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','41ac8b477bac1328cb928e10588b9334f1c254bb5d0a4d27ca705b4718b01c81','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/parameters.so','14107ceff658bb071040e9087a07191e089e42a970fb6d6738119c3f4865c722','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/random.so','692ad3556bdf80513fa8db72e6448497136c3aadaa7dcec60634f56aa1462c2b','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/recurrent_network.so','8f08b456548fe924a27ebb60a5ab33eaf7920f9bc7b3827564aad2c486c726a6','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/simulated.so','353961006adbdedab551f04a0d99d49daaddc6e989e0e387501f970d2635b46c','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/truncation.so','ffbb56ed05d66c48a4ccb282a3ee9dab5194a6754ff7a1d66d93b0883b319be1','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','327e51961278892a965040621a9f3ccb495135a60a59d4b07728d0445f8e6e4f','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/recorded.so','6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/declared.so','d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','03c6fbfe4afe36d82f9e20c03cb44431a740bafedbd90cc8209e3aec41658221','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','80179463ae7271d62cb937e9c756deec708197db4c7da7887d75e90acaef4a41','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','41ac8b477bac1328cb928e10588b9334f1c254bb5d0a4d27ca705b4718b01c81','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/parameters.so','14107ceff658bb071040e9087a07191e089e42a970fb6d6738119c3f4865c722','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/random.so','692ad3556bdf80513fa8db72e6448497136c3aadaa7dcec60634f56aa1462c2b','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/recurrent_network.so','8f08b456548fe924a27ebb60a5ab33eaf7920f9bc7b3827564aad2c486c726a6','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/simulated.so','353961006adbdedab551f04a0d99d49daaddc6e989e0e387501f970d2635b46c','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/truncation.so','ffbb56ed05d66c48a4ccb282a3ee9dab5194a6754ff7a1d66d93b0883b319be1','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','327e51961278892a965040621a9f3ccb495135a60a59d4b07728d0445f8e6e4f','0.1.0');
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
INSERT INTO revision VALUES(3298534883329,3298534883329,1,NULL,'929edcca3bcb384318fc844e5413b6e8ef05c33432672564ccd2b5e3c9d15530','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2}]','[]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[]','[]','rigid');
INSERT INTO revision VALUES(5497558138881,3298534883329,2,3298534883329,'247367bc1617e252ebace98c1c7d3fce4e7ccc172c30f79f35cb1ca3f108ab59','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2},{"address":"effect.coulomb_friction.torque","lower":0.0,"start":0.0,"unit":"N*m","upper":10000.0}]','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.0},"where":["joint.hinge"]}]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.0},"where":["joint.hinge"]}]','[]','coulomb_friction');
CREATE TABLE revision_use (
  run INTEGER NOT NULL REFERENCES run (number),
  position INTEGER NOT NULL,
  revision INTEGER NOT NULL REFERENCES revision (id),
  PRIMARY KEY (run, position)
) STRICT, WITHOUT ROWID;
INSERT INTO revision_use VALUES(3,0,3298534883329);
INSERT INTO revision_use VALUES(4,0,3298534883329);
INSERT INTO revision_use VALUES(5,0,5497558138881);
INSERT INTO revision_use VALUES(6,0,5497558138881);
INSERT INTO revision_use VALUES(7,0,5497558138881);
INSERT INTO revision_use VALUES(8,0,3298534883329);
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
INSERT INTO trial VALUES(1099511627777,1099511627777,'run 1, trial 0','','9a60e1d0c544d3c613392d309fb93e1eb8d6705dceaf2291fdbc1fc63dcae049',0,0.10000000000000000555,11);
INSERT INTO trial VALUES(1099511627778,1099511627777,'run 1, trial 1','','c0fea995502a09d726bbc6e1ed9db0a326315d2156ef6d09febc08342fe80082',0,0.10000000000000000555,11);
INSERT INTO trial VALUES(1099511627779,1099511627777,'run 1, trial 2','','4004793402475094976b0caf288b714613280808a113fa84c08700d6326a79f1',0,0.10000000000000000555,11);
INSERT INTO trial VALUES(2199023255553,2199023255553,'run 2, trial 0','','1af18cf1c3c02514f0a9df49f9764611a305a1bd73ce0620cfd4f011b7e5e1b8',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(2199023255554,2199023255553,'run 2, trial 1','','0cee4a509e62015d2d0bac0ba7cb633a3b59309f59a4a9e9df562a4ea212a552',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(2199023255555,2199023255553,'run 2, trial 2','','10120573bb11c5657307fb47c0ca9098ecdb816b52fccf6101fc0d3fccbe40a6',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(3298534883329,3298534883329,'sine.csv','sine.csv','e3ebed47fa02f514f6bc6550bccbd376892c54496379f41872dc75297a1e4cdd',0,1.830000000000000071,62);
INSERT INTO trial VALUES(3298534883330,3298534883329,'steps.csv','steps.csv','ab6bc9493e69a859ca0776df276c8e2e3a993fd6f3cbe042acf2fb6dfbae564c',0,1.830000000000000071,62);
INSERT INTO trial VALUES(3298534883331,3298534883329,'chirp.csv','chirp.csv','336df2d7813e9a0bec213a5bbf62831db7c9326effc1d35d1aa03cfd1e85853e',1,0.9000000000000000222,31);
INSERT INTO trial VALUES(9895604649985,2199023255553,'run 9, trial 0','','ea7fe82ec24d7162dff3cf14e00b6ebcf739bfcc80064992279f58b5edf5b2a9',0,0.29999999999999998889,16);
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
INSERT INTO fit VALUES(3298534883329,3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna ddcb83dd97b1d8236431e141684fa153b72e619c d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2 6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','free_run','huber',3.0,1,13.04615285016976145,116,144,0,1,1,0.43924859889936407331,'[[3.82337252454309e-05,-7.720817428151313e-06],[-7.720817428151313e-06,3.5639873537629597e-06]]','[]','["residuals are correlated over 0.44 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.017, joint.hinge.damping by -0.0065; the intervals reach as far, more substeps make them narrower"]');
INSERT INTO fit VALUES(5497558138881,5497558138881,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna ddcb83dd97b1d8236431e141684fa153b72e619c 3c75e58ac4bc4673a151ee18f9dcf816b8971b9948f8fd396d25d2f8b9ded0b5 d0ec00c21beaa13d1560b4541f1739bfa671c50075357a7a2fd582e367ba63c2 6182e8437786e28fa9dbfcfc80ece2dec503b9326fc5b32ed4e8b3410cc8ab57','free_run','huber',3.0,1,5.5882476127079359073,116,292,0,1,1,0.76051753163209534491,'[[2.1668595402525917e-05,-2.916904770515823e-06,-7.676754316814443e-07],[-2.9169047705158178e-06,1.9459218308467908e-06,-1.418805292706623e-06],[-7.676754316814435e-07,-1.4188052927066205e-06,2.051320461874769e-06]]','[]','["residuals are correlated over 0.76 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.022, effect.coulomb_friction.torque by -0.012; the intervals reach as far, more substeps make them narrower"]');
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
INSERT INTO fit_stage VALUES(3298534883329,0,'free run',0.0,2,1,1,3,1,13.04615285016976145,'[0.5548900339404571,0.030963922380422337]');
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
INSERT INTO fitted_value VALUES(3298534883329,0,'body.arm.mass','kg',0.5,0.55489003394045710582,0.0061833425625167255657,0.54111268814177326813,0.58591794440984890091,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.030963922380422337354,0.0018878525773383257775,0.020304820955041269492,0.035170320054812284626,NULL,1);
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
INSERT INTO holdout_look VALUES(3298534883329,3298534883329,1,3298534883329,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T12:30:05Z');
INSERT INTO holdout_look VALUES(6597069766657,3298534883329,2,5497558138881,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T12:30:06Z');
CREATE TABLE comparison (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  kind TEXT NOT NULL CHECK (kind IN ('refitted', 'as_written')),
  fit INTEGER REFERENCES fit (id),
  look INTEGER,
  step REAL,
  findings TEXT NOT NULL CHECK (json_valid(findings))
) STRICT;
INSERT INTO comparison VALUES(3298534883329,3298534883329,'refitted',3298534883329,1,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(4398046511105,3298534883329,'refitted',3298534883329,NULL,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(5497558138881,5497558138881,'refitted',5497558138881,NULL,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(6597069766657,5497558138881,'refitted',5497558138881,2,0.029999999999999998889,'[]');
INSERT INTO comparison VALUES(8796093022209,3298534883329,'refitted',3298534883329,NULL,0.029999999999999998889,'[]');
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
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.0,'rad',27,0.015162070498811047736,0.1042460068989459615,NULL,-0.012462288829920111984,NULL,NULL,NULL,0.024381254691390213951,0.63000000000000000444,0.0040768215043348789844,0.047776292017303920167);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.10000000000000000555,'rad',0,0.0011094311322454245959,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.5,'rad',0,0.01214601702322436888,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,3298534883329,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(4398046511105,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,3298534883329,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,3298534883330,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(4398046511105,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(4398046511105,3298534883330,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883329,'angle',0.0,'rad',58,0.0044163238863508449266,0.013359357647497868346,NULL,0.002495740569623871273,NULL,NULL,NULL,0.0086644043903566503317,1.080000000000000071,0.0070594231438803837358,0.085104174720160588596);
INSERT INTO comparison_score VALUES(5497558138881,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0011724676471666093183,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883329,'angle',0.5,'rad',0,0.0030635430441543266312,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883330,'angle',0.0,'rad',58,0.0059254418643508912495,0.016433670487370551083,NULL,0.0044453475149773729116,NULL,NULL,NULL,0.012780744619230899328,1.3799999999999998934,0.00097334009209633343649,0.11406395905448198091);
INSERT INTO comparison_score VALUES(5497558138881,3298534883330,'angle',0.10000000000000000555,'rad',0,0.001738584420524602386,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883330,'angle',0.5,'rad',0,0.0051809709788639213626,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.0,'rad',58,0.0044163238863508449266,0.013359357647497868346,NULL,0.002495740569623871273,NULL,NULL,NULL,0.0086644043903566503317,1.080000000000000071,0.0070594231438803837358,0.085104174720160588596);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0011724676471666093183,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.5,'rad',0,0.0030635430441543266312,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.0,'rad',58,0.0059254418643508912495,0.016433670487370551083,NULL,0.0044453475149773729116,NULL,NULL,NULL,0.012780744619230899328,1.3799999999999998934,0.00097334009209633343649,0.11406395905448198091);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.10000000000000000555,'rad',0,0.001738584420524602386,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.5,'rad',0,0.0051809709788639213626,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883331,'angle',0.0,'rad',27,0.0020006530120296531216,0.013755383060037528267,NULL,0.00029964873140976154737,NULL,NULL,NULL,0.0049768588010344894101,0.9000000000000000222,0.0042121656482632611334,0.047776292017303920167);
INSERT INTO comparison_score VALUES(6597069766657,3298534883331,'angle',0.10000000000000000555,'rad',0,0.00086616836156381096008,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883331,'angle',0.5,'rad',0,0.0011800901360702114803,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883329,'angle',0.0,'rad',58,0.014169858751977369715,0.042863751788506154749,NULL,-0.0032455134381021810523,NULL,NULL,NULL,0.026594846608956695943,0.56999999999999995115,0.0067514453745871633866,0.085104174720160588596);
INSERT INTO comparison_score VALUES(8796093022209,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0013111049691513067348,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883329,'angle',0.5,'rad',0,0.0089293733790594374821,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883330,'angle',0.0,'rad',58,0.010749785428433909426,0.029813545653640895205,NULL,0.0033923911296448142245,NULL,NULL,NULL,0.029375441068684282619,1.830000000000000071,0.00098299953687659225379,0.11406395905448198091);
INSERT INTO comparison_score VALUES(8796093022209,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0021974947407376156996,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883330,'angle',0.5,'rad',0,0.0084046870194213214172,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
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
INSERT INTO noise_floor VALUES(3298534883329,3298534883329,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(3298534883329,3298534883330,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(3298534883329,3298534883331,'angle','rad',0.0040768215043348789844,0.00093507523005767695725,0.0,0.0039681365768254360862,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 3.97 mrad');
INSERT INTO noise_floor VALUES(4398046511105,3298534883329,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(4398046511105,3298534883330,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(5497558138881,3298534883329,'angle','rad',0.0070594231438803837358,0.00093507523005767695725,0.0,0.0069972201221975708143,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 7.00 mrad');
INSERT INTO noise_floor VALUES(5497558138881,3298534883330,'angle','rad',0.00097334009209633343649,0.00093507523005767695725,0.0,0.00027023184308049529034,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 270 µrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883329,'angle','rad',0.0070594231438803837358,0.00093507523005767695725,0.0,0.0069972201221975708143,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 7.00 mrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883330,'angle','rad',0.00097334009209633343649,0.00093507523005767695725,0.0,0.00027023184308049529034,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 270 µrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883331,'angle','rad',0.0042121656482632611334,0.00093507523005767695725,0.0,0.0041070638858607547497,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 4.11 mrad');
INSERT INTO noise_floor VALUES(8796093022209,3298534883329,'angle','rad',0.0067514453745871633866,0.00093507523005767695725,0.0,0.0066863778654939164114,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(8796093022209,3298534883330,'angle','rad',0.00098299953687659225379,0.00093507523005767695725,0.0,0.00030318707695443990017,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
CREATE TABLE numerical_error (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  horizon REAL NOT NULL,
  error REAL NOT NULL,
  PRIMARY KEY (comparison, trial, channel, horizon)
) STRICT, WITHOUT ROWID;
INSERT INTO numerical_error VALUES(3298534883329,3298534883329,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(3298534883329,3298534883330,'angle',0.0,0.0098317772017466279615);
INSERT INTO numerical_error VALUES(3298534883329,3298534883331,'angle',0.0,0.0046597907412987736933);
INSERT INTO numerical_error VALUES(4398046511105,3298534883329,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(4398046511105,3298534883330,'angle',0.0,0.0098317772017466279615);
INSERT INTO numerical_error VALUES(5497558138881,3298534883329,'angle',0.0,0.0076946195673142292123);
INSERT INTO numerical_error VALUES(5497558138881,3298534883330,'angle',0.0,0.011394794036997182851);
INSERT INTO numerical_error VALUES(6597069766657,3298534883329,'angle',0.0,0.0076946195673142292123);
INSERT INTO numerical_error VALUES(6597069766657,3298534883330,'angle',0.0,0.011394794036997182851);
INSERT INTO numerical_error VALUES(6597069766657,3298534883331,'angle',0.0,0.0049262601434250557);
INSERT INTO numerical_error VALUES(8796093022209,3298534883329,'angle',0.0,0.0072007591868896141801);
INSERT INTO numerical_error VALUES(8796093022209,3298534883330,'angle',0.0,0.0098317772017466279615);
CREATE TABLE work_time (
  kind TEXT NOT NULL CHECK (kind IN ('fit', 'comparison')),
  id INTEGER NOT NULL,
  seconds REAL NOT NULL,
  PRIMARY KEY (kind, id)
) STRICT, WITHOUT ROWID;
INSERT INTO work_time VALUES('comparison',3298534883329,0.23091737400000000857);
INSERT INTO work_time VALUES('comparison',4398046511105,0.26887783300000001052);
INSERT INTO work_time VALUES('comparison',5497558138881,0.34159438600000002761);
INSERT INTO work_time VALUES('comparison',6597069766657,0.36682081999999999188);
INSERT INTO work_time VALUES('comparison',8796093022209,0.24385796200000001143);
INSERT INTO work_time VALUES('fit',3298534883329,0.14199533400000000082);
INSERT INTO work_time VALUES('fit',5497558138881,0.32498911200000002441);
CREATE TABLE metric (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO metric VALUES(1,'mean_absolute_difference');
INSERT INTO metric VALUES(2,'forward_distance');
INSERT INTO metric VALUES(3,'random');
CREATE TABLE eea_run (
  run INTEGER PRIMARY KEY REFERENCES run (number),
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  replicate INTEGER NOT NULL CHECK (replicate >= 1),
  passes INTEGER NOT NULL CHECK (passes >= 0),
  metric INTEGER NOT NULL REFERENCES metric (id),
  fitness INTEGER REFERENCES metric (id),
  model_genes TEXT NOT NULL CHECK (json_valid(model_genes)),
  test_genes TEXT NOT NULL CHECK (json_valid(test_genes))
) STRICT;
INSERT INTO eea_run VALUES(1,1099511627777,1,2,1,2,'["body.front_left_lower.mass","body.front_right_lower.mass","body.rear_left_lower.mass","body.rear_right_lower.mass"]','["touch_front_left>hidden1","touch_front_right>hidden1","touch_rear_left>hidden1","touch_rear_right>hidden1","angle_front_left>hidden1","angle_front_right>hidden1","angle_rear_left>hidden1","angle_rear_right>hidden1","hidden1>hidden1","bias>hidden1","hidden1>front_left_hip","bias>front_left_hip","hidden1>front_left_knee","bias>front_left_knee","hidden1>front_right_hip","bias>front_right_hip","hidden1>front_right_knee","bias>front_right_knee","hidden1>rear_left_hip","bias>rear_left_hip","hidden1>rear_left_knee","bias>rear_left_knee","hidden1>rear_right_hip","bias>rear_right_hip","hidden1>rear_right_knee","bias>rear_right_knee"]');
INSERT INTO eea_run VALUES(2,2199023255553,1,2,1,3,'["joint.hinge.damping","effect.coulomb_friction.torque"]','["angle>hidden1","hidden1>hidden1","hidden2>hidden1","hidden3>hidden1","bias>hidden1","angle>hidden2","hidden1>hidden2","hidden2>hidden2","hidden3>hidden2","bias>hidden2","angle>hidden3","hidden1>hidden3","hidden2>hidden3","hidden3>hidden3","bias>hidden3","hidden1>motor","hidden2>motor","hidden3>motor","bias>motor"]');
INSERT INTO eea_run VALUES(9,2199023255553,1,2,1,3,'["joint.hinge.damping","effect.coulomb_friction.torque"]','["angle>hidden1","hidden1>hidden1","hidden2>hidden1","hidden3>hidden1","bias>hidden1","angle>hidden2","hidden1>hidden2","hidden2>hidden2","hidden3>hidden2","bias>hidden2","angle>hidden3","hidden1>hidden3","hidden2>hidden3","hidden3>hidden3","bias>hidden3","hidden1>motor","hidden2>motor","hidden3>motor","bias>motor"]');
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
INSERT INTO free_value VALUES(1,0,'body.front_left_lower.mass','kg',1.0,7.0,1.0,3.9016651919990437136);
INSERT INTO free_value VALUES(1,1,'body.front_right_lower.mass','kg',1.0,7.0,1.0,3.7183292487235770629);
INSERT INTO free_value VALUES(1,2,'body.rear_left_lower.mass','kg',1.0,7.0,1.0,4.7203593124855576235);
INSERT INTO free_value VALUES(1,3,'body.rear_right_lower.mass','kg',1.0,7.0,1.0,2.557624119583187916);
INSERT INTO free_value VALUES(2,0,'joint.hinge.damping','N*m*s/rad',0.0,0.2000000000000000111,0.010000000000000000208,0.048908311008618268744);
INSERT INTO free_value VALUES(2,1,'effect.coulomb_friction.torque','N*m',0.0,0.10000000000000000555,0.0,0.029999999999999998889);
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
INSERT INTO pass VALUES(1099511627778,1,1,1,1099511627777,0.0022145699942652777476,1099511627779,0.013237691336816542753,6,1,0,0,60,6,0,60);
INSERT INTO pass VALUES(1099511627779,1,2,1,1099511627783,0.0018144429582938451962,1099511627784,0.036045075233971435313,6,2,0,0,108,6,0,60);
INSERT INTO pass VALUES(2199023255554,2,1,1,2199023255554,0.0010627618157113378431,NULL,NULL,6,2,0,0,82,0,0,0);
INSERT INTO pass VALUES(2199023255555,2,2,1,2199023255563,0.0032390376365840486613,NULL,NULL,6,1,0,0,172,0,0,0);
INSERT INTO pass VALUES(9895604649986,9,1,0,NULL,NULL,NULL,NULL,0,0,0,0,0,0,0,0);
CREATE TABLE best_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO best_value VALUES(1099511627778,0,2.0177336990777803293);
INSERT INTO best_value VALUES(1099511627778,1,3.21273477014102804);
INSERT INTO best_value VALUES(1099511627778,2,4.790069027980777605);
INSERT INTO best_value VALUES(1099511627778,3,5.7851318469823791446);
INSERT INTO best_value VALUES(1099511627779,0,6.7935294329982376382);
INSERT INTO best_value VALUES(1099511627779,1,1.3798318503964126513);
INSERT INTO best_value VALUES(1099511627779,2,5.0107493580784652209);
INSERT INTO best_value VALUES(1099511627779,3,5.7434351785642991927);
INSERT INTO best_value VALUES(2199023255554,0,0.089389021853670855288);
INSERT INTO best_value VALUES(2199023255554,1,0.02711595782742521471);
INSERT INTO best_value VALUES(2199023255555,0,0.083759962422083736321);
INSERT INTO best_value VALUES(2199023255555,1,0.03519043151889830745);
CREATE TABLE objective_score (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO objective_score VALUES(1099511627778,0,'body.front_left_lower.mass','kg',1.8839314929212633842);
INSERT INTO objective_score VALUES(1099511627778,1,'body.front_right_lower.mass','kg',0.50559447858254902286);
INSERT INTO objective_score VALUES(1099511627778,2,'body.rear_left_lower.mass','kg',0.069709715495219981562);
INSERT INTO objective_score VALUES(1099511627778,3,'body.rear_right_lower.mass','kg',3.2275077273991912285);
INSERT INTO objective_score VALUES(1099511627778,4,'body.*.mass','kg',1.4216858535995560153);
INSERT INTO objective_score VALUES(1099511627779,0,'body.front_left_lower.mass','kg',2.8918642409991939246);
INSERT INTO objective_score VALUES(1099511627779,1,'body.front_right_lower.mass','kg',2.3384973983271644115);
INSERT INTO objective_score VALUES(1099511627779,2,'body.rear_left_lower.mass','kg',0.29039004559290759743);
INSERT INTO objective_score VALUES(1099511627779,3,'body.rear_right_lower.mass','kg',3.1858110589811112767);
INSERT INTO objective_score VALUES(1099511627779,4,'body.*.mass','kg',2.1766406859750944136);
INSERT INTO objective_score VALUES(2199023255554,0,'joint.hinge.damping','N*m*s/rad',0.040480710845052586543);
INSERT INTO objective_score VALUES(2199023255554,1,'effect.coulomb_friction.torque','N*m',0.0028840421725747841796);
INSERT INTO objective_score VALUES(2199023255555,0,'joint.hinge.damping','N*m*s/rad',0.034851651413465467577);
INSERT INTO objective_score VALUES(2199023255555,1,'effect.coulomb_friction.torque','N*m',0.0051904315188983085604);
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
INSERT INTO test VALUES(1099511627777,1099511627778,0,NULL,NULL,X'5833cc7b71c1e73f9cd748c1cfc9eb3ff84a86c52a1ed23ff89757597e53ed3fd1c514eb06adefbf9db60328a14ce2bffdbd742199e5e4bff8158080f4b3de3f00c948074ad3d43fb621253cf6d5d5bf6145ce39aa5febbf11b344166269eebf6c95c1faa9a8ec3f2cebec9b03afc5bf29520d9bfb7cecbf5ea5be3d274fdcbf82081ab54031debf506bdced66b5c83f16cca1c6fdaddebf141efac50d23c1bf015ce45a2cafe1bf08a2c46b3932dc3f18e078ff6129d03ff8b1a8d14a66e23f05ddbfefd247e3bffc92111a8544e73f',1);
INSERT INTO test VALUES(1099511627778,1099511627778,0,NULL,NULL,X'dd2d7783648ae7bf4d49f838fc72e8bf723e81ac7c42d8bf8457b285e5b3eb3f641f4b361672e83f6ab3579415ccd9bfb8df157f2624d83f008cbaecd785753fa505bc1abacae6bf6ce287eb3103eb3ff074f99b87c1ed3fb26bd3095d9cd6bf70d26109cf66c63fcf497a8c5437e3bfc0856c558898c13ff0281166bfc2a8bf10fc9f8d3075ce3fa0725c71ce0ad03f39cbdc40acbee0bfc00c9b2ec4fee93f91f7b2b329d8eebfe0cf0072e8c0e03f004635be2da5e33ff0b076fa69b4df3f10a65fceb13dd53fa0a10d098eb7bc3f',1);
INSERT INTO test VALUES(1099511627779,1099511627778,0,NULL,NULL,X'00cc8361b18da73f94e1b6a278dcef3f80e9123c4603d83f44b97755e3bbe83fcf580b236d84e1bfcd54ee857874e0bf8234c7118e65dfbf115ff7b75e9ee7bf87bfe79b1b8be6bfce0d4e1fb2aad7bf94d4bf76b3b5e23fbc4b72bfd37ee53f950f7df36862e2bff8bda5127d7be93f505b44c471e9c23f90f03c058835a3bfe0ff7478654cc23f00435b7f77ebdf3f083c82c88f33bdbfb977c28f720be5bf80a1eb46812f9b3fea1cd29bb192d7bf607a96e3732fc03f3519455ff178edbf2001b556c697ca3f40ab9f6ad8bfdd3f',1);
INSERT INTO test VALUES(1099511627780,1099511627778,0,NULL,NULL,X'4e70bf7b3f7dd9bfc8d67181a997d23f603cbc984044b03fbf100ff40f4ee2bfceed42fe99a5debfd8477b0316c3e73ff547d00de18fe0bf685c0b79b3e8ea3f7cefcb6f4e6be73f4f806b6c8228e0bf39494833a26fe6bfc00368de2c12cf3f4eb996fac832d6bf8061242fdf59b23fb7896ce459dce7bf402d3bc3cb97ee3fa0e51726a84db33fbc7d45de6ac2e23f24c289812db6e53fcf273d73ba17e5bf1e7053062d6adbbf2777e3fe909ee4bf9c928758940cc7bf2471d2068671e13f9d1387b0d831e6bff03d9f8b00a8c43f',1);
INSERT INTO test VALUES(1099511627781,1099511627778,0,NULL,NULL,X'd6fb04b07c42d6bfdc68168ad1cce63f501b22f6a9c9a5bfc2a3031ae5cbd6bf0b99907ad424e7bfec9bfa5756f5c9bfd81137ad8e1ae83f70ab84c92644c23f62f8d1967ee7dbbf0078012299fe523f2c2888cadf17c5bf5373e9d43c10e6bf62278181f509dbbfd036c1589f96d43f14ef00443e11c5bfd0497eaa6653c23f34ce4e537d5ecabf549650519b6aef3f5374d96aa018edbf70f0473d6692e33f58fd3ec5e101b0bfa7a4b0c8e8d9efbfc4e73d00b3e8e03f9c5cb38dd89ae93fcc6d4e7ee958c9bfc0e0b167de74e03f',1);
INSERT INTO test VALUES(1099511627782,1099511627778,1,1099511627780,NULL,X'4e70bf7b3f7dd9bfc8d67181a997d23f603cbc984044b03fbf100ff40f4ee2bf9123553b18aee8bf344df0d8662be43ff547d00de18fe0bf685c0b79b3e8ea3f7cefcb6f4e6be73f4f806b6c8228e0bf39494833a26fe6bfc00368de2c12cf3f4eb996fac832d6bf8061242fdf59b23fb7896ce459dce7bf402d3bc3cb97ee3fa0e51726a84db33fbc7d45de6ac2e23f24c289812db6e53fcf273d73ba17e5bf1e7053062d6adbbf2777e3fe909ee4bf9c928758940cc7bf2471d2068671e13f9d1387b0d831e6bff03d9f8b00a8c43f',1);
INSERT INTO test VALUES(1099511627783,1099511627778,1,1099511627779,NULL,X'00cc8361b18da73f94e1b6a278dcef3f80e9123c4603d83f44b97755e3bbe83fcf580b236d84e1bfcd54ee857874e0bf8234c7118e65dfbf115ff7b75e9ee7bf87bfe79b1b8be6bfce0d4e1fb2aad7bf94d4bf76b3b5e23fbc4b72bfd37ee53f950f7df36862e2bff8bda5127d7be93f10acec4639e4c03f90f03c058835a3bfbe1facc9dd9ad1bf00435b7f77ebdf3f083c82c88f33bdbfb977c28f720be5bf80a1eb46812f9b3fea1cd29bb192d7bf607a96e3732fc03f20e535c8afc09bbf2001b556c697ca3f40ab9f6ad8bfdd3f',1);
INSERT INTO test VALUES(1099511627784,1099511627779,0,NULL,NULL,X'4fe9b05736d2e9bfe52ed80602c4efbfa35e2016686eecbf6ee6b213147cd3bf301bb389d169c83f786a72559759e43f988033e8e219e73f8db749fdc537e1bfbfb664f2cf21e9bf846a45008ecdeb3f2882c68505a0db3f3ce4eae73b25e93f06f1a6513cc3d4bf1986bf853f27eebf18f3cbb9d477d33f4058d27f899ae23f74ed9ab74bcfcfbf1a015a6fff0adebf64f293e368abc1bf5940a0d417b6e0bf92b485f4ba02d3bfc01696e7ed88b53fb4af7e8b2376eb3f4de526869352eabf72bd39877485dcbf54b0c92a7621ed3f',1);
INSERT INTO test VALUES(1099511627785,1099511627779,0,NULL,NULL,X'617dc064ebe6e2bfc08e26fac732b83f100c7a9ca1ccde3f90932855bdb0ec3f1caf648e3ac8ccbfb806dcf3360de13f20af24eb4375df3fd80f5dba5f9fd83fd493cb410719e43f174ab6cf2944e4bf43ee3240b14be9bf6a893daefb3fd2bf2ca7ceb3c946cfbfad1a868e7339e1bf90d456cd9685c53f6a359cc74a33d1bfb77a403b05dce7bff8c97796a95beb3fe0e2411dfe85d53f30f48ff4a354dc3f24ebb5b3f448e33fc2b9aed273ded8bf5093dcfae45bdd3f548c7ee61831c9bf9022c5567d01c33f1e5959ef45bad2bf',1);
INSERT INTO test VALUES(1099511627786,1099511627779,0,NULL,NULL,X'ddea7863d8f7e9bf1f035b65b22de7bf2e66d998461edabf342b1738ec61e23f61e831b7a104e1bf84d14db26045ef3fa772b69afeb8eabf702b7ce60a5ad53f998e6e0b5a49eebfe09ad620cc859cbf80ecbba673a3943f27fa8956efd2e4bf70b39523f3bdcc3fad65b88c668becbff8268e7c0f0db5bf40926cd3c21b8abf18da877a15efe43f20bdad93af3ddb3f6019da5dd253dd3f74e7d1a1f884e33f3c923938423ced3fd845a8154511bbbfb04c3ed2b6f3d33f3cc1516e743ec6bfa4b3111b42faea3fb943a3c34cbbeabf',1);
INSERT INTO test VALUES(1099511627787,1099511627779,0,NULL,NULL,X'a61ad6381609d8bf74b0938e46dde53f7dd0f4d8f370eebfa22b248172b2dfbfb069ac495d2fa2bf809d95a6b83c7dbf7427eb382774ea3fe2db0e501250d3bf385bf5a822feb0bfbef740fce079d7bf776d11440048e6bf08bde211d95edf3fb4ac62ab9107e83fc2d5d55e6123d6bf305186a0e050ce3fa0b36a0b97bcd33f45ded3a4e683efbf68781c76f652b7bfe03afb372f22d83f805f8ba18bceae3f10c12f752f27a5bf374d2e3c6c20e4bff02920d15124e63fc04b1876cdfbba3f08958bc2ce79d03f198dadd2d62ae2bf',1);
INSERT INTO test VALUES(1099511627788,1099511627779,1,1099511627787,NULL,X'a61ad6381609d8bf74b0938e46dde53f7dd0f4d8f370eebfa22b248172b2dfbfb069ac495d2fa2bf809d95a6b83c7dbf7427eb382774ea3fe2db0e501250d3bf385bf5a822feb0bfbef740fce079d7bf776d11440048e6bf08bde211d95edf3fa497a942a65dc3bfc2d5d55e6123d6bf305186a0e050ce3fa0b36a0b97bcd33f45ded3a4e683efbf68781c76f652b7bfe03afb372f22d83f805f8ba18bceae3f10c12f752f27a5bf374d2e3c6c20e4bff02920d15124e63fc04b1876cdfbba3f08958bc2ce79d03f198dadd2d62ae2bf',1);
INSERT INTO test VALUES(1099511627789,1099511627779,1,1099511627787,NULL,X'a61ad6381609d8bf74b0938e46dde53f7dd0f4d8f370eebfa22b248172b2dfbf9863da2c9154b6bf809d95a6b83c7dbf7427eb382774ea3fe2db0e501250d3bf385bf5a822feb0bfbf0e2af718d2ecbf776d11440048e6bf08bde211d95edf3fb4ac62ab9107e83fc49c82d97e5ce73f305186a0e050ce3fa0b36a0b97bcd33f45ded3a4e683efbf68781c76f652b7bfe03afb372f22d83f805f8ba18bceae3f10c12f752f27a5bf374d2e3c6c20e4bff02920d15124e63fc04b1876cdfbba3f93ed4a258b1ae7bf198dadd2d62ae2bf',1);
INSERT INTO test VALUES(2199023255553,2199023255554,0,NULL,NULL,X'5833cc7b71c1e73f9cd748c1cfc9eb3ff84a86c52a1ed23ff89757597e53ed3fd1c514eb06adefbf9db60328a14ce2bffdbd742199e5e4bff8158080f4b3de3f00c948074ad3d43fb621253cf6d5d5bf6145ce39aa5febbf11b344166269eebf6c95c1faa9a8ec3f2cebec9b03afc5bf29520d9bfb7cecbf5ea5be3d274fdcbf82081ab54031debf506bdced66b5c83f16cca1c6fdaddebf',1);
INSERT INTO test VALUES(2199023255554,2199023255554,0,NULL,NULL,X'5833cc7b71c1e73f9cd748c1cfc9eb3ff84a86c52a1ed23ff89757597e53ed3fd1c514eb06adefbf9db60328a14ce2bffdbd742199e5e4bff8158080f4b3de3f00c948074ad3d43fb621253cf6d5d5bf6145ce39aa5febbf11b344166269eebf6c95c1faa9a8ec3f2cebec9b03afc5bf29520d9bfb7cecbf5ea5be3d274fdcbf82081ab54031debf506bdced66b5c83f16cca1c6fdaddebf',1);
INSERT INTO test VALUES(2199023255555,2199023255555,0,NULL,NULL,X'8c92675c7bf3e93f90d7f20f3f66a6bf30ec21cc1f66db3fb20898f70e73d0bf2d924166eee6e8bf0440995947bde43f759711681e37edbfc932acd2ae30e8bf82e10b6f4fb3d0bf01f224060cf1e3bfe883b52e791ae33f803b22008a38ea3fc4e337e1d5b9e53f46ae79994e23dfbf4954f3509bbee2bf7d4636a57693eebfe874c478ba0fd13f284741a36f97d73f48c1ffd8dae9e83f',1);
INSERT INTO test VALUES(9895604649985,9895604649986,0,NULL,NULL,X'4faa55ba348defbf54f4342ee817cabf98410e26e6efec3fc00520754c78e83f18d90b431d61ef3fd2eace753ff2d3bf38e547222f60d93fb0c4aa43e640d63fbce75f923327ea3f9cd7bf4b7f88c5bf25e686d1b88aedbf1f2981bf2c91e7bf400f279978a6bf3f4c8549bd6ef2ed3ff497bb23c0abc1bfc7104ad008ace3bfeb9ff3fe63b6e0bf8d87aae54f1aedbf80a4a9c7e9eeab3f',1);
CREATE TABLE test_score (
  test INTEGER NOT NULL REFERENCES test (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (test, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO test_score VALUES(1099511627777,2,NULL);
INSERT INTO test_score VALUES(1099511627778,2,-0.0093335363191988096609);
INSERT INTO test_score VALUES(1099511627779,2,0.013237691336816542753);
INSERT INTO test_score VALUES(1099511627780,2,0.0096639391081407566286);
INSERT INTO test_score VALUES(1099511627781,2,-0.012460464102370227834);
INSERT INTO test_score VALUES(1099511627782,2,0.0096637236228563072604);
INSERT INTO test_score VALUES(1099511627783,2,0.0031458917030233179978);
INSERT INTO test_score VALUES(1099511627784,2,0.036045075233971435313);
INSERT INTO test_score VALUES(1099511627785,2,-0.018038817143184851521);
INSERT INTO test_score VALUES(1099511627786,2,-0.010651938511846106849);
INSERT INTO test_score VALUES(1099511627787,2,0.013329176642530637941);
INSERT INTO test_score VALUES(1099511627788,2,0.012597387558262937434);
INSERT INTO test_score VALUES(1099511627789,2,0.0051455243419406548888);
INSERT INTO test_score VALUES(2199023255553,3,NULL);
INSERT INTO test_score VALUES(2199023255554,3,NULL);
INSERT INTO test_score VALUES(2199023255555,3,NULL);
INSERT INTO test_score VALUES(9895604649985,3,NULL);
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
INSERT INTO trial_condition VALUES(1099511627777,'zero_order','[[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0]]','[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]','[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]');
INSERT INTO trial_condition VALUES(1099511627778,'zero_order','[[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0]]','[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]','[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]');
INSERT INTO trial_condition VALUES(1099511627779,'zero_order','[[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0],[0.0,0.0,0.0]]','[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]','[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]');
INSERT INTO trial_condition VALUES(2199023255553,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(2199023255554,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(2199023255555,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(9895604649985,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
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
INSERT INTO target_trial VALUES(1,0,1099511627777,1099511627777,0,NULL,-0.014989087735130805084);
INSERT INTO target_trial VALUES(1,1,1099511627778,1099511627779,0,0.013237691336816542753,0.012990817613683366266);
INSERT INTO target_trial VALUES(1,2,1099511627779,1099511627784,1,0.036045075233971435313,0.031177916352798144827);
INSERT INTO target_trial VALUES(2,0,2199023255553,2199023255553,0,NULL,NULL);
INSERT INTO target_trial VALUES(2,1,2199023255554,2199023255554,0,NULL,NULL);
INSERT INTO target_trial VALUES(2,2,2199023255555,2199023255555,1,NULL,NULL);
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
INSERT INTO model VALUES(1099511627777,1099511627778,0,NULL,NULL,X'009ccc905124004085d28349aeb30940300af3da072913407e59579af9231740','full',0,0.0022145699942652777476);
INSERT INTO model VALUES(1099511627778,1099511627778,0,NULL,NULL,X'2de8a3be0f740d4014e22047020405402ffdadf30bb71b4096fe7e1edc1d1440','full',0,0.0023043668865162184739);
INSERT INTO model VALUES(1099511627779,1099511627778,0,NULL,NULL,X'cd1c78582e250640ac3f2087b4bc1a40b67c2b2df6e707401118413ca1e70640','full',0,0.0027704181967400671321);
INSERT INTO model VALUES(1099511627780,1099511627778,0,NULL,NULL,X'7136fca7cabe19409b85676ce2e205403fbda51046fc1a407cecdbfd0de21240','full',0,0.0024761139222842227895);
INSERT INTO model VALUES(1099511627781,1099511627778,1,1099511627777,NULL,X'e4130751ee13f13fccef5f01a8f90c40300af3da072913402e2ba8028c141240','abandoned',0,0.002401262937691777885);
INSERT INTO model VALUES(1099511627782,1099511627778,1,1099511627777,1099511627778,X'4e12b7419355064014e22047020405402ffdadf30bb71b4096fe7e1edc1d1440','full',0,0.0022618669781833034178);
INSERT INTO model VALUES(1099511627783,1099511627779,0,NULL,NULL,X'3c90ccfa922c1b407ae8f68fca13f63f9a9935e1010b1440b2844a1247f91640','full',0,0.0018144429582938451962);
INSERT INTO model VALUES(1099511627784,1099511627779,0,NULL,NULL,X'60aaa4a00eba1740443477634ef51240668191d7bfd112404958850e9ac30340','full',0,0.0019720154025782551596);
INSERT INTO model VALUES(1099511627785,1099511627779,0,NULL,NULL,X'62bf3c60c0f5fd3f33dbcc9028651940f8bf6ec072861740607f563ae3d6fc3f','full',0,0.0019587662224804206108);
INSERT INTO model VALUES(1099511627786,1099511627779,0,NULL,NULL,X'78e5ce3975e91140edfde78327fa0d40a3a2f359ae390f40c8573e1fb67f1940','full',0,0.0018717443268168572692);
INSERT INTO model VALUES(1099511627787,1099511627779,1,1099511627786,NULL,X'78e5ce3975e91140e6e57dc5c9faf93f8c3d2796ff5e024010d98be792b5f73f','abandoned',0,0.0020869683787999599583);
INSERT INTO model VALUES(1099511627788,1099511627779,1,1099511627786,1099511627783,X'd8e5beab5824fb3f662313eb75801340a3a2f359ae390f400715184753ed0140','abandoned',0,0.0018766224693624905962);
INSERT INTO model VALUES(2199023255553,2199023255554,0,NULL,NULL,X'df5d92df8b5ea13fd32415f9cae1a23f','full',0,0.0026334953899918591389);
INSERT INTO model VALUES(2199023255554,2199023255554,0,NULL,NULL,X'53a27bed32e2b63f9226462049c49b3f','full',0,0.0010627618157113378431);
INSERT INTO model VALUES(2199023255555,2199023255554,0,NULL,NULL,X'1ce8aaab2f2dae3f0d662290c040b83f','full',0,0.013997574688554816069);
INSERT INTO model VALUES(2199023255556,2199023255554,0,NULL,NULL,X'8ab1b73be931c73f283f43e7c09f9d3f','full',0,0.0034651808905966025378);
INSERT INTO model VALUES(2199023255557,2199023255554,1,2199023255554,NULL,X'8064129a3865623f51889923a25fa63f','abandoned',0,0.0033052895406585694471);
INSERT INTO model VALUES(2199023255558,2199023255554,1,2199023255554,2199023255553,X'ec04fe586d94ae3f9d756eb5595dac3f','abandoned',0,0.0028832806691234968456);
INSERT INTO model VALUES(2199023255559,2199023255555,0,NULL,NULL,X'5211b83e14b8c83f2d24c8ee0aee793f','full',0,0.0036072359511438185225);
INSERT INTO model VALUES(2199023255560,2199023255555,0,NULL,NULL,X'efe8f344ba0ac53f806f20c32fe9af3f','full',0,0.013287640700668183063);
INSERT INTO model VALUES(2199023255561,2199023255555,0,NULL,NULL,X'17654ecd00c89d3fd0e940674dd2b63f','full',0,0.013997574688538847939);
INSERT INTO model VALUES(2199023255562,2199023255555,0,NULL,NULL,X'0061b9e1c6adbd3fa8db5d373b71a73f','full',0,0.0077688312421612653463);
INSERT INTO model VALUES(2199023255563,2199023255555,1,2199023255562,NULL,X'712951fb4a71b53facf702f17a04a23f','full',0,0.0032390376365840486613);
INSERT INTO model VALUES(2199023255564,2199023255555,1,2199023255562,2199023255559,X'770c646e01c5973f076a14500689b03f','abandoned',0,0.0078213261368441575061);
CREATE TABLE model_score (
  model INTEGER NOT NULL REFERENCES model (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (model, trial, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO model_score VALUES(1099511627777,1099511627777,1,0.0022145699942652777476);
INSERT INTO model_score VALUES(1099511627778,1099511627777,1,0.0023043668865162184739);
INSERT INTO model_score VALUES(1099511627779,1099511627777,1,0.0027704181967400671321);
INSERT INTO model_score VALUES(1099511627780,1099511627777,1,0.0024761139222842227895);
INSERT INTO model_score VALUES(1099511627781,1099511627777,1,0.002401262937691777885);
INSERT INTO model_score VALUES(1099511627782,1099511627777,1,0.0022618669781833034178);
INSERT INTO model_score VALUES(1099511627783,1099511627777,1,0.00254870284829192403);
INSERT INTO model_score VALUES(1099511627783,1099511627778,1,0.0010801830682957657119);
INSERT INTO model_score VALUES(1099511627784,1099511627777,1,0.0030144756445122334806);
INSERT INTO model_score VALUES(1099511627784,1099511627778,1,0.0009295551606442758628);
INSERT INTO model_score VALUES(1099511627785,1099511627777,1,0.0027041680427409963555);
INSERT INTO model_score VALUES(1099511627785,1099511627778,1,0.0012133644022198448661);
INSERT INTO model_score VALUES(1099511627786,1099511627777,1,0.0022712469250423202894);
INSERT INTO model_score VALUES(1099511627786,1099511627778,1,0.00147224172859139555);
INSERT INTO model_score VALUES(1099511627787,1099511627777,1,0.0041739367575999199166);
INSERT INTO model_score VALUES(1099511627788,1099511627777,1,0.0029738611023910847125);
INSERT INTO model_score VALUES(1099511627788,1099511627778,1,0.00077938383633389637147);
INSERT INTO model_score VALUES(2199023255553,2199023255553,1,0.0026334953899918591389);
INSERT INTO model_score VALUES(2199023255554,2199023255553,1,0.0010627618157113378431);
INSERT INTO model_score VALUES(2199023255555,2199023255553,1,0.013997574688554816069);
INSERT INTO model_score VALUES(2199023255556,2199023255553,1,0.0034651808905966025378);
INSERT INTO model_score VALUES(2199023255557,2199023255553,1,0.0033052895406585694471);
INSERT INTO model_score VALUES(2199023255558,2199023255553,1,0.0028832806691234968456);
INSERT INTO model_score VALUES(2199023255559,2199023255553,1,0.0035498120077110855222);
INSERT INTO model_score VALUES(2199023255559,2199023255554,1,0.0036646598945765519565);
INSERT INTO model_score VALUES(2199023255560,2199023255553,1,0.013303640011318184493);
INSERT INTO model_score VALUES(2199023255560,2199023255554,1,0.013271641390018178163);
INSERT INTO model_score VALUES(2199023255561,2199023255553,1,0.013997574688554817803);
INSERT INTO model_score VALUES(2199023255561,2199023255554,1,0.013997574688522874605);
INSERT INTO model_score VALUES(2199023255562,2199023255553,1,0.0078230416458487193193);
INSERT INTO model_score VALUES(2199023255562,2199023255554,1,0.0077146208384738139754);
INSERT INTO model_score VALUES(2199023255563,2199023255553,1,0.0033194333913210091226);
INSERT INTO model_score VALUES(2199023255563,2199023255554,1,0.0031586418818470890675);
INSERT INTO model_score VALUES(2199023255564,2199023255553,1,0.013617257281152192471);
INSERT INTO model_score VALUES(2199023255564,2199023255554,1,0.002025394992536121673);
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
INSERT INTO checkpoint VALUES(1,1,0.085785843999999999986,X'000000000000f03f0000000000001040000000000000084000000000000028400000000000002a400000000000001c4000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000040000000000000184000000000000010403c90ccfa922c1b407ae8f68fca13f63f9a9935e1010b1440b2844a1247f9164000000000000010403c90ccfa922c1b407ae8f68fca13f63f9a9935e1010b1440b2844a1247f91640ba24a54a53ba5d3f0000000000002240000000000000104078e5ce3975e91140edfde78327fa0d40a3a2f359ae390f40c8573e1fb67f1940000000000000104078e5ce3975e91140edfde78327fa0d40a3a2f359ae390f40c8573e1fb67f1940f4c4e32aaaaa5e3f','cd36f72e935064990d7ac9fdb3f3ffb9fa574226486fa9aaa428aa1225539302');
INSERT INTO checkpoint VALUES(2,1,0.012300204000000000345,X'000000000000f03f000000000000104000000000000008400000000000002840000000000000084000000000000018400000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000004000000000000024400000000000000040712951fb4a71b53facf702f17a04a23f0000000000000040712951fb4a71b53facf702f17a04a23fde4d0717c1886a3f000000000000184000000000000000405211b83e14b8c83f2d24c8ee0aee793f00000000000000405211b83e14b8c83f2d24c8ee0aee793f84410d0eec8c6d3f','a72d992e065183b7d01ae16b811233136533a709467144b9c8d1c5823eb2d8e0');
INSERT INTO checkpoint VALUES(9,1,2.8978715059999999859,X'000000000000f03f000000000000f03f000000000000f03f0000000000000000000000000000f03f000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000','0394f1eba2cf4ff00baee29a160f196c7b852f326c64d1f0df78185269b6c49e');
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
INSERT INTO trace VALUES(1099511627777,1099511627777,NULL,NULL,'measured','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'000000000000f03f000000000000f03f000000000000f03f000000000000f03fc3acaea4c88eae3cc3acaea4c88eae3cc3acaea4c88eae3cc3acaea4c88eae3c000000000000f03f000000000000f03f000000000000f03f000000000000f03ffaeecdd6f08e553ffae9e2caccde3e3fa3e6f5ffbcd6423f84e43e8f865736bf000000000000f03f000000000000f03f000000000000f03f000000000000f03f3c210371e2726c3f6854354e09f7543f67fbfb02f9f2553fdeb65a8bfc0151bf000000000000f03f000000000000f03f000000000000f03f000000000000f03f32a8864e9983793fa5db5bca1d1d623f7beb88a99264623fc7979c68941361bf000000000000f03f000000000000f03f000000000000f03f000000000000f03f1e370d8c4b6b833f73a89b8c01356a3f30a9382295906a3f90592387a8696cbf000000000000f03f000000000000f03f000000000000f03f000000000000f03fbdf7d007e4138b3f61e54c8d9d6d713fe8714170809e713f6f733797fc3b75bf000000000000f03f000000000000f03f000000000000f03f000000000000f03fb90b13dac8e7913f6ef4823cb218763f647062ab6046763fc2ba026637a07dbf000000000000f03f000000000000f03f000000000000f03f000000000000f03f23ff43847fdd963f14de63dc64367b3fb3ddb7ed8e5d7b3f21e80941b2b383bf000000000000f03f000000000000f03f000000000000f03f000000000000f03f75dba8e7e2789c3f7ff236440c71803fe0f453bcec80803f23ac88d1004d89bf000000000000f03f000000000000f03f000000000000f03f000000000000f03f1cb03a3c8162a13ff01477266099833f93990af9d4a5833fc17d65ecb0a08fbf000000000000f03f000000000000f03f000000000000f03f000000000000f03f7b0b7b9edde4a43f2f54d252911c873f36688bd13226873fc6abe942ab5993bf','09a18a335a2a5c405c83fed97a724ced0d9d83cf01adf748882f1a53d74c3aa1');
INSERT INTO trace VALUES(1099511627778,1099511627777,NULL,NULL,'commands','[{"name":"front_left_hip","unit":"rad"},{"name":"front_left_knee","unit":"rad"},{"name":"front_right_hip","unit":"rad"},{"name":"front_right_knee","unit":"rad"},{"name":"rear_left_hip","unit":"rad"},{"name":"rear_left_knee","unit":"rad"},{"name":"rear_right_hip","unit":"rad"},{"name":"rear_right_knee","unit":"rad"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'ffcdfb884ce1e5bf4ccbdaad8b3ed23f9d5d6bf0dc1ce1bf908d5e537b28babf3c520f672dd3d0bfc07cea968a6a8abf383b48216dfdd73f80af89fd6ce0bb3fc78c211de521e6bf846784fe4029d33fdacd826d2d77e1bf60d5842d193fbcbfaa837a46c352d1bfe079ebe4281a97bf1028ac51843bd83fd043e9b64035b93fd43773d88a23e6bfb4adf957462fd33f18e7cd337c79e1bff8f90c84dd4cbcbfbecf2e2e0b56d1bfc0b09c656e5b97bf58ed6b4f1d3dd83fe0a207fb9f23b93f1c22b3d4b322e6bf34f12073342cd33f70300cff4e78e1bff0173b76d845bcbf38e8ebeb5e54d1bfa0dae12c263a97bf6cc1b0c44c3cd83f50ed93129d2cb93faa75a4a59c21e6bf106ced2f3828d33fdf5079ebc776e1bf606229c2bb3cbcbf049d0afd3252d1bf805c1f8ef20e97bff463560f3e3bd83f20a897e04738b93f1bf9401c5b20e6bfc0727664a123d33f3832f48b0575e1bf30fece1b3e32bcbf125fa1e8b24fd1bf8047f3e535dd96bf04653562063ad83f9015bb59b645b93f7abf9631ec1ee6bffc51c21c651ed33ff59778a60373e1bf0024cea24626bcbfb41e50bdd84cd1bf60b255687aa496bf68e641d9a238d83f50eae33b0855b93f24cd750c4a1de6bf54c8641e6e18d33fa2666d0eba70e1bf782e1306a518bcbf441874f29849d1bfa02a0633db6396bfd82bbdd70d37d83fb084543f7b66b93f093e8e766e1be6bf98270de6a511d33fe7d63616206ee1bf9849b9152609bcbfe0afcf4ee745d1bf80b209d7651a96bf6014396b4135d83fb074b9bd507ab93f8627efc05319e6bfbc15e9ebf709d33f928e75cf2d6be1bf1889423d9bf7bbbf269d91b0b841d1bf6056fecd3dc795bf9c2cb0293833d83f808dd91dc490b93f8627efc05319e6bfbc15e9ebf709d33f928e75cf2d6be1bf1889423d9bf7bbbf269d91b0b841d1bf6056fecd3dc795bf9c2cb0293833d83f808dd91dc490b93f','655585b5cfd0a8b21823f19c622292c09e0a150ccc46a6cf98cc4b8a36c9ed4e');
INSERT INTO trace VALUES(1099511627779,1099511627777,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'022c4d54ef5d903fe686817c5b11bc3f1efe10ba7571ed3f01c4f695e21c903f49c54f883d00bc3f08720221c96ded3fe8878a36a51b8f3f79387c6554e0bb3fbdb544405f69ed3ff62f0005806b8d3f584653df66afbb3fa4b84ad0de65ed3f633b5ffb9e2c8b3f550e082fa76cbb3fd491bd81f963ed3fe7a7b56d175e883fb8e6b0b90918bb3f43966749c563ed3f24c982a38f01853fc95f51c54bb1ba3f4ca4054e0665ed3f50dfe1560418813f36016a8a4638ba3f29d313876367ed3f12a71139f342793fea77f0b4ebacb93faa678819866aed3f1bfb670e44746e3f6e36bdb63b0fb93f122a0f00286eed3f0ec530dd2a4a503f8724051b3c5fb83fab36f4971772ed3f','b0949646a80fea63f20c1b95f63087ad81914f71e78e10b1c94d43c03955dc6a');
INSERT INTO trace VALUES(1099511627780,1099511627778,NULL,NULL,'measured','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'000000000000f03f000000000000f03f000000000000f03f000000000000f03fc3acaea4c88eae3cc3acaea4c88eae3cc3acaea4c88eae3cc3acaea4c88eae3c000000000000f03f000000000000f03f000000000000f03f000000000000f03f051af637eea543bf4f46e7fbe27036bf51abddf6169e3f3f19e02eea1adc4e3f000000000000f03f000000000000f03f000000000000f03f000000000000f03fa86cf89bca7958bf178968ce990b37bfefc4dfe90dfa3e3f233cb705c5ae5f3f000000000000f03f000000000000f03f000000000000f03f000000000000f03f6e8f99d438bd68bf825a71b46d6c33bfd6b4cd842b1003bf47af1c581eef683f000000000000f03f000000000000f03f000000000000f03f000000000000f03f5f990ae9f77975bf09ffc44639a743bf1693e1acad2540bf716635149334723f000000000000f03f000000000000f03f000000000000f03f000000000000f03f6c91af08518880bfd82234a5a45351bf3ce92f339c0f50bf7b570e392651793f000000000000f03f000000000000f03f000000000000f03f000000000000f03f1afb3468df6e87bffebbda6f61d559bf1a07ccf8b4d758bf0e77648bbd07813f000000000000f03f000000000000f03f000000000000f03f000000000000f03faff3ad85e3588fbfd1a2aec4605e61bf7b55314807fc60bfdacedcf88c58863f000000000000f03f000000000000f03f000000000000f03f000000000000f03f7de82eec471c94bfc44dd45f94cc65bf8f2b35b9888165bffae36aff5db48c3f000000000000f03f000000000000f03f000000000000f03f000000000000f03f6089b55b260499bf98972e44330d6abfafbd3e2c82d469bfa806ff09b415923f000000000000f03f000000000000f03f000000000000f03f000000000000f03f0edac28534649ebf81c3be0de8066ebf02b69c2a22dc6dbf1efcc88a1563963f','cf1f239436013fee8a25eb7e39ff29e9604a40cd60bdbbda7d55bdd0489ce4db');
INSERT INTO trace VALUES(1099511627781,1099511627778,NULL,NULL,'commands','[{"name":"front_left_hip","unit":"rad"},{"name":"front_left_knee","unit":"rad"},{"name":"front_right_hip","unit":"rad"},{"name":"front_right_knee","unit":"rad"},{"name":"rear_left_hip","unit":"rad"},{"name":"rear_left_knee","unit":"rad"},{"name":"rear_right_hip","unit":"rad"},{"name":"rear_right_knee","unit":"rad"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'5478f484b7dfdf3f680cd15c0b28c83fe0e11dba19aaa13f545baa3ca3b2d23f9ca392f31fa7d6bf206ea7ca971fc6bf4e52f87cf620d9bf3432f7867e12d33fb04e0f5f54c8dd3f68ee0dfe8446cd3f00c0040a3453983f10bb9f093916d23f64a96fdec62fd6bf5cb2f3b5015dc6bfb2f61f3b0fa0d9bf04941350b62fd23f28147f3e6244de3f48dd39dfa21dcc3f406e38bbeed59a3f1094e001fc39d23f98e02de40f4bd6bfb0bf6f59004fc6bf86399e472683d9bf002eb53a9e63d23fb808d08e1029de3f78f57b815b5fcc3f007eecd5e4479a3fc0b8b1c91532d23fc0d8c1f70845d6bf64d352c61852c6bf70793ffc8a89d9bf547effce2758d23f9c7d3382de2fde3f50565690014fcc3f00c383e03e6b9a3fec102f250d34d23f783361058946d6bf645fd98d5351c6bf40db96b0f387d9bfe4d35d43025bd23fb478ce36392fde3fa84befe68e50cc3f8069deebe3679a3f6872455fdd33d23f84a027926446d6bf3889d5456651c6bf0c7443591a88d9bfb83106f0bc5ad23fdcf7b77f5030de3f00341489ef4dcc3fc0d4ca408f6d9a3f849b75172e34d23fb0949828a246d6bfe44711a54651c6bfca145307d987d9bf5073aa12325bd23f20c806fcf530de3fc856e1b0614ccc3f80d62945eb709a3f903b5aec5d34d23fd2df40a7c646d6bf242a26e73351c6bfcc664352b287d9bf90fea57b775bd23f4437418c8f31de3f70b4d37bf04acc3f0045635d09749a3fc89b864f8a34d23f56962c85e846d6bf4069ae822251c6bfdec295668e87d9bfbccd15e5b75bd23f2c2518ecf731de3f786cb986f549cc3f4016f9d527769a3f9c931f7ba834d23fa03b288aff46d6bf04254db01651c6bf56852afc7587d9bf7c46fface35bd23f2c2518ecf731de3f786cb986f549cc3f4016f9d527769a3f9c931f7ba834d23fa03b288aff46d6bf04254db01651c6bf56852afc7587d9bf7c46fface35bd23f','56ea1f132cb57c0bfe21d2b82de461944171256ae314cfa9833c71f966a74f42');
INSERT INTO trace VALUES(1099511627782,1099511627778,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'022c4d54ef5d903fe686817c5b11bc3f1efe10ba7571ed3f03a88049edc2903f9eab0f83471abc3ff9d6235b866ded3fc6f7657a0229913f89445e52ab34bc3f0ccb06994768ed3f8e8034692aaa913fbad034b60a64bc3f2015b5d81f63ed3f68be385cfd7d923fbee72a21aba1bc3f797ecaf6ae5eed3f5a263b2d3e9f933f651e6d5c49efbc3f9a02becc1f5bed3f04aa9d7bbf0b953f48179db8a94dbd3fe9849e755c58ed3fc467db0c8cc3963ff55c1eccf7bcbd3f34c002743456ed3fa608723868c6983fe5a41c956e3dbe3f83d8d55e7354ed3fe8de7be9db139b3f10f331f15acfbe3f51c4184ceb52ed3fa16b7f5766ab9d3fed5f2df01073bf3f692739cb7751ed3f','8be9edd331fa33db1d13e211486dd22a9bb5b8fde48c1e85489b459f3a1bd165');
INSERT INTO trace VALUES(1099511627783,1099511627779,NULL,NULL,'measured','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'000000000000f03f000000000000f03f000000000000f03f000000000000f03fc3acaea4c88eae3cc3acaea4c88eae3cc3acaea4c88eae3cc3acaea4c88eae3c000000000000f0bf000000000000f0bf000000000000f03f000000000000f03fcdde210e1cca58bf9bb34ef9c8cc5abf7bc64d543f9d503f2930182afcbb4d3f000000000000f0bf000000000000f0bf000000000000f03f000000000000f03f62daba88debe7dbf8dfeb6f7aa5a7dbf869b2732d9e05e3ffbeb964117d9603f000000000000f0bf000000000000f0bf000000000000f03f000000000000f03fddbfaefb729b91bf4ec004eb63f090bf0ed58a9edd27643ff1fce27348176a3f000000000000f0bf000000000000f0bf000000000000f03f000000000000f03fff7455bcbc02a0bf738ced530a6f9ebfd1f20e060c02663fa6086b565f54713f000000000000f03f000000000000f0bf000000000000f03f000000000000f03f93076cfaba51a9bf76921c8af2e3a7bf4b0a033a7a13653fe46052e0bc6b753f000000000000f0bf000000000000f03f000000000000f03f000000000000f03f2e8fad357dfcadbff9adc96c1d88afbfcd1d214d63a0633f1b4b4d01de66783f000000000000f0bf000000000000f03f000000000000f03f000000000000f03fbecdd0b8e73db2bf837585e259d1b1bfffcff2fc9fb7623f427dde7ebb217d3f000000000000f0bf000000000000f03f000000000000f03f000000000000f03f3bc7fbaed933b6bfa14785f35bd1b3bf0064f5ddc543683fede369ec1a01833f000000000000f03f000000000000f03f000000000000f03f000000000000f03f99736aabadd9babf22a6b51d58bfb5bfb445247ba47c723f0f36a3bcb0bb893f000000000000f03f000000000000f03f000000000000f03f000000000000f0bfe3d7985c0df4bbbf08a22848e537b6bf86dfa4596a022cbf04ba7e9609d4833f','23f97935862442ee43ceffe2e7bdc64875d03c73c629e9a47b536d55c0bba838');
INSERT INTO trace VALUES(1099511627784,1099511627779,NULL,NULL,'commands','[{"name":"front_left_hip","unit":"rad"},{"name":"front_left_knee","unit":"rad"},{"name":"front_right_hip","unit":"rad"},{"name":"front_right_knee","unit":"rad"},{"name":"rear_left_hip","unit":"rad"},{"name":"rear_left_knee","unit":"rad"},{"name":"rear_right_hip","unit":"rad"},{"name":"rear_right_knee","unit":"rad"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'68d65761381acc3f1c1b9e31d929d5bfa0a4f30ae7afc53f80cdff98516dc1bfa008c7d3a11acabf4048c624ea29c43f03a9da3dd24ce4bfeaf1ab9fbfdde13fce00cc5f3249e03fb284b65c2222e1bf442aed4dbed3d83fd4246fe0187bd4bf967535714d84d3bf3095eb7949ddb2bf78f3a0aa848bb3bfa4ffd7f9228bd13fb807d377a590dc3fa83d54dbff63dfbfb4fd406340a6d53ff8c0b051c8c1d1bff2a6a9fc79ffd1bfc0abda9eee6192bfc8d477dde2e3cdbf84ef6330e261d63fd0c27ebbd5ccdd3f762d81bde722e0bfccbd891eef9dd63fc6b5b3281995d2bf0e858b43cb74d2bfb030cb8937c5a1bf70d34ff80ff7c7bf545bf906fef4d43f040435fe3b64dd3fa232b1ea01fbdfbf50898230b64bd63f94437244db4ed2bfae1ead56c04dd2bf60f4c49be8d29dbf942f132b00f4c9bfe80a7b964b6fd53f9460e177ffa4d43f3c712a3a4bcbd9bff8f6f103404bcf3fc4f1545c1f66c9bf7cbd33c24570cebff0e9388b7101b53fa8d5f51475efdebf106b12d1ea58de3f68b087864cd8d53f567e892d4fa3dabfbcdd27f69f89d03f003297a637e3cabf305272de5940cfbf00dd3bd11650b13fb4f0d297acd6dcbf54a4b227ad41dd3f94dd87793b58d53ff228e9384249dabf14f54ff06c2ad03f1c2aa959fa43cabfc43f0cd45ce9cebf509a9324ecdbb23fb698e0c0d8b9ddbfa0e0f8a736b7dd3fd0728914897bd53f7ae3fcfb1362dabfac6fe55fa444d03f602f8234d06fcabfb4fdbc674d01cfbfa0a81624136fb23f4a1880e9b87bddbf1897e822fb96dd3fe0b609b33486cc3fb048eb63d14fd5bf380aeaa996fdc53fd874fbaf75adc1bfb033eef76c3dcabfc8321d9ab0ddc33f1cdf7658f32ae4bffe69b19289c9e13fe0b609b33486cc3fb048eb63d14fd5bf380aeaa996fdc53fd874fbaf75adc1bfb033eef76c3dcabfc8321d9ab0ddc33f1cdf7658f32ae4bffe69b19289c9e13f','15ac1e68cfcd3c0503607cb9e200753094a96b817a64ce72c24f36d8fac074a9');
INSERT INTO trace VALUES(1099511627785,1099511627779,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float64',X'00000000000000007b14ae47e17a843f',X'022c4d54ef5d903fe686817c5b11bc3f1efe10ba7571ed3f1f848c89e030913f8cc809535910bc3f4bf9f5bd386ded3f9f94537d0589923fbc973c833618bc3fd07f6e66a366ed3f26264b466a68943f021f7dfaf428bc3f2b3cbe499d5eed3fb7282fa7bbcf963f82e775b68e42bc3fa70eb6896855ed3fe1eebcfae2be993fd10c479c0065bc3fd9d1690beb4aed3f2eedd3f165cf9d3f9c89a74fb69fbc3fb723445d4b3fed3f841a0db7c95ca13f0a28d05fbfc8bc3fb13fc8d09833ed3f5edff536aa04a43ff256d9c3fbf0bc3fea24d0ef0128ed3fc1a9392154daa63fa6c94cf3d218bd3f4ae4294c9d1ced3f480b56f08425a83f0e51ff5f456ebd3fb4a51e2c1515ed3f','a3a0f21335b490797374ce9060eab13873915ed6c450492f3afe8fcded8c2697');
INSERT INTO trace VALUES(1099511627786,1099511627777,NULL,1099511627777,'predicted','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'0000803f0000803f0000803f0000803f457674254576742545767425457674250000803f0000803f0000803f0000803fff9cc13a89f0283af479423ad9abc3b60000803f0000803f0000803f0000803ffb327e3b996aed3a197bfa3a726d83b80000803f0000803f0000803f0000803f658fe63b88985c3b67555f3beb756db90000803f0000803f0000803f0000803f9d5c333c7197aa3bd6c1ab3b84500dba0000803f0000803f0000803f0000803f6c5b803ce40bf13bc00ef23b776086ba0000803f0000803f0000803f0000803fea30ae3c3535213ceb9e213c35e0ddba0000803f0000803f0000803f0000803f599be33ce0d44f3c8429503c8f5626bb0000803f0000803f0000803f0000803f5774103de770823cdc92823c5bc268bb0000803f0000803f0000803f0000803f4f28333d3664a03ca27fa03c82bd9abb0000803f0000803f0000803f0000803fb2ff593d34f0c13c6706c23cdff1c5bb','a6c10e638d11d94d722b040e5bf147cb9904a0a4bcafb22ae3e0e92ec3a315a1');
INSERT INTO trace VALUES(1099511627787,1099511627777,NULL,1099511627777,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'dc8683be0c94d7bd770e6c3f8bac83bee726d8bdf5f36b3fbafc83bea33bd9bd54d66b3fd77684bef0d6dabdebc16b3fb61785bee805ddbd92bb6b3f0edf85be87c9dfbdc8c36b3f37cc86bee624e3bddfd86b3fe9de87be3a1ae7bd65f86b3f4b1789be8faaebbdf31f6c3fce758abe11d6f0bd894d6c3f10fb8bbe759cf6bda87f6c3f','058590d52d38694718e8e626820688a012ec9c9adf7d2a8072307e3256af9b1b');
INSERT INTO trace VALUES(1099511627788,1099511627778,NULL,1099511627777,'predicted','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'0000803f0000803f0000803f0000803f457674254576742545767425457674250000803f0000803f0000803f0000803fe9341bba4b4737b96a7e343a7450a23a0000803f0000803f0000803f0000803f6bebafba29af95398662713a8e833e3b0000803f0000803f0000803f0000803f238a2cbb0f7d653a7a4b8a3ae73ba93b0000803f0000803f0000803f0000803f757e91bb4ff4a23ae13db83a450b023c0000803f0000803f0000803f0000803f50acdbbba5ffd23a3c68e83aa88a363c0000803f0000803f0000803f0000803f46051abce687033b55310d3b5fe0713c0000803f0000803f0000803f0000803fb7584dbcd763203be367283b463f9a3c0000803f0000803f0000803f0000803ff10984bc3ebf403b4500473ba594bf3c0000803f0000803f0000803f0000803f9045a5bc0317653b9cc6693b125ae93c0000803f0000803f0000803f0000803f7687cabcc0dd863b0696883b58f60b3d','157bb675032ae14ec0c8151374d5cd7298179b757fb723d16f76e3c49d0f2282');
INSERT INTO trace VALUES(1099511627789,1099511627778,NULL,1099511627777,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'dc8683be0c94d7bd770e6c3fe85483bea24cd7bda8ec6b3f902b83bed862d6bdc2c06b3f09eb82bee7d3d4bdc8976b3fd77e82be4bcfd2bde5776b3fedeb81be3b3dd0bd2e636b3fd33181be641dcdbdf6586b3f225080be9970c9bd19576b3fe38d7ebe5036c5bdf55a6b3f4f2d7cbed46cc0bd08626b3f8a7f79beb211bbbd406a6b3f','a1cbc06c8c160159a9de3a701c28904737eb57424625e388478d4ba22a95cc6b');
INSERT INTO trace VALUES(1099511627790,1099511627778,NULL,1099511627783,'predicted','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'0000803f0000803f0000803f0000803f457674254576742545767425457674250000803f0000803f0000803f0000803ffdfbeeb9cf40aeb9cffb0e3a55af943a0000803f0000803f0000803f0000803fc82c83ba295c56b9b2443d3a69162b3b0000803f0000803f0000803f0000803f96ab00bbdb592e399879073a64d1923b0000803f0000803f0000803f0000803f774468bb25356539b6c8e4391d24df3b0000803f0000803f0000803f0000803ffd70bcbb11d54b396be7ca393c271c3c0000803f0000803f0000803f0000803f107e0cbc98d132391692b03920ee4e3c0000803f0000803f0000803f0000803f95ac44bc4c0f1f39a9bd9639c021843c0000803f0000803f0000803f0000803fd84983bc895c0c3930bd7b395965a43c0000803f0000803f0000803f0000803f7c08a9bc6e50ea3810d849391a99c83c0000803f0000803f0000803f0000803fd689d3bc4dd2a8388b011439e007f13c','7c154b4c8e113403fb77a93e44098d11f8d25e59a75ae5e904e50208a685c3ad');
INSERT INTO trace VALUES(1099511627791,1099511627778,NULL,1099511627783,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'aae5dcbdf453483e01a6693f782edcbd477b483efc81693ff487dbbd5be2483e5f51693f71c6dabd889e493e7222693fdb6dd9bdee944a3e50fb683ff87dd7bdcbc74b3ec5de683fbaf5d4bdb5374d3ececc683f5bd3d1bd86e44e3e98c3683f8817cebd1acf503e7ec0683f8dc4c9bd0ff9523ec4c0683f61ddc4bd6164553e06c2683f','43478663b243314b9183fdd6d449af785d80d52df0c00f8fd61046171cdd7037');
INSERT INTO trace VALUES(1099511627792,1099511627779,NULL,1099511627783,'predicted','[{"name":"touch_front_left","unit":"1"},{"name":"touch_front_right","unit":"1"},{"name":"touch_rear_left","unit":"1"},{"name":"touch_rear_right","unit":"1"},{"name":"angle_front_left","unit":"rad"},{"name":"angle_front_right","unit":"rad"},{"name":"angle_rear_left","unit":"rad"},{"name":"angle_rear_right","unit":"rad"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'0000803f0000803f0000803f0000803f457674254576742545767425457674250000803f000080bf0000803f0000803f8dccb2ba751e16bb8fb7653a7e478f3a0000803f000080bf0000803f0000803fc89589bbeaa858bcefe5ec3a4816323b0000803f000080bf0000803f0000803f9fbd04bc875be0bc86954e3b255da23b0000803f000080bf0000803f0000803f26c655bc20872dbda9fb983b7a2efb3b0000803f000080bf0000803f0000803f886d9bbcf1f465bd8e21d03bffd5313c0000803f000080bf0000803f0000803f3a5fd3bcdb2b8dbdebfc053c566a6f3c0000803f000080bf0000803f0000803f11d008bd1e09a5bd4955273c22bd9c3c0000803f000080bf0000803f0000803f1a212bbdcff8babd50134c3cb493c83c0000803f000080bf0000803f0000803f0fc750bd7722cfbdfa29743c2491fb3c0000803f000080bf0000803f0000803fd69579bd12b4e1bd12f58f3cfbe61a3d','58236fa908dc773783f2ffbccce41457abfb74f9ecc41f9d7b2977e16d3bb103');
INSERT INTO trace VALUES(1099511627793,1099511627779,NULL,1099511627783,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',11,'float32',X'00000000000000007b14ae47e17a843f',X'aae5dcbdf453483e01a6693f606ddbbdcf5e483e6783693f06bfd8bd2f9a483e3d53693f15aad4bd22f2483eba24693f042bcfbd2d67493ec6ff683f2939c8bd5ff6493e08e7683fc0edbfbd14ad4a3ef0d8683f0669b6bdf49b4b3e6ed1683f61bbabbd50cb4c3ea2cb683f3fef9fbd7c404e3ef0c2683faa1393bd95fb4f3ec0b3683f','f8c0563bac483eb3c4cf2fb16060dfa6fb13c9126ddc5c8359f61569919ca958');
INSERT INTO trace VALUES(2199023255553,2199023255553,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000800000000000000080182d4454fb2169bf182d4454fb2169bf182d4454fb2179bfd221337f7cd982bfd221337f7cd982bf182d4454fb2189bf5e3855297a6a8fbfd221337f7cd992bf75a7bbe9bbfd95bf182d4454fb2199bf5e3855297a6a9fbf00dfeec95c47a1bfd221337f7cd9a2bf','253c198b7b5ff98f029e78934a5e84a5c3046d16d689ea8a1b1c7b5cf9e9d36c');
INSERT INTO trace VALUES(2199023255554,2199023255553,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'5d5260a2be30b5bffd00276a6409a7bf29514ebac9ddaabf693665eaa36bafbffb5d59e607d4b0bf906e62e1d707b1bfbe50d4c5d5f3b0bf1b3e3a4a31e4b0bfa1d9d63c84dcb0bf85c1cbc3f8dfb0bf3e5d807fade7b0bfdea0a1a5c8efb0bfbdbbbea843f7b0bff8bf022429fcb0bfd36be3ccb508b1bfd36be3ccb508b1bf','5d3eb28c5eda9fa66205f9e3ae3f1ba3ec9ffa15c40284401a0d8e52707ed836');
INSERT INTO trace VALUES(2199023255555,2199023255553,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf3fd53ffe1edd213f00000000000000003dfe9e999999c9bf445bf1e89201343f0000000000000000f080688e9899c9bf486de4f9f023413f00000000000000001399da959599c9bf66857329597d4a3f0000000000000000ddd420fb8e99c9bff9eebd1cb41d533f000000000000000053f497368299c9bff2d8383be61a5a3f000000000000000048d81e4e6c99c9bf57bd573a9e09613f0000000000000000508fb0344a99c9bfe66026e42971653f00000000000000002e02dd091999c9bf64f2af10c3316a3f000000000000000084587752d698c9bf84cc7bc674396f3f00000000000000006b38ae218098c9bf4c6b1e10273b723f0000000000000000bc787b401598c9bf48ea9fa825eb743f0000000000000000f062e84c9597c9bff325ebbcbda3773f0000000000000000c4f7afcc0097c9bf5fa65fad085c7a3f000000000000000083190e375996c9bff04c5576ba0b7d3f000000000000000032bbf6d3a095c9bf','af84f60e2c8dd83d7c565f3150686ce9d7fa2223056dfff1a8731cc2a96cea8a');
INSERT INTO trace VALUES(2199023255556,2199023255554,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000000000000000000080182d4454fb2169bf182d4454fb2169bf182d4454fb2169bf182d4454fb2179bfd221337f7cd982bfd221337f7cd982bf182d4454fb2189bf5e3855297a6a8fbfd221337f7cd992bf75a7bbe9bbfd95bf182d4454fb2199bfbbb2ccbe3a469cbf00dfeec95c47a1bfd221337f7cd9a2bf','8ca69c2b3e4b54dd08b2afb00b1139ce87c113ebb416693fa3277a90a9f0db98');
INSERT INTO trace VALUES(2199023255557,2199023255554,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'5d5260a2be30b5bffd00276a6409a7bf2d8d49784adbaabf1cf4f0abb176afbfc5faf534f6d6b0bf188d0e3e9a08b1bf69e0db19adf3b0bf6be43871f4e3b0bf5d19ccc668dcb0bf2b2c8dd0f4dfb0bf1620d193b0e7b0bfb3a9e834cbefb0bf4be02b8a44f7b0bf1d8440474efeb0bfa5802a5d1003b1bfa5802a5d1003b1bf','f79d1f8c25d2ae6cb03ac57f929fea76f4d6531848b860fc249d53b9c20578e1');
INSERT INTO trace VALUES(2199023255558,2199023255554,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf3fd53ffe1edd213f00000000000000003dfe9e999999c9bf445bf1e89201343f0000000000000000f080688e9899c9bfbbb839528723413f0000000000000000d4e103969599c9bf24aca5385e7e4a3f00000000000000001d1581fa8e99c9bf1414bd8f621f533f00000000000000005d98fd328299c9bfa469c1cad11d5a3f0000000000000000202bb2446c99c9bf64612e74a50b613f000000000000000015507e224a99c9bfe28e6e5ab273653f000000000000000016e405ec1899c9bfb31a162fbe346a3f0000000000000000b58d4526d698c9bf85af38ebd43c6f3f000000000000000034d4b8e47f98c9bf7c2d16b2023d723f00000000000000001987d5f01498c9bf4e80e68b25ed743f000000000000000092774be99497c9bf60470247daa5773f0000000000000000909b99540097c9bfdda493c9505e7a3f0000000000000000897292a55896c9bfb56e7da9e90d7d3f0000000000000000f2558e38a095c9bf','a361088d164fb3edf81051374753132840fbbea5ccfd287678787cf1e6c40284');
INSERT INTO trace VALUES(2199023255559,2199023255555,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000080182d4454fb21693fd221337f7cd9823fd221337f7cd9923fbbb2ccbe3a469c3f75a7bbe9bbfda53f8cf510745ad8ad3f3b43d5598ca2b33faf0ba279eb58b83f24d46e994a0fbd3f00dfeec95c47c13fef5326471407c43fdec85dc4cbc6c63fcc3d95418386c93fbbb2ccbe3a46cc3faa27043cf205cf3f','abc1b04b9af4b3a0706c5aea00e2feebc73c658128b6fc156386e31226665216');
INSERT INTO trace VALUES(2199023255560,2199023255555,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'72982c9a26f0d03f75279de1228cd13fb13c7b911db3d03ff1c3fbff37f1d03fb140eaecb7f2d03fa45fb95291d8d03f8d998de3f8d2d03fa044ce9950c7d03fc093516df0b8d03f6a330518e4acd03f6fd576f01e9ed03f416b4ae3858ed03f96be57d2bc7fd03fec6f3a3e9870d03f86f9d52d5261d03f86f9d52d5261d03f','df025bb534197db72202ddfa1ab70c058e2cfbee50a4c2ac49d95c999efe1cae');
INSERT INTO trace VALUES(2199023255561,2199023255555,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf8865b92c74db43bf00000000000000003dfe9e999999c9bf8fc1d272d1bf5dbf00000000000000000efaa14f7999c9bfda1d82121e2b6dbf00000000000000006d21560ded98c9bfa89110b356cd77bf00000000000000001a956c408a97c9bf39a40ca4247481bf000000000000000084492200d194c9bff55ddc07dbd687bf000000000000000015756abe3990c9bf1de96a7813f28ebf00000000000000007a6fa63d4089c9bf125fce626e5393bf0000000000000000fc3cec526f7fc9bfeb1c3dd46b6a97bf0000000000000000cefdcaf16a72c9bf3972550096ad9bbf000000000000000029b76fabf761c9bf7df823112b06a0bf0000000000000000072b1fe6004ec9bfeaf79578243ba2bf00000000000000003eedf9f79b36c9bf40c9cba5cb6da4bf000000000000000073920f6e081cc9bf5c8b53c39596a6bf0000000000000000ec97e050aefec8bf2c4dbaf376aea8bf0000000000000000719534fb19dfc8bf','9dade38db102fc82dfbe88b9c588bcd820e60ab01b6ddf8a4d8490a298d42ea5');
INSERT INTO trace VALUES(2199023255562,2199023255553,NULL,2199023255554,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000ed9937ba83c8ceba944a31bbd79188bbd009c4bbc40005bca4712cbca68a57bcc9c582bca5de9abc11b7b3bccaf8ccbcf550e6bc0871ffbcd0070cbd','423ba411743c13257f6acef87f6ffeb273d5712a1c7b1905f030e2e7851b4f63');
INSERT INTO trace VALUES(2199023255563,2199023255553,NULL,2199023255554,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe8be1123900000000cdcc4cbe356da53900000000c4cc4cbe3ed50d3a00000000aacc4cbeda825a3a0000000072cc4cbe7ed49c3a0000000008cc4cbe9acdd43a0000000054cb4cbe06f4093b0000000040ca4cbee96d2c3b00000000bbc84cbe963a513b00000000b3c64cbe6ec7773b000000001fc44cbe17c38f3b00000000fac04cbe5af6a33b0000000046bd4cbe2a3bb83b000000000ab94cbeac52cc3b0000000054b44cbe2702e03b0000000036af4cbe','c566a7a0ea8c6854e469c42300f3d34113aa81be943d8f7885f70c324bd4ad81');
INSERT INTO trace VALUES(2199023255564,2199023255554,NULL,2199023255554,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000ed9937ba83c8ceba944a31bbd79188bbd009c4bbc40005bca4712cbca68a57bcc9c582bca5de9abc11b7b3bccaf8ccbcf550e6bc0871ffbcd0070cbd','423ba411743c13257f6acef87f6ffeb273d5712a1c7b1905f030e2e7851b4f63');
INSERT INTO trace VALUES(2199023255565,2199023255554,NULL,2199023255554,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe8be1123900000000cdcc4cbe356da53900000000c4cc4cbe3ed50d3a00000000aacc4cbeda825a3a0000000072cc4cbe7ed49c3a0000000008cc4cbe9acdd43a0000000054cb4cbe06f4093b0000000040ca4cbee96d2c3b00000000bbc84cbe963a513b00000000b3c64cbe6ec7773b000000001fc44cbe17c38f3b00000000fac04cbe5af6a33b0000000046bd4cbe2a3bb83b000000000ab94cbeac52cc3b0000000054b44cbe2702e03b0000000036af4cbe','c566a7a0ea8c6854e469c42300f3d34113aa81be943d8f7885f70c324bd4ad81');
INSERT INTO trace VALUES(2199023255566,2199023255554,NULL,2199023255563,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'000000002b861dba249aa8ba471c0cbbaff054bbd74698bbe9becebbc94d06bc524928bcacb84cbc370a73bc07588dbcb88fa1bc0de9b5bcf723cabc2f04debc','181513289412b6bb0ba007ae5b70915e459ec1c0e35997d33452f325cd8905c8');
INSERT INTO trace VALUES(2199023255567,2199023255554,NULL,2199023255563,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbedf09fc3800000000cdcc4cbeb6e1863900000000c7cc4cbe3a2de03900000000b7cc4cbe1a5a2a3a0000000095cc4cbe65a4733a0000000055cc4cbe5565a53a00000000e9cb4cbe65e2d63a0000000041cb4cbe94a0063b0000000052ca4cbe0bc6233b0000000011c94cbe076d423b0000000076c74cbef423623b000000007ec54cbee13d813b0000000029c34cbe7d84913b000000007bc04cbe89b2a13b000000007cbd4cbecd97b13b0000000038ba4cbe','f06db3da2021f2c5b5144c4f1b598a01250e2aca239bec30abfee85e7721e557');
INSERT INTO trace VALUES(2199023255568,2199023255555,NULL,2199023255563,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'000000002fe83d3b4d4d0d3ce98f893c0dfbde3cca6f223d88795c3db23f8e3d89aeb03d52f6d43db086fa3d5e69103e6ea9233e32c3363e657a493e68975b3e','e3136272f8125fbe0d59b8f5cf6dd7f1885ec69adc8c4f4372e2492e02dc273c');
INSERT INTO trace VALUES(2199023255569,2199023255555,NULL,2199023255563,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbef9ec17ba00000000cdcc4cbe3b15e2ba00000000e3cb4cbe7f185cbb00000000fcc74cbe7c5fb2bb000000004abe4cbe8eed01bc000000008fab4cbef45130bc00000000838c4cbecf7563bc00000000175e4cbec9348dbc00000000c61d4cbebb1daabc00000000c1c94bbec1fec7bc000000001a614bbed663e6bc00000000dae34abedf6e02bd0000000000534abeda8111bd000000007ab049be543a20bd000000000cff48be326c2ebd000000002f4248be','85bb8148a4138883d0e99bca60c0c1dc52c806fc193ce6f2732fbf0596e7ccfa');
INSERT INTO trace VALUES(3298534883329,3298534883329,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fa8305cb673d9823fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f3435fe473946ac3fd221337f7cd9b23f182d4454fb21b93f5e3855297a6abf3fd562aa3d043ec33f806a2125532bc73fb530de412b7dcb3f6179cce701cfcf3f4d4080e1b042d23fa46477349c6bd43ffa886e878794d63f15eccc9573bdd83f68cf4c2ad781da3fbbb2ccbe3a46dc3f89b499b5d273dd3f12d7c311266fde3fd956a28baed3de3f5bf7dd6af205df3f9377fff069a1de3f0b55d59416a6dd3fbbb2ccbe3a46dc3f68cf4c2ad781da3fcccbb23ca726d83ff0c5084cf066d53fcc9f44026d10d23fc234bb3b4a0fcd3f6f25cd6cac34c53f182d4454fb21b93f503db83b776a9f3fee20ad669e6ba4bf3435fe473946bcbf806a2125532bc7bf6179cce701cfcfbf22c43b555839d4bf4a2b775d63f4d7bf36d119216fafdbbfd956a28baed3debf5a2e26beb2c9e0bf2830f3b44af7e1bfd221337f7cd9e2bffa72376a6a89e3bfa02300761407e4bf22c43b555839e4bf22c43b555839e4bf','4dc4de9d3675c04cae360a1e78f8918d71f463db13dc449d11b1bace9d0bb135');
INSERT INTO trace VALUES(3298534883330,3298534883329,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(3298534883331,3298534883330,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000df40d09def21693f89292cf2826a8f3f503db83b776a9f3f2631214e1ab4aa3fd9a321fc8ba2b33f2631214e1ab4ba3fc85ecd43e5abc13f75a7bbe9bbfdc53f23f0a98f924fca3f58b666ac6aa1ce3f827f2aa9a079d13f5703e61c4870d33f28462ad26702d53ffa886e878794d63fc88a3b7e1fc2d73f15eccc9573bdd83f9acd7f333f54d93f1b6ebb128386d93f1b6ebb128386d93f182d4454fb21d93f934b91b62f8bd83f4a2b775d63f4d73fc2084d0110f9d63f7266442b3499d53f5703e61c4870d33ffa5c004d4d7ed03f1faf32d10aebc93fc85ecd43e5abc13fc41d56855d47b13fa8305cb673d982bffc248a60bdfdb5bf6ae455ae24d0c4bf5375efede23ccebf5703e61c4870d3bf47eaff9edb8fd7bf6b10c4e85ee6dabf0b55d59416a6ddbf6179cce701cfdfbfd98deade6e97e0bffd9d770bd5e2e0bffd9d770bd5e2e0bf98bd4cef4c7ee0bfe0d89008be9cdfbf0b55d59416a6ddbf6f513ba7e64adbbf12ab55d7eb58d8bf28462ad26702d5bf7bfd3b2c91b0d0bf7c29aa66cbc6c6bfe02510799b6bb4bf182d4454fb21993fc85ecd43e5abc13fb57d5db2084cd03f47eaff9edb8fd73f9377fff069a1de3f5081f79f38a7e23fb236e21a56b2e53faf0ba279eb58e83fea6f88091bb4ea3f','dbeaec820e7395155e17a615b3f207c5f182be74a2c0f1c659b1d5c4ef58e26c');
INSERT INTO trace VALUES(3298534883332,3298534883330,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(3298534883333,3298534883331,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',31,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fdf40d09def21893fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f4239db4158d8ad3fd9a321fc8ba2b33f1faf32d10aebb93f32dd21d3c419c03fd9a321fc8ba2c33f83ab98e3da8fc73fb530de412b7dcb3f6179cce701cfcf3fcc9f44026d10d23f22c43b555839d43f78e832a84362d63f12ab55d7eb58d83fe62e114b934fda3f3a1291dff613dc3f','f6d97370b1a91e9b8be4be92322cc4dd59ee3408a3267f809f0ba669f3e105e6');
INSERT INTO trace VALUES(3298534883334,3298534883331,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'0000000000000000000000000000000077346037ab90a638f32d97393a37483abad8dc3ab7d5573bed5fc03baed91f3cce9a7a3c033dbb3c2f33063d0f93393db485783d8bada13d69e8cc3d577efd3dbc67193ec60b363e2a3e543e938a733e32b9893ef8bb993e638fa93e29f4b83e3aafc73e7689d53eee50e23e','d67fe685148f8d12ff6a7a250b3edb562df299aa27fbaaf64a3dffb94b717e66');
INSERT INTO trace VALUES(4398046511105,3298534883329,4398046511105,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(4398046511106,3298534883330,4398046511105,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(5497558138881,3298534883329,5497558138881,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000112cd8268a1b07286526bd28da6a512984a9ca29b06ad3380b4e183a0f86e43ade53813b367df73bf60f543c34c8a73c0fdcf93c5d49313d65d1713d01819f3d057bcc3d3ea6ff3d16481c3e39413b3e98415c3ebdab7e3eade3903e0262a23e325eb33e925ec33ee4e5d13e9176de3ee793e83e39caef3eb7adf33e08e2f33ea69bf03eb6a0e93e47ccde3e1813d03ec780bd3e633da73e42898d3e467e613e1ca3223e7f1cbf3df05bcb3cdc093abdecdcedbd098a3ebeda0882befb2ba3be2f27c2be6d84debe77dff7be61f506bf463510bf1f9c17bfff1f1dbfd6bf20bf068222bf068222bf','99549e70fc123ae35cd55228e183a20e5cb58e88d99a3987f29e4bfd68b0cbc3');
INSERT INTO trace VALUES(5497558138882,3298534883330,5497558138881,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'12803cb912803cb912803cb98b63753bbf23613cefebf03cb08f4d3d915a9a3d9445d53d5bd60a3e79ca2c3e707a4f3e83e2713edd83893e80ff983eaff9a63e9215b33e0606bd3e1d8fc43e2087c93e1cd7cb3e1cd7cb3e97b6c93ee38dc53e1f83bf3e0fc9b73ea7b5ac3e63089b3e345f833e70064d3e47c60a3ed72e843d97312cbc4ae3b2bdd69d27be7c0773be8ecb9cbe6fb6bcbec275d8bec05fefbeb47800bfa46706bfb96209bf926309bfa7b706bfea7b01bfe7bbf3be5e36e0be33ffc8be3b20aebe9cd18abe912f3fbe957db7bd63b48b3ca8fb043ef6477b3e1a74b83e8251f13e4865133fc0d02b3f0e68413f98c3533f','a966291dbbd6fc5b6446388d8ed53a9498684fbbbf303241ad8606cced80321b');
INSERT INTO trace VALUES(6597069766657,3298534883329,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000112cd8268a1b07286526bd28da6a512984a9ca29b06ad3380b4e183a0f86e43ade53813b367df73bf60f543c34c8a73c0fdcf93c5d49313d65d1713d01819f3d057bcc3d3ea6ff3d16481c3e39413b3e98415c3ebdab7e3eade3903e0262a23e325eb33e925ec33ee4e5d13e9176de3ee793e83e39caef3eb7adf33e08e2f33ea69bf03eb6a0e93e47ccde3e1813d03ec780bd3e633da73e42898d3e467e613e1ca3223e7f1cbf3df05bcb3cdc093abdecdcedbd098a3ebeda0882befb2ba3be2f27c2be6d84debe77dff7be61f506bf463510bf1f9c17bfff1f1dbfd6bf20bf068222bf068222bf','99549e70fc123ae35cd55228e183a20e5cb58e88d99a3987f29e4bfd68b0cbc3');
INSERT INTO trace VALUES(6597069766658,3298534883330,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'12803cb912803cb912803cb98b63753bbf23613cefebf03cb08f4d3d915a9a3d9445d53d5bd60a3e79ca2c3e707a4f3e83e2713edd83893e80ff983eaff9a63e9215b33e0606bd3e1d8fc43e2087c93e1cd7cb3e1cd7cb3e97b6c93ee38dc53e1f83bf3e0fc9b73ea7b5ac3e63089b3e345f833e70064d3e47c60a3ed72e843d97312cbc4ae3b2bdd69d27be7c0773be8ecb9cbe6fb6bcbec275d8bec05fefbeb47800bfa46706bfb96209bf926309bfa7b706bfea7b01bfe7bbf3be5e36e0be33ffc8be3b20aebe9cd18abe912f3fbe957db7bd63b48b3ca8fb043ef6477b3e1a74b83e8251f13e4865133fc0d02b3f0e68413f98c3533f','a966291dbbd6fc5b6446388d8ed53a9498684fbbbf303241ad8606cced80321b');
INSERT INTO trace VALUES(6597069766659,3298534883331,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000112cd8268a1b07283a2cd828f3f279295892f6298ece9039f1df983a05c2493b9ff3d23b2faf3f3c37f69d3cc43cf23ce47e2f3d2ac8723d8984a13d1dcdcf3d63db013e44461e3ea2bc3c3eaec75c3e5be17d3e07c08f3eba8ba03ee30ab13e9cf7c03e1c0fd03e6313de3e','027037dfddf650a9fc3f98bde24b98042a7f10c103873eb797eff1750b061939');
INSERT INTO trace VALUES(8796093022209,3298534883329,8796093022209,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(8796093022210,3298534883330,8796093022209,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(9895604649985,9895604649985,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000000000000000000000000000000000000000000000000000000000000000000000182d4454fb21693f182d4454fb21793f182d4454fb21793fd221337f7cd9823f5e3855297a6a8f3fd221337f7cd9923f75a7bbe9bbfd953fbbb2ccbe3a469c3f00dfeec95c47a13fa46477349c6ba43f75a7bbe9bbfda53f','296b7669b63a0cb92cd26e6e849fe873ff796befaa1da7810dfb6d8ee90fd7e0');
INSERT INTO trace VALUES(9895604649986,9895604649985,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'23c55ac6f126a2bfb3c459a2e0d49c3fedeaf338ac3ab03f7dbcffa7a640b53fdd84e8fde55cb63f93bd511d8e4eb63fb0b23ae7380bb63f69917410bccfb53f0df34d73eddfb53f001b2f4dcc40b63f09232ea81694b63f90e14053cddcb63f3392533a0348b73f3998a1f6fdbfb73fb015c2dc6d3cb83fb015c2dc6d3cb83f','793c2918137fb8d83c7f83dd955aa7e773b5b7203e96f9cde5be21ddc52ac327');
INSERT INTO trace VALUES(9895604649987,9895604649985,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf9d029f6d2a23de3e0000000000000000baa452999999c9bf2a2c06ce4371e03e0000000000000000a41d45999999c9bfea9296583cfc02bf0000000000000000e9648f929999c9bf8be05128732229bf0000000000000000fbdc2dd49899c9bf28245a42e4c03fbf0000000000000000445a3ead9499c9bf58197cc0c0df4dbf0000000000000000e47a492b8899c9bfd2b5416641f357bf0000000000000000217230c96c99c9bfc7b28976bd6061bf00000000000000000308a2393b99c9bf19c5ca9d4d9267bf0000000000000000760e10f6eb98c9bf12b0f93f26786ebf0000000000000000cc01c1747798c9bf45f443c5a3fe72bf0000000000000000e27fae8ad697c9bfdd3a7f5b250577bf00000000000000003b1e17100397c9bf9e0b8afde4437bbf00000000000000002a5f4c1af895c9bf380df283d2af7fbf00000000000000003c482810b294c9bf658f15c6ff1e82bf00000000000000004ef11eed2e93c9bf','98d22b2a54837c10db3f4208c91e0eb31c0d12c0d6f04829d595e2f55fbee3a0');
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
       predicted_fitness AS predicted, measured_fitness AS measured, measured_fitness - predicted_fitness AS gap,
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
PRAGMA user_version = 2;
