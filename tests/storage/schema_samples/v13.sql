-- Schema version 13, written by the program of commit 7a97ef6b: what sqlite3's .dump prints, and the header's numbers.
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE schema_text (
  name TEXT NOT NULL PRIMARY KEY,
  sha256 TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO schema_text VALUES('log','lacuna-log 82988eaae6b4c5463d5c71c60e0cbd38 79fee542ad4b00e6fd97f1c4c814fc34');
INSERT INTO schema_text VALUES('views','f5d78a1fa1d13335415608f4383202b0bd20fba2ae7373a465c547712a5d8217');
CREATE TABLE experiment (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO experiment VALUES(1099511627777,'evolve');
INSERT INTO experiment VALUES(2199023255553,'outside');
INSERT INTO experiment VALUES(3298534883329,'rig');
CREATE TABLE experiment_text (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  file TEXT NOT NULL,
  text TEXT NOT NULL,
  overrides TEXT NOT NULL CHECK (json_valid(overrides)), decided TEXT NOT NULL DEFAULT '["engine.engine=\"ode\"","engine.substeps=1"]'
  CHECK (json_valid(decided)),
  UNIQUE (experiment, digest)
) STRICT;
INSERT INTO experiment_text VALUES(1099511627777,1099511627777,'4708b1926ce537a41b25e3daad0bc63d59f284d3ca93763394f0bff9e16c3bb8','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nencoding = "parameters_and_effects"\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] }, optional = true }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\nrestarts = 2\nensemble = 3\nchallenge = 1.0\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]','["engine.engine=\"articulated\"","engine.substeps=3"]');
INSERT INTO experiment_text VALUES(2199023255553,2199023255553,'eb11fa06efa51180018328eab3a9855cc1337a3ebe8721afa4af5b1ce009e7de','outside.toml',replace('# The pendulum as a program of its own, which refuses its second test.\n\n[experiment]\nname = "outside"\nseed = 1\npasses = 1\n\n[target]\nkind = "process"\ncommand = ["python3", "pendulum.py"]\nstart_limit = "10 s"\ntrial_limit = "20 s"\nrepeats = 1\npause = 0.0\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = []\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 1 }\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 1 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]','["engine.engine=\"articulated\"","engine.substeps=3"]');
INSERT INTO experiment_text VALUES(3298534883329,3298534883329,'4684425d873158e579f2630a162afb6e01d8f80c2c69400ed4ff8622640c3772','rig.toml',replace('# A servo pendulum, three short recordings of it; in one the arm was weighed, in one the hinge had another lubricant.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nhold = "zero"\n\n[[target.recording]]\nfile = "data/sine.csv"\nset = { "body.arm.mass" = "0.55 kg" }\n\n[[target.recording]]\nfile = "data/steps.csv"\nown = ["joint.hinge.damping"]\n\n[[target.recording]]\nfile = "data/chirp.csv"\nrole = "holdout"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = []\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]','["engine.engine=\"articulated\"","engine.substeps=4"]');
INSERT INTO experiment_text VALUES(6597069766657,3298534883329,'22a9ff783d4426713fae081ce1c09ca05a057e02aeede94df269416a64a15fed','rig.toml',replace('# A servo pendulum, three short recordings of it; in one the arm was weighed, in one the hinge had another lubricant.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nhold = "zero"\n\n[[target.recording]]\nfile = "data/sine.csv"\nset = { "body.arm.mass" = "0.55 kg" }\n\n[[target.recording]]\nfile = "data/steps.csv"\nown = ["joint.hinge.damping"]\n\n[[target.recording]]\nfile = "data/chirp.csv"\nrole = "holdout"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = [\n  { id = "coulomb_friction", effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.02256 } },\n]\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]','["engine.engine=\"articulated\"","engine.substeps=5"]');
INSERT INTO experiment_text VALUES(9895604649985,1099511627777,'783d5cc49281482da85d4ee9600d99efacb2b16a1664b482d7cb31f00a2d6492','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nencoding = "parameters_and_effects"\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] }, optional = true }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\nrestarts = 2\nensemble = 3\nchallenge = 1.0\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'["engine.substeps=20000","estimation.parameters.generations=20"]','["engine.engine=\"articulated\""]');
INSERT INTO experiment_text VALUES(10995116277761,1099511627777,'ca1d743e37e120f357218bbdea4c725a6811c256bf6fd0e8c59851c2e34a4c1e','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nencoding = "parameters_and_effects"\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] }, optional = true }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\nrestarts = 2\nensemble = 3\nchallenge = 1.0\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]','["engine.engine=\"articulated\""]');
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
INSERT INTO run VALUES(1,'7298c8dd33ff8b3aa0228a49ba531ce9',1099511627777,'lacuna run evolve.toml --db sample.db --threads 1',1,1,'2026-11-28T12:00:32Z','2026-11-28T12:00:32Z','done');
INSERT INTO run VALUES(2,'c76ff8131a1734340c4b432fb6ef6d4b',2199023255553,'lacuna run outside.toml --db sample.db --threads 1',1,1,'2026-11-28T12:00:32Z','2026-11-28T12:00:32Z','done');
INSERT INTO run VALUES(3,'d081a64ddfdbf9f905d2970c447d48f0',3298534883329,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:00:32Z','2026-11-28T12:00:32Z','done');
INSERT INTO run VALUES(4,'e9b7ab337e8162a44ad49ecc2888a910',3298534883329,'lacuna diagnose rig.toml --db sample.db --threads 1 --among coulomb_friction joint_offset_torque',1,1,'2026-11-28T12:00:32Z','2026-11-28T12:00:33Z','done');
INSERT INTO run VALUES(5,'36651d1c22d1c2599896d76084324c76',3298534883329,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:00:33Z','2026-11-28T12:00:33Z','done');
INSERT INTO run VALUES(6,'d83975db8a5cb8fafca5706403f515e6',6597069766657,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:00:33Z','2026-11-28T12:00:34Z','done');
INSERT INTO run VALUES(7,'b72720c0d0f9338f50f8f949c2f04d70',6597069766657,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:00:34Z','2026-11-28T12:00:34Z','done');
INSERT INTO run VALUES(8,'42b189ce1e777187b3839749fc4acdad',3298534883329,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:00:34Z','2026-11-28T12:00:34Z','done');
INSERT INTO run VALUES(9,'4aa58ab88e3f35b0bb93d03367ed2b2d',9895604649985,'lacuna run evolve.toml --db sample.db --threads 1 --seed 2 --set engine.substeps=20000 --set estimation.parameters.generations=20',2,1,'2026-11-28T12:00:34Z','2026-11-28T12:00:35Z','interrupted');
INSERT INTO run VALUES(10,'1f5fc1c6a53b80b2929185ff041abe19',10995116277761,'lacuna trial evolve.toml --db sample.db --threads 1 --test ''triangle motor 0.3 N*m 4 Hz 0.3 s''',1,1,'2026-11-28T12:00:35Z','2026-11-28T12:00:35Z','done');
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
INSERT INTO provenance VALUES(1,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(2,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(3,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(4,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(5,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(6,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(7,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(8,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(9,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(10,'0.1.0','7a97ef6bdadc69be886b9bdc90357718f27ce179','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
CREATE TABLE plugin_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  build_id TEXT NOT NULL,
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/command_series.so','9e554847fce75f8be375e207f22f1724f73f3ef3df6972b12d930a4565ccb76f','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','ec882b64a0f6e169510c27a6d129f5bcec7d5c349110dde2916983dba63a294d','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','961cf98d51dd7a586d83d37ac82a3ad81d3ed4594261e90f918f90e45812255c','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','4d6c1f392d8025c38d8d5585411d634d612c49d076156573ebaeb4066ef905b0','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','68d2c8a60451d93607efb0a67f3a8eb88a5967bec507015a3479b897ee43babc','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameters_and_effects.so','f67535e3579b01a3ff2ecffb94388724f61bb1b243a3440626599fb037463af3','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/simulated.so','7aca6faa006a42c34e3a2b58666704d1a9467f5cb95801f1dbff02d501383900','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/truncation.so','fd8efa09b02cc9a12d12ee3d5d98d12de7f17dbeab63bc527d5f23feeff9be9f','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','fb9a8bb7526fe837c53f814cb071bcd1f6b8dd2b9421f33f41167d96c63519d9','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/command_series.so','9e554847fce75f8be375e207f22f1724f73f3ef3df6972b12d930a4565ccb76f','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','ec882b64a0f6e169510c27a6d129f5bcec7d5c349110dde2916983dba63a294d','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','961cf98d51dd7a586d83d37ac82a3ad81d3ed4594261e90f918f90e45812255c','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','4d6c1f392d8025c38d8d5585411d634d612c49d076156573ebaeb4066ef905b0','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/parameters.so','3c103395ea5fe1cc7a9bdaf20c69c44bca528e83f6d390567b62fd293870a823','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/process.so','d23b02002ed2031edb59b70d7ebccb433d549fb7e17ba64fa4d4a7015e88d15a','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/truncation.so','fd8efa09b02cc9a12d12ee3d5d98d12de7f17dbeab63bc527d5f23feeff9be9f','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','fb9a8bb7526fe837c53f814cb071bcd1f6b8dd2b9421f33f41167d96c63519d9','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/recorded.so','7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/recorded.so','7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/recorded.so','7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/recorded.so','7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/recorded.so','7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/recorded.so','7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/command_series.so','9e554847fce75f8be375e207f22f1724f73f3ef3df6972b12d930a4565ccb76f','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','ec882b64a0f6e169510c27a6d129f5bcec7d5c349110dde2916983dba63a294d','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','961cf98d51dd7a586d83d37ac82a3ad81d3ed4594261e90f918f90e45812255c','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','4d6c1f392d8025c38d8d5585411d634d612c49d076156573ebaeb4066ef905b0','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','68d2c8a60451d93607efb0a67f3a8eb88a5967bec507015a3479b897ee43babc','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/parameters_and_effects.so','f67535e3579b01a3ff2ecffb94388724f61bb1b243a3440626599fb037463af3','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/simulated.so','7aca6faa006a42c34e3a2b58666704d1a9467f5cb95801f1dbff02d501383900','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/truncation.so','fd8efa09b02cc9a12d12ee3d5d98d12de7f17dbeab63bc527d5f23feeff9be9f','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','fb9a8bb7526fe837c53f814cb071bcd1f6b8dd2b9421f33f41167d96c63519d9','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/declared.so','918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/simulated.so','7aca6faa006a42c34e3a2b58666704d1a9467f5cb95801f1dbff02d501383900','0.1.0');
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
INSERT INTO revision VALUES(3298534883329,3298534883329,1,NULL,'4174ba9417facd2fc3acc99826b40fb8d3da15c492a9430eaed7b089fbe368bd','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2},{"address":"joint.hinge.damping@steps","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2}]','[]','{"control_period":0.0,"delay_rounding":"none","engine":"articulated","joint_erp":0.2,"step":0.03,"substeps":4}','c3bd9045ed0bd646f818822d11f8ae458f5347b80286d391a8439c05e2cd6b9f','[]','[]','rigid');
INSERT INTO revision VALUES(6597069766657,3298534883329,2,3298534883329,'a0633deccec346c686daeec26cbbbd4e5046a3c2f4f850834834cddca4451189','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2},{"address":"effect.coulomb_friction.torque","lower":0.0,"start":0.02256,"unit":"N*m","upper":10000.0},{"address":"joint.hinge.damping@steps","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2}]','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.02256},"where":["joint.hinge"]}]','{"control_period":0.0,"delay_rounding":"none","engine":"articulated","joint_erp":0.2,"step":0.03,"substeps":5}','c3bd9045ed0bd646f818822d11f8ae458f5347b80286d391a8439c05e2cd6b9f','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.02256},"where":["joint.hinge"]}]','[]','coulomb_friction');
CREATE TABLE revision_use (
  run INTEGER NOT NULL REFERENCES run (number),
  position INTEGER NOT NULL,
  revision INTEGER NOT NULL REFERENCES revision (id),
  PRIMARY KEY (run, position)
) STRICT, WITHOUT ROWID;
INSERT INTO revision_use VALUES(3,0,3298534883329);
INSERT INTO revision_use VALUES(4,0,3298534883329);
INSERT INTO revision_use VALUES(5,0,3298534883329);
INSERT INTO revision_use VALUES(6,0,6597069766657);
INSERT INTO revision_use VALUES(7,0,6597069766657);
INSERT INTO revision_use VALUES(8,0,3298534883329);
CREATE TABLE trial (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  name TEXT NOT NULL,
  file TEXT NOT NULL,
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  held_out INTEGER NOT NULL CHECK (held_out IN (0, 1)),
  duration REAL NOT NULL,
  samples INTEGER NOT NULL, setup TEXT NOT NULL DEFAULT '',
  UNIQUE (experiment, digest, name, held_out)
) STRICT;
INSERT INTO trial VALUES(1099511627777,1099511627777,'run 1, trial 0','','cebf884e18a6468468a2445fdf471880e8f7728afb142d2eff821ac0a313fa6b',0,0.29999999999999998889,16,'');
INSERT INTO trial VALUES(1099511627778,1099511627777,'run 1, trial 1','','a7642a2db8fcc71817e7f449d9011a4f58676a9324cdf51931b5aaebf4dd2e5f',0,0.29999999999999998889,16,'');
INSERT INTO trial VALUES(1099511627779,1099511627777,'run 1, trial 2','','c083a4db90279749f79561014f35527ec17a7b47129adb9c9d608b4c254e1c7e',0,0.29999999999999998889,16,'');
INSERT INTO trial VALUES(2199023255553,2199023255553,'run 2, trial 0','','1e6a70e90e62e6e55304d195af1ff9e9010d25059e5dd29944a5191853d8f7ee',0,0.29999999999999998889,16,'');
INSERT INTO trial VALUES(2199023255554,2199023255553,'run 2, trial 1','','64cd4e7e3078a2482712591b94c3c79f05c405abdffe01c7e23a6bd39e2842ba',0,0.29999999999999998889,16,'');
INSERT INTO trial VALUES(3298534883329,3298534883329,'sine.csv','sine.csv','d54a309e0efa34f0c8ee09d78bbff0c2156b70450a3f71bfaf7d3e8e37c56ca9',0,1.830000000000000071,62,'sine');
INSERT INTO trial VALUES(3298534883330,3298534883329,'steps.csv','steps.csv','f45aa2b82e75c69739aa27c69a03dba4bc705fb3c82a6c08a184c1e1efcdafd1',0,1.830000000000000071,62,'steps');
INSERT INTO trial VALUES(3298534883331,3298534883329,'chirp.csv','chirp.csv','336df2d7813e9a0bec213a5bbf62831db7c9326effc1d35d1aa03cfd1e85853e',1,0.9000000000000000222,31,'');
INSERT INTO trial VALUES(9895604649985,1099511627777,'run 9, trial 0','','357d04006265dc35d69c56580494972d84b0456be87ce5f5d226368c7c4b78f9',0,0.29999999999999998889,16,'');
INSERT INTO trial VALUES(10995116277761,1099511627777,'trial-1','','3aab7bad8565bd35185ff5ec09f67c4affdd3439b6faf1041eea00b81c1d0980',0,0.29999999999999998889,16,'');
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
INSERT INTO fit VALUES(3298534883329,3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 7a97ef6bdadc69be886b9bdc90357718f27ce179 918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421 7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','free_run','huber',3.0,1,8.0982187082903536179,116,262,0,1,1,0.78527471340943588717,'[[1.6800410866827e-05,0.0,-3.159624853428662e-06],[0.0,2.629029683062333e-07,0.0],[-3.159624853428662e-06,0.0,2.060589388140129e-06]]','[]','["the 95 % intervals are rough: residuals are correlated over 0.79 s, so that the trials give only 12 nearly independent blocks of data; longer trials help"]');
INSERT INTO fit VALUES(6597069766657,6597069766657,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 7a97ef6bdadc69be886b9bdc90357718f27ce179 e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f 918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421 7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5','free_run','huber',3.0,1,7.1693829829003323794,116,660,0,1,1,0.92980456639458375356,'[[3.524601267374723e-05,null,null,null],[null,null,null,null],[null,null,null,null],[null,null,null,null]]','["the data cannot tell joint.hinge.damping, effect.coulomb_friction.torque and joint.hinge.damping@steps apart (only combinations of them)"]','["the 95 % intervals are rough: residuals are correlated over 0.93 s, so that the trials give only 12 nearly independent blocks of data; longer trials help"]');
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
INSERT INTO fit_stage VALUES(3298534883329,0,'free run',0.0,2,1,1,5,1,8.0982187082903536179,'[0.5865934845516547,0.0270885800596413,0.02296081888141567]');
INSERT INTO fit_stage VALUES(6597069766657,0,'free run',0.0,2,2,1,5,1,7.1693829829003323794,'[0.5864575768751864,0.024097914394566627,0.005400277075590399,0.01955088771319455]');
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
INSERT INTO fitted_value VALUES(3298534883329,0,'body.arm.mass','kg',0.5,0.58659348455165472024,0.0040988304266982066373,0.57732128594280418543,0.59586568316050525506,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.027088580059641299835,0.00051274064428932612791,0.025928680138504432706,0.028248479980778166964,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,2,'joint.hinge.damping@steps','N*m*s/rad',0.010000000000000000208,0.022960818881415670511,0.0014354753178442774489,0.01971354810913420949,0.026208089653697131532,NULL,1);
INSERT INTO fitted_value VALUES(6597069766657,0,'body.arm.mass','kg',0.5,0.58645757687518640377,0.0059368352405761801865,0.57276721026039190132,0.60014794348998090622,NULL,1);
INSERT INTO fitted_value VALUES(6597069766657,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.024097914394566627427,1e999,0.0,0.2000000000000000111,NULL,0);
INSERT INTO fitted_value VALUES(6597069766657,2,'effect.coulomb_friction.torque','N*m',0.022560000000000000192,0.0054002770755903987259,1e999,0.0,10000.0,NULL,0);
INSERT INTO fitted_value VALUES(6597069766657,3,'joint.hinge.damping@steps','N*m*s/rad',0.010000000000000000208,0.019550887713194551459,1e999,0.0,0.2000000000000000111,NULL,0);
CREATE TABLE holdout_look (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  revision INTEGER NOT NULL REFERENCES revision (id),
  command TEXT NOT NULL,
  time TEXT NOT NULL,
  UNIQUE (experiment, number)
) STRICT;
INSERT INTO holdout_look VALUES(3298534883329,3298534883329,1,3298534883329,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T12:00:32Z');
CREATE TABLE comparison (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  kind TEXT NOT NULL CHECK (kind IN ('refitted', 'as_written')),
  fit INTEGER REFERENCES fit (id),
  look INTEGER,
  step REAL,
  findings TEXT NOT NULL CHECK (json_valid(findings))
) STRICT;
INSERT INTO comparison VALUES(3298534883329,3298534883329,'refitted',3298534883329,1,0.0074999999999999997224,'[]');
INSERT INTO comparison VALUES(5497558138881,3298534883329,'refitted',3298534883329,NULL,0.0074999999999999997224,'[]');
INSERT INTO comparison VALUES(6597069766657,6597069766657,'refitted',6597069766657,NULL,0.0060000000000000001249,'[]');
INSERT INTO comparison VALUES(8796093022209,3298534883329,'refitted',3298534883329,NULL,0.0074999999999999997224,'[]');
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
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.0,'rad',58,0.007995288538463780209,0.024185707803359404038,NULL,-0.0057240069576745510049,NULL,NULL,NULL,0.01878894809943104649,0.56999999999999995115,0.0068999951036085825639,0.040476955208052237122);
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0014797903784982888424,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.5,'rad',0,0.0070906644450942956162,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.0,'rad',58,0.0083877403061990464527,0.023262629771967507225,NULL,0.0064271922708728224105,NULL,NULL,NULL,0.016930610011051783203,1.3200000000000000621,0.00098499620600591255084,0.10994478441557933856);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0034184339141135043106,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.5,'rad',0,0.0094978489966573605152,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.0,'rad',27,0.009480414758626392116,0.065182085943350176471,NULL,-0.00025967597608641781103,NULL,NULL,NULL,0.023966904118555343305,0.9000000000000000222,0.0038925053529508179747,0.036345965543743516401);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.10000000000000000555,'rad',0,0.001280971941865894411,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.5,'rad',0,0.0065195854043893974524,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883329,'angle',0.0,'rad',58,0.007995288538463780209,0.024185707803359404038,NULL,-0.0057240069576745510049,NULL,NULL,NULL,0.01878894809943104649,0.56999999999999995115,0.0068999951036085825639,0.040476955208052237122);
INSERT INTO comparison_score VALUES(5497558138881,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0014797903784982888424,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883329,'angle',0.5,'rad',0,0.0070906644450942956162,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883330,'angle',0.0,'rad',58,0.0083877403061990464527,0.023262629771967507225,NULL,0.0064271922708728224105,NULL,NULL,NULL,0.016930610011051783203,1.3200000000000000621,0.00098499620600591255084,0.10994478441557933856);
INSERT INTO comparison_score VALUES(5497558138881,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0034184339141135043106,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(5497558138881,3298534883330,'angle',0.5,'rad',0,0.0094978489966573605152,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.0,'rad',58,0.006218557725358767399,0.018811105988270990924,NULL,-0.0040744696223767003576,NULL,NULL,NULL,0.011330153822200469959,0.56999999999999995115,0.0068956455648260944757,0.017301482791564997548);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.10000000000000000555,'rad',0,0.001396997273522283681,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.5,'rad',0,0.0046154972596710247892,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.0,'rad',58,0.0090498831765620860179,0.025099022398241282311,NULL,0.0071285394882707282457,NULL,NULL,NULL,0.018132959365114720284,1.3200000000000000621,0.00098601971578516885499,0.065139147681474954265);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0034233309444274507768,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.5,'rad',0,0.010081632814368959513,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883329,'angle',0.0,'rad',58,0.007995288538463780209,0.024185707803359404038,NULL,-0.0057240069576745510049,NULL,NULL,NULL,0.01878894809943104649,0.56999999999999995115,0.0068999951036085825639,0.040476955208052237122);
INSERT INTO comparison_score VALUES(8796093022209,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0014797903784982888424,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883329,'angle',0.5,'rad',0,0.0070906644450942956162,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883330,'angle',0.0,'rad',58,0.0083877403061990464527,0.023262629771967507225,NULL,0.0064271922708728224105,NULL,NULL,NULL,0.016930610011051783203,1.3200000000000000621,0.00098499620600591255084,0.10994478441557933856);
INSERT INTO comparison_score VALUES(8796093022209,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0034184339141135043106,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(8796093022209,3298534883330,'angle',0.5,'rad',0,0.0094978489966573605152,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
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
INSERT INTO noise_floor VALUES(3298534883329,3298534883329,'angle','rad',0.0068999951036085825639,0.00093507523005767695725,0.0,0.0068363416198983940202,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.84 mrad');
INSERT INTO noise_floor VALUES(3298534883329,3298534883330,'angle','rad',0.00098499620600591255084,0.00093507523005767695725,0.0,0.00030959948316918215567,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 310 µrad');
INSERT INTO noise_floor VALUES(3298534883329,3298534883331,'angle','rad',0.0038925053529508179747,0.00093507523005767695725,0.0,0.0037785224938967020523,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 3.78 mrad');
INSERT INTO noise_floor VALUES(5497558138881,3298534883329,'angle','rad',0.0068999951036085825639,0.00093507523005767695725,0.0,0.0068363416198983940202,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.84 mrad');
INSERT INTO noise_floor VALUES(5497558138881,3298534883330,'angle','rad',0.00098499620600591255084,0.00093507523005767695725,0.0,0.00030959948316918215567,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 310 µrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883329,'angle','rad',0.0068956455648260944757,0.00093507523005767695725,0.0,0.0068319515564616217426,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.83 mrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883330,'angle','rad',0.00098601971578516885499,0.00093507523005767695725,0.0,0.00031284052494785167392,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 313 µrad');
INSERT INTO noise_floor VALUES(8796093022209,3298534883329,'angle','rad',0.0068999951036085825639,0.00093507523005767695725,0.0,0.0068363416198983940202,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.84 mrad');
INSERT INTO noise_floor VALUES(8796093022209,3298534883330,'angle','rad',0.00098499620600591255084,0.00093507523005767695725,0.0,0.00030959948316918215567,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 310 µrad');
CREATE TABLE numerical_error (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  horizon REAL NOT NULL,
  error REAL NOT NULL,
  PRIMARY KEY (comparison, trial, channel, horizon)
) STRICT, WITHOUT ROWID;
INSERT INTO numerical_error VALUES(3298534883329,3298534883329,'angle',0.0,2.5801628314606702189e-05);
INSERT INTO numerical_error VALUES(3298534883329,3298534883330,'angle',0.0,5.6759158393135186065e-05);
INSERT INTO numerical_error VALUES(3298534883329,3298534883331,'angle',0.0,8.6260430281407987872e-06);
INSERT INTO numerical_error VALUES(5497558138881,3298534883329,'angle',0.0,2.5801628314606702189e-05);
INSERT INTO numerical_error VALUES(5497558138881,3298534883330,'angle',0.0,5.6759158393135186065e-05);
INSERT INTO numerical_error VALUES(6597069766657,3298534883329,'angle',0.0,1.6501467431443679687e-05);
INSERT INTO numerical_error VALUES(6597069766657,3298534883330,'angle',0.0,3.5519435805116200352e-05);
INSERT INTO numerical_error VALUES(8796093022209,3298534883329,'angle',0.0,2.5801628314606702189e-05);
INSERT INTO numerical_error VALUES(8796093022209,3298534883330,'angle',0.0,5.6759158393135186065e-05);
CREATE TABLE work_time (
  kind TEXT NOT NULL CHECK (kind IN ('fit', 'comparison')),
  id INTEGER NOT NULL,
  seconds REAL NOT NULL,
  PRIMARY KEY (kind, id)
) STRICT, WITHOUT ROWID;
INSERT INTO work_time VALUES('comparison',3298534883329,0.013993138999999999924);
INSERT INTO work_time VALUES('comparison',5497558138881,0.018814379999999998605);
INSERT INTO work_time VALUES('comparison',6597069766657,0.030032657000000000796);
INSERT INTO work_time VALUES('comparison',8796093022209,0.010728621000000000684);
INSERT INTO work_time VALUES('fit',3298534883329,0.025429439000000001597);
INSERT INTO work_time VALUES('fit',6597069766657,0.10106758600000000092);
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
INSERT INTO eea_run VALUES(1,1099511627777,1,2,1,2,'["joint.hinge.damping","effect.coulomb_friction.torque","effect.coulomb_friction"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
INSERT INTO eea_run VALUES(2,2199023255553,1,1,1,2,'["joint.hinge.damping"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
INSERT INTO eea_run VALUES(9,1099511627777,1,2,1,2,'["joint.hinge.damping","effect.coulomb_friction.torque","effect.coulomb_friction"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
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
INSERT INTO free_value VALUES(2,0,'joint.hinge.damping','N*m*s/rad',0.0,0.2000000000000000111,0.010000000000000000208,NULL);
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
  test_steps INTEGER NOT NULL, stopped TEXT,
  CHECK (id = (run << 40) + 1 + number)
) STRICT;
INSERT INTO pass VALUES(1099511627778,1,1,1,1099511627782,0.00087304898096649040471,1099511627781,23233.53786051467614,12,0,0,0,540,6,0,630,NULL);
INSERT INTO pass VALUES(1099511627779,1,2,1,1099511627793,0.0046101901033581121208,1099511627787,125350.15558612215681,12,1,1,0,987,6,0,765,NULL);
INSERT INTO pass VALUES(2199023255554,2,1,1,2199023255554,0.0038656872525911784715,2199023255557,30482.629708920212579,4,0,0,0,180,4,0,450,NULL);
INSERT INTO pass VALUES(9895604649986,9,1,0,NULL,NULL,NULL,NULL,0,0,0,0,0,0,0,0,NULL);
CREATE TABLE best_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO best_value VALUES(1099511627778,0,0.05972615920382814969);
INSERT INTO best_value VALUES(1099511627778,1,0.02711595782742521471);
INSERT INTO best_value VALUES(1099511627779,0,0.083759962422083736321);
INSERT INTO best_value VALUES(1099511627779,1,NULL);
INSERT INTO best_value VALUES(2199023255554,0,0.089389021853670855288);
CREATE TABLE objective_score (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO objective_score VALUES(1099511627778,0,'joint.hinge.damping','N*m*s/rad',0.010817848195209880945);
INSERT INTO objective_score VALUES(1099511627778,1,'effect.coulomb_friction.torque','N*m',0.0028840421725747841796);
INSERT INTO objective_score VALUES(1099511627778,2,'effects','1',0.0);
INSERT INTO objective_score VALUES(1099511627779,0,'joint.hinge.damping','N*m*s/rad',0.034851651413465467577);
INSERT INTO objective_score VALUES(1099511627779,1,'effects','1',1.0);
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
INSERT INTO test VALUES(1099511627784,1099511627779,0,NULL,NULL,X'00000000000000004dbbbe5864ff613f62d279400b0fc1bf551518d56598cf3f11cd9bd52f7ac33f0000000000888940',1);
INSERT INTO test VALUES(1099511627785,1099511627779,0,NULL,NULL,X'00000000000000001bb18fffce03d53f0ad4e25dc77ab23f74468be60603f83f7b4a7ee3f55203400000000000f08740',1);
INSERT INTO test VALUES(1099511627786,1099511627779,0,NULL,NULL,X'00000000000000001c922573ed2bb53f0000000000000000ab9ff7ea40baf53f712c85243c6dbc3f0000000000e08e40',1);
INSERT INTO test VALUES(1099511627787,1099511627779,0,NULL,NULL,X'000000000000f03f561bf95dc828e03f187d2c82c543c2bf7cde11f46714d93f4e27e9c14edfe33f0000000000007f40',1);
INSERT INTO test VALUES(1099511627788,1099511627779,1,1099511627786,NULL,X'00000000000000001c922573ed2bb53fe42912077d89af3f93168ca0047f0a40712c85243c6dbc3f0000000000e08e40',1);
INSERT INTO test VALUES(1099511627789,1099511627779,1,1099511627786,NULL,X'00000000000000001c922573ed2bb53f0000000000000000ab9ff7ea40baf53ffaad5dafb9b002400000000000e08e40',1);
INSERT INTO test VALUES(2199023255553,2199023255554,0,NULL,NULL,X'000000000000084048da9553beefe13f0000000000000000d8793b8c61eafc3f2c3b3c797c61f53f0000000000c06a40',1);
INSERT INTO test VALUES(2199023255554,2199023255554,0,NULL,NULL,X'0000000000000000478312443c1fb23fee4ace9b951cadbf025e726c76dce63f4530f667f778c63f0000000000a07240',1);
INSERT INTO test VALUES(2199023255555,2199023255554,0,NULL,NULL,X'000000000000004046dd36978a28e33f0000000000000000e73476e6775dc53f48df1efd05d1c63f0000000000406e40',1);
INSERT INTO test VALUES(2199023255556,2199023255554,0,NULL,NULL,X'000000000000f03fa2f36e4019c7d83f000000000000000019a1b4bb904d0d40b87b4c3b84ac07400000000000388b40',1);
INSERT INTO test VALUES(2199023255557,2199023255554,0,NULL,NULL,X'000000000000f03f0fb90643a570e03f00548f5a32257abf16bfa922bde9ed3fdf1d117ab649d33f0000000000e07840',1);
INSERT INTO test VALUES(9895604649985,9895604649986,0,NULL,NULL,X'0000000000000000e6e9bc8b6d92ce3fc18d084abd5cc13f0ad449cdaf55f63f678505b0dcfa0b400000000000807540',1);
CREATE TABLE test_score (
  test INTEGER NOT NULL REFERENCES test (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (test, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO test_score VALUES(1099511627777,2,NULL);
INSERT INTO test_score VALUES(1099511627778,2,204.21379138239785788);
INSERT INTO test_score VALUES(1099511627779,2,7.7768112046571626905);
INSERT INTO test_score VALUES(1099511627780,2,11498.516923060182307);
INSERT INTO test_score VALUES(1099511627781,2,23233.53786051467614);
INSERT INTO test_score VALUES(1099511627782,2,11498.516923060182307);
INSERT INTO test_score VALUES(1099511627783,2,23233.53786051467614);
INSERT INTO test_score VALUES(1099511627784,2,7535.1883238281207014);
INSERT INTO test_score VALUES(1099511627785,2,2697.4766675756172843);
INSERT INTO test_score VALUES(1099511627786,2,22764.138098745854222);
INSERT INTO test_score VALUES(1099511627787,2,125350.15558612215681);
INSERT INTO test_score VALUES(1099511627788,2,8771.6920618568165078);
INSERT INTO test_score VALUES(1099511627789,2,20987.866621133187436);
INSERT INTO test_score VALUES(2199023255553,2,NULL);
INSERT INTO test_score VALUES(2199023255554,2,1379.9252218923759301);
INSERT INTO test_score VALUES(2199023255555,2,209.35803565594443397);
INSERT INTO test_score VALUES(2199023255556,2,16816.052735920548002);
INSERT INTO test_score VALUES(2199023255557,2,30482.629708920212579);
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
, commanded_before TEXT NOT NULL DEFAULT '[]') STRICT;
INSERT INTO trial_condition VALUES(1099511627777,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]','[]');
INSERT INTO trial_condition VALUES(1099511627778,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]','[]');
INSERT INTO trial_condition VALUES(1099511627779,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]','[]');
INSERT INTO trial_condition VALUES(2199023255553,'zero_order','[[0.0,0.0,0.0]]','[null]','[]','[]');
INSERT INTO trial_condition VALUES(2199023255554,'zero_order','[[0.0,0.0,0.0]]','[null]','[]','[]');
INSERT INTO trial_condition VALUES(9895604649985,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]','[]');
INSERT INTO trial_condition VALUES(10995116277761,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]','[]');
CREATE TABLE target_trial (
  run INTEGER NOT NULL REFERENCES eea_run (run),
  number INTEGER NOT NULL CHECK (number >= 0),
  trial INTEGER NOT NULL REFERENCES trial (id),
  test INTEGER REFERENCES test (id),
  for_transfer INTEGER NOT NULL CHECK (for_transfer IN (0, 1)),
  predicted_fitness REAL,
  measured_fitness REAL, surprise REAL,
  PRIMARY KEY (run, number),
  UNIQUE (run, trial),
  CHECK (test >> 40 = run)
) STRICT, WITHOUT ROWID;
INSERT INTO target_trial VALUES(1,0,1099511627777,1099511627777,0,NULL,NULL,NULL);
INSERT INTO target_trial VALUES(1,1,1099511627778,1099511627781,0,23233.53786051467614,NULL,0.0036098607984536745969);
INSERT INTO target_trial VALUES(1,2,1099511627779,1099511627787,1,125350.15558612215681,NULL,0.0065126514578665965771);
INSERT INTO target_trial VALUES(2,0,2199023255553,2199023255553,0,NULL,NULL,NULL);
INSERT INTO target_trial VALUES(2,1,2199023255554,2199023255557,1,30482.629708920212579,NULL,0.018673648957770683232);
INSERT INTO target_trial VALUES(9,0,9895604649985,9895604649985,0,NULL,NULL,NULL);
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
INSERT INTO model VALUES(1099511627777,1099511627778,0,NULL,NULL,X'df5d92df8b5ea13fd32415f9cae1a23f40b8ee23b536e43f','full',0,0.0010697477901249795653);
INSERT INTO model VALUES(1099511627778,1099511627778,0,NULL,NULL,X'53a27bed32e2b63f9226462049c49b3f94513d9aba9eef3f','full',0,0.0043683756242772053129);
INSERT INTO model VALUES(1099511627779,1099511627778,0,NULL,NULL,X'1ce8aaab2f2dae3f0d662290c040b83f9dfb393c4835d53f','full',0,0.0085204250056396049761);
INSERT INTO model VALUES(1099511627780,1099511627778,0,NULL,NULL,X'8ab1b73be931c73f283f43e7c09f9d3f54fcdcc0b2a5ee3f','full',0,0.014244113048853555836);
INSERT INTO model VALUES(1099511627781,1099511627778,1,1099511627777,NULL,X'8064129a3865623f51889923a25fa63f40b8ee23b536e43f','full',0,0.0029328226923609292987);
INSERT INTO model VALUES(1099511627782,1099511627778,1,1099511627777,1099511627778,X'ec04fe586d94ae3f9226462049c49b3f22440f63ba20e93f','full',0,0.00087304898096649040471);
INSERT INTO model VALUES(1099511627783,1099511627778,0,NULL,NULL,X'15b22d09ffbcc13f8f275156ff76b23f9ac813e1425ce93f','full',0,0.021367136099182799241);
INSERT INTO model VALUES(1099511627784,1099511627778,0,NULL,NULL,X'c20896e9a59aa03f3ff1392cb2ac9e3f06a209d4e44feb3f','full',0,0.0024346245497159947623);
INSERT INTO model VALUES(1099511627785,1099511627778,0,NULL,NULL,X'32659ebfd5f4c53fef48cb79fe7e923ff0c3f3717db2e13f','full',0,0.010748403103472702752);
INSERT INTO model VALUES(1099511627786,1099511627778,0,NULL,NULL,X'edb8146385fa8b3fb02ba9c7887f8d3f3fc96f84acf9d13f','full',0,0.015726214207242940334);
INSERT INTO model VALUES(1099511627787,1099511627778,1,1099511627784,1099511627785,X'c20896e9a59aa03fef48cb79fe7e923ff0c3f3717db2e13f','full',0,0.0064183471848317814184);
INSERT INTO model VALUES(1099511627788,1099511627778,1,1099511627784,NULL,X'18cb51651843c23f3a4fca6951587d3f816750c77884d13f','full',0,0.0048877583975718572398);
INSERT INTO model VALUES(1099511627789,1099511627779,0,NULL,NULL,X'5211b83e14b8c83f2d24c8ee0aee793fcecc9c810264e53f','full',0,0.02609394728490888049);
INSERT INTO model VALUES(1099511627790,1099511627779,0,NULL,NULL,X'efe8f344ba0ac53f806f20c32fe9af3f88ac6c1f55c2e33f','full',0,0.036121146261771250318);
INSERT INTO model VALUES(1099511627791,1099511627779,0,NULL,NULL,X'17654ecd00c89d3fd0e940674dd2b63fa0aa93009908ea3f','full',0,0.015640481138230254848);
INSERT INTO model VALUES(1099511627792,1099511627779,0,NULL,NULL,X'0061b9e1c6adbd3fa8db5d373b71a73f2f2e9a2293f7de3f','full',0,0.0095100446305213352793);
INSERT INTO model VALUES(1099511627793,1099511627779,1,1099511627791,NULL,X'712951fb4a71b53facf702f17a04a23f8a30bbe3e023c03f','full',0,0.0046101901033581121208);
INSERT INTO model VALUES(1099511627794,1099511627779,1,1099511627791,1099511627792,X'770c646e01c5973f076a14500689b03f2f2e9a2293f7de3f','abandoned',0,0.017002151169929646812);
INSERT INTO model VALUES(1099511627795,1099511627779,0,NULL,NULL,X'eae97feaf3a1bf3f8faba0e39ff6b63fe16bbd6a11cede3f','full',0,0.010975380381570289112);
INSERT INTO model VALUES(1099511627796,1099511627779,0,NULL,NULL,X'48fd1a3120a0c63faf6ded876cc3b63f4699be7604e4ee3f','full',0,0.04512398312305469783);
INSERT INTO model VALUES(1099511627797,1099511627779,0,NULL,NULL,X'ba32ab8ff2dd813f3fb706672c659c3ffcca128cb27fe83f','full',0,0.013326508707458073824);
INSERT INTO model VALUES(1099511627798,1099511627779,0,NULL,NULL,X'c2b470eef897c73f848473591171a23fcb983224e010d43f','full',0,0.022966260657015097335);
INSERT INTO model VALUES(1099511627799,1099511627779,1,1099511627797,NULL,X'ba32ab8ff2dd813fa927aa43bde6a33fe86718297171ee3f','full',0,0.009161361302777155588);
INSERT INTO model VALUES(1099511627800,1099511627779,1,1099511627795,NULL,X'eae97feaf3a1bf3fd6fa84760aa9a53faa334008369ecb3f','full',1,0.010975380381570289112);
INSERT INTO model VALUES(2199023255553,2199023255554,0,NULL,NULL,X'df5d92df8b5ea13f','full',0,0.0084837101898290866869);
INSERT INTO model VALUES(2199023255554,2199023255554,0,NULL,NULL,X'53a27bed32e2b63f','full',0,0.0038656872525911784715);
INSERT INTO model VALUES(2199023255555,2199023255554,0,NULL,NULL,X'1ce8aaab2f2dae3f','full',0,0.0046342950692290748107);
INSERT INTO model VALUES(2199023255556,2199023255554,0,NULL,NULL,X'8ab1b73be931c73f','full',0,0.011813321963337182485);
CREATE TABLE model_score (
  model INTEGER NOT NULL REFERENCES model (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (model, trial, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO model_score VALUES(1099511627777,1099511627777,1,0.0010697477901249795653);
INSERT INTO model_score VALUES(1099511627778,1099511627777,1,0.0043683756242772053129);
INSERT INTO model_score VALUES(1099511627779,1099511627777,1,0.0085204250056396049761);
INSERT INTO model_score VALUES(1099511627780,1099511627777,1,0.014244113048853555836);
INSERT INTO model_score VALUES(1099511627781,1099511627777,1,0.0029328226923609292987);
INSERT INTO model_score VALUES(1099511627782,1099511627777,1,0.00087304898096649040471);
INSERT INTO model_score VALUES(1099511627783,1099511627777,1,0.021367136099182799241);
INSERT INTO model_score VALUES(1099511627784,1099511627777,1,0.0024346245497159947623);
INSERT INTO model_score VALUES(1099511627785,1099511627777,1,0.010748403103472702752);
INSERT INTO model_score VALUES(1099511627786,1099511627777,1,0.015726214207242940334);
INSERT INTO model_score VALUES(1099511627787,1099511627777,1,0.0064183471848317814184);
INSERT INTO model_score VALUES(1099511627788,1099511627777,1,0.0048877583975718572398);
INSERT INTO model_score VALUES(1099511627789,1099511627777,1,0.010246466317388007449);
INSERT INTO model_score VALUES(1099511627789,1099511627778,1,0.041941428252429746592);
INSERT INTO model_score VALUES(1099511627790,1099511627777,1,0.02121643803480140894);
INSERT INTO model_score VALUES(1099511627790,1099511627778,1,0.051025854488741105574);
INSERT INTO model_score VALUES(1099511627791,1099511627777,1,0.015898063509944781318);
INSERT INTO model_score VALUES(1099511627791,1099511627778,1,0.015382898766515726643);
INSERT INTO model_score VALUES(1099511627792,1099511627777,1,0.0031579120866745222923);
INSERT INTO model_score VALUES(1099511627792,1099511627778,1,0.015862177174368150001);
INSERT INTO model_score VALUES(1099511627793,1099511627777,1,0.0049842910754487844415);
INSERT INTO model_score VALUES(1099511627793,1099511627778,1,0.0042360891312674389327);
INSERT INTO model_score VALUES(1099511627794,1099511627777,1,0.014117969409478013306);
INSERT INTO model_score VALUES(1099511627794,1099511627778,1,0.019886332930381275113);
INSERT INTO model_score VALUES(1099511627795,1099511627777,1,0.0034207705981588315546);
INSERT INTO model_score VALUES(1099511627795,1099511627778,1,0.018529990164981746669);
INSERT INTO model_score VALUES(1099511627796,1099511627777,1,0.027897707470038328458);
INSERT INTO model_score VALUES(1099511627796,1099511627778,1,0.062350258776071067201);
INSERT INTO model_score VALUES(1099511627797,1099511627777,1,0.0065933160614160494367);
INSERT INTO model_score VALUES(1099511627797,1099511627778,1,0.020059701353500096476);
INSERT INTO model_score VALUES(1099511627798,1099511627777,1,0.0082992002163387243451);
INSERT INTO model_score VALUES(1099511627798,1099511627778,1,0.037633321097691477263);
INSERT INTO model_score VALUES(1099511627799,1099511627777,1,0.0030982362372982356207);
INSERT INTO model_score VALUES(1099511627799,1099511627778,1,0.015224486368256075555);
INSERT INTO model_score VALUES(1099511627800,1099511627777,1,0.0034207705981588315546);
INSERT INTO model_score VALUES(1099511627800,1099511627778,1,0.018529990164981746669);
INSERT INTO model_score VALUES(2199023255553,2199023255553,1,0.0084837101898290866869);
INSERT INTO model_score VALUES(2199023255554,2199023255553,1,0.0038656872525911784715);
INSERT INTO model_score VALUES(2199023255555,2199023255553,1,0.0046342950692290748107);
INSERT INTO model_score VALUES(2199023255556,2199023255553,1,0.011813321963337182485);
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
INSERT INTO checkpoint VALUES(1,1,0.00196208399999999979,X'00000000000000400000000000001040000000000000084000000000000038400000000000002a400000000000001c4000000000000000000000000000000000000000000000f03f000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000008056400000000000000000000000000000104000000000000030400000000000000840712951fb4a71b53facf702f17a04a23f8a30bbe3e023c03f0000000000000040712951fb4a71b53f000000000000f87fbe668e7b22e2723f000000000000000000000000000036400000000000000840ba32ab8ff2dd813fa927aa43bde6a33fe86718297171ee3f0000000000000040ba32ab8ff2dd813fa927aa43bde6a33fd748751931c3823f000000000000f03f0000000000002e4000000000000008400061b9e1c6adbd3fa8db5d373b71a73f2f2e9a2293f7de3f00000000000000400061b9e1c6adbd3f000000000000f87f566a5f95007a833f000000000000000000000000000032400000000000000840eae97feaf3a1bf3f8faba0e39ff6b63fe16bbd6a11cede3f0000000000000040eae97feaf3a1bf3f000000000000f87fb468669e427a863f000000000000f03f0000000000000000a9ae51426d926d3f0000000000000840000000000000000000000000000000000000000000000000','d72480f7dac27a3ad859cad3adf7941f709d91579a8cf30b6e43e3d9d0941b88');
INSERT INTO checkpoint VALUES(2,3,0.040018861000000002792,X'00000000000000400000000000001040000000000000004000000000000010400000000000001440000000000000f03f0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000080564000000000000000000000000000000040000000000000f03f000000000000f03f53a27bed32e2b63f000000000000f03f53a27bed32e2b63f0439720aefaa6f3f00000000000000000000000000000040000000000000f03f1ce8aaab2f2dae3f000000000000f03f1ce8aaab2f2dae3ffd98321c69fb723f00000000000000000000000000000000e04d485e2f1f933f000000000000004000000000000000000000000000000000','cedf4f4329647937c6d05f440f80585f62defd73f22ba975d1ea7ed5c530afd8');
INSERT INTO checkpoint VALUES(9,1,0.14118741700000000949,X'0000000000000040000000000000f03f000000000000f03f0000000000000000000000000000f03f000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000f87f000000000000f03f0000000000000000','cb39ff9bbfe400040424c0a9fce81772e4c6e53b1c97ac3b028500759867e86e');
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
INSERT INTO trace VALUES(1099511627777,1099511627777,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000000000000000008000000000000000000000000000000000182d4454fb21693fd221337f7cd9823f5e3855297a6a8f3fbbb2ccbe3a469c3f75a7bbe9bbfda53f5e3855297a6aaf3f75a7bbe9bbfdb53f8cf510745ad8bd3fd221337f7cd9c23f46eaff9edb8fc73f07a27bd1b2e1cb3f3e35a4f8084cd03f','85f7c8bad74cc078fbce5f8701175250fa520536d4b5f202da6274cb51e54b1c');
INSERT INTO trace VALUES(1099511627778,1099511627777,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000004651419103aeae3f3d51419103aebe3ff0fcf0ac8202c73f4251419103aece3fc7d2c83ac22cd33ff0fcf0ac8202d73f1927191f43d8da3f4251419103aede3fb4bdb401e241e13fc9e1626cbab2e03f68999d66b48fdd3f406f75f4f3b9d93f17454d8233e4d53fee1a2510730ed23fee1a2510730ed23f','4c86058b84c957953a33055e2b7ccca04b9f2e284c0ca754599b9eb19b54c931');
INSERT INTO trace VALUES(1099511627779,1099511627777,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf000000000000000000000000000000009a9999999999c9bfb409209baba804bf0000000000000000dfa743919999c9bf172d6e4858b82ebf0000000000000000f79faf729899c9bff00146d3431148bf00000000000000002fb161498e99c9bf97666c40b8885bbf00000000000000006c6fd75e5e99c9bf52e57fff593d6abf0000000000000000d490826cc298c9bf92c6a076173476bf0000000000000000345b533e3197c9bf66f97131704881bf0000000000000000cbee476ec393c9bf27e5dcc3e14989bf00000000000000002730f6fa188dc9bf524022f273a291bf00000000000000003f588d754281c9bf9f9b53d17c9097bf00000000000000000b5789f9126ec9bfdc7e610721369ebf0000000000000000e09fe691e651c9bf262eb38e87a5a2bf0000000000000000e44b3275072cc9bf78e421ff1844a6bf000000000000000095c9bc5ccbfcc8bfd8f4411eb8d4a9bf00000000000000005df67952a9c5c8bf','caa4af7e6e82ec8a9d30e3f1baa3e066691d497f49c1c82be5c6235d7099083a');
INSERT INTO trace VALUES(1099511627780,1099511627778,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000182d4454fb2169bf182d4454fb2189bfbbb2ccbe3a469cbf182d4454fb21a9bf3b43d5598ca2b3bf52912ae42a7dbbbf690091a46c10c2bfdec85dc4cbc6c6bfbbb2ccbe3a46ccbf4cce9ddcd4e2d0bf95cb7d50d0d4d3bfdec85dc4cbc6d6bf27c63d38c7b8d9bf6fc31dacc2aadcbfb8c0fd1fbe9cdfbf','aeba6e6c83ea72cda58bf0d3cb92b8d59837c7daceffd77743b7bad33a33fcab');
INSERT INTO trace VALUES(1099511627781,1099511627778,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'b7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bf','11a4d3e6d7bf498b02a294423254e4aa25d9a57f566b8692a4898376dfb5d740');
INSERT INTO trace VALUES(1099511627782,1099511627778,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bfba34acd68126453f0000000000000000cca3e4dc9099c9bf192d96c885dc643f00000000000000003e164b981199c9bf3cb4b7a2e717773f000000000000000036325dd6fe96c9bf93752cacfc26843f000000000000000035a58dcba991c9bf071dfab0d3d68e3f0000000000000000437a0892ff86c9bf4b09f56a65b1953f00000000000000005940fe5dbb74c9bf32648a98b8c59c3f0000000000000000f05623209a58c9bf13757463dd42a23f000000000000000034fb8a5e8c30c9bf0d231d9a3d66a63f000000000000000080dab10ae3fac8bf3234ecceceb9aa3f000000000000000090f7bd5c74b6c8bf6741ff66302aaf3f00000000000000007bd7184bb662c8bff0f081482fd2b13f000000000000000060b7ec0dcdffc7bfbc1ad826210bb43f000000000000000007c11d2a8d8ec7bfe3bbc6389b37b63f000000000000000057696a9c7110c7bf7d6aed773b50b83f0000000000000000a69848c38787c6bf','818d180f35c3949fddadc0722ad5d0dca060545c79afb33a84de9e8fb75e06d8');
INSERT INTO trace VALUES(1099511627783,1099511627779,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000080182d4454fb2169bf5e3855297a6a8fbf00dfeec95c47a1bf8cf510745ad8adbf75a7bbe9bbfdb5bf5e3855297a6abfbf5875c82124d0c4bfea6f88091bb4cabf98bd4cef4c7ed0bf3b43d5598ca2d3bf385106bb0ff9d6bf8fe7df12d781dabfe77db96a9e0adebff245f5e590b0e0bf1e11e291f474e2bf','99f38ce861afcffa3f9b17bb85161ddd35d059057869eb82424e570027b1d9fe');
INSERT INTO trace VALUES(1099511627784,1099511627779,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf','5913bee0b9cb490d4f46148aa619d98d3f874e5790d69bfee9b08ab350af338f');
INSERT INTO trace VALUES(1099511627785,1099511627779,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf24de62f5c898483f0000000000000000218d92c88d99c9bf501ac085b042683f0000000000000000331c3fa9e198c9bf4750ab7ceada7a3f0000000000000000272205dc1396c9bfa361851ac86e873f00000000000000005afc1ae2dd8ec9bf6f0938e91ced913f0000000000000000685de0407280c9bfe013b69d1236993f0000000000000000f80635f5c067c9bf0c43122e08b6a03f0000000000000000dbdb2e12be41c9bf73a1f9f88132a53f0000000000000000d8245b03a60bc9bf523fc9d8ebf9a93f00000000000000006e073dc83ac3c8bf8d3b6f25cff4ae3f0000000000000000c734dac8f566c8bfbf77e4d9bf05b23f0000000000000000c6f3d4b12af6c7bff27dd01e7293b43f0000000000000000a9acb8131971c7bff6b43a989f18b73f00000000000000002e8de626ecd8c6bff87faaca728bb93f000000000000000064c718d6a92fc6bfdc3245fa69e3bb3f0000000000000000bd9ebbc51378c5bf','a859ee265ac25fd77e4fd2a36a11d7414106afcca9edbd342de1d6b9177a6ab6');
INSERT INTO trace VALUES(1099511627786,1099511627777,NULL,1099511627782,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000000000009aee613964c1a23a121e7a3bf45f0d3c50a1853c5cc7e03c39232e3dcfd77d3dbf7eb03da256eb3d94a6163e3dd5393e5fe25d3e23c2803e','9064cc2d9f63a425ae9fcbdc91f6b7e01368d11a74cd2d63cb0a2e9a56cc63b2');
INSERT INTO trace VALUES(1099511627787,1099511627777,NULL,1099511627782,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe0000000000000000cdcc4cbee1be34b800000000cccc4cbe4e3482b900000000c2cc4cbeef1748ba000000006bcc4cbe6832e2ba00000000d9ca4cbe79cc55bb00000000d3c54cbeeaccb3bb0000000011b94cbea3440bbc000000006d9d4cbec7f14abc0000000027684cbe79058dbc000000003b0a4cbe4edbbbbc0000000008734bbe2b2cf0bc000000006f964abe08da13bd00000000d26f49be221f30bd00000000cb0248be47d94bbd00000000a65b46be','c49a977944a146d3204f3d1f7cfa89508baba571e51892ebf0cc7f86e94dcc8e');
INSERT INTO trace VALUES(1099511627788,1099511627778,NULL,1099511627782,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000e63654bb59d750bcadade6bccde548bd1d7599bd5b9ed7bd16e40ebe235f35bec8a15ebecc0585be627e9bbe3e6cb2be9783c9be3e7ce0be8012f7be','0e90688119cac9511ce9385dd96fba44868d2d32e978cfde1c6b913185409da3');
INSERT INTO trace VALUES(1099511627789,1099511627778,NULL,1099511627782,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe72c5293a0000000086cc4cbe8511273b000000008ac84cbeb384b83b0000000004b84cbe59a7203c00000000c08d4cbe624d753c00000000b0394cbe262dac3c000000007faa4bbe61e2e33c000000002fcf4abeff56103d000000008e9849beabb4303d000000008cfa47be2973523d000000003bed45beaafb743d00000000806d43bee2dd8b3d000000006b7d40beca149d3d0000000029243dbeb0e3ad3d00000000a66d39be4713be3d00000000e06935be','6fa8aef6499bd627c7ecac217db4d6c0d85922fd05b177b02c8a885fff2fcb8f');
INSERT INTO trace VALUES(1099511627790,1099511627778,NULL,1099511627793,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000036a45ebb47ff59bcab93efbc749c4fbd73d09dbddaafdcbdc79211be55f237beafcf60bef5c285be35ba9bbe8000b2bee84cc8be735bdebec4edf3be','d5fb2526165876dcf6d41ec718dbb3943e7a4dd10b54a04d05d543120c156449');
INSERT INTO trace VALUES(1099511627791,1099511627778,NULL,1099511627793,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbee11c323a000000007fcc4cbe82642e3b0000000029c84cbe57a2bf3b0000000062b64cbe8f04263c0000000078894cbec3407c3c0000000038314cbe4435b03c00000000b49c4bbe3522e83c00000000e7bb4abefc5d123d000000002a8149be6168323d000000005de247be9a97533d00000000bdd945befe56753d00000000566643bedc8c8b3d000000001e8c40be222f9c3d00000000af533dbeb258ac3d00000000c0c939be18d8bb3d0000000060fe35be','d84c80232c5fdbdf948f188ba261e1fe0f949e10f768f075d170efde6617e30d');
INSERT INTO trace VALUES(1099511627792,1099511627779,NULL,1099511627793,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000f86980bb73787bbc8e2e0abd657d6fbd010cb6bd2293febdabed27bea33254be42ac81be01519abe98abb3be0b64cdbe7327e7be755400bf25d10cbf','a47fd6ad4c9063dee92d192236cb44864ada447fa3cff6053b997fbf091c984f');
INSERT INTO trace VALUES(1099511627793,1099511627779,NULL,1099511627793,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe38764d3a0000000066cc4cbe232b493b00000000a0c64cbe8e0cdd3b00000000f8ae4cbe937b3f3c0000000035734cbe2072913c00000000cefd4bbebe22cb3c0000000045384bbecabd053d00000000610d4abebf8b283d00000000206b48be02444d3d00000000434446be5b2f733d000000006b9143bee7cd8c3d00000000a75140bee4f09f3d00000000888a3cbe75b4b23d00000000b94738bef5d5c43d000000002b9a33bea81dd63d0000000005972ebe','2b121def929f2513e63bc62fd18e22d6df6c12fabbb0e56465614f82eda3e395');
INSERT INTO trace VALUES(2199023255553,2199023255553,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000000000000000000000182d4454fb21693f182d4454fb21693fd221337f7cd9823f5e3855297a6a8f3fbbb2ccbe3a469c3f75a7bbe9bbfda53f98bd4cef4c7eb03fdec85dc4cbc6b63ff516b34e6aa1be3fef5326471407c43f641cf36673bdc83f8cf510745ad8cd3f5b6797c0a079d13f','44d93e69444bc1d3561f175e21393a8f978b3e619f4bb0634a38d0f23d08b8c9');
INSERT INTO trace VALUES(2199023255554,2199023255553,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',15,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000004651419103aeae3f3d51419103aebe3ff0fcf0ac8202c73f4251419103aece3fc7d2c83ac22cd33ff0fcf0ac8202d73f1927191f43d8da3f4251419103aede3fb4bdb401e241e13fc9e1626cbab2e03f68999d66b48fdd3f406f75f4f3b9d93f17454d8233e4d53fee1a2510730ed23f','fa8b46880d7beeb9daf180eb74107cc0358d1c8d70f8a752c9335355a2570856');
INSERT INTO trace VALUES(2199023255555,2199023255554,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000182d4454fb2169bf182d4454fb2189bfbbb2ccbe3a469cbf182d4454fb21a9bf3b43d5598ca2b3bfbbb2ccbe3a46bcbfd221337f7cd9c2bffbfa508c63f4c7bf8cf510745ad8cdbf0f78e8ad28ded1bf0c86190fac34d5bfaf0ba279eb58d8bfac19d3da6eafdbbfaa27043cf205dfbfd39a9ace3a2ee1bf','1e717076ed3a502edfe9883bef003df855447947b19708bbe510a1c1cf8bb5a0');
INSERT INTO trace VALUES(2199023255556,2199023255554,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',15,'float64',X'00000000000000007b14ae47e17a943f',X'b7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bf','64747528a824da3b3032dd94c3cc38f66e3922cfde287fee1e76d5bfd3c5acf6');
INSERT INTO trace VALUES(2199023255557,2199023255553,NULL,2199023255554,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'000000000000000006edcc3974a5fb3ac5e8ac3b79aa353c2520a33ccd0d043df597463dbe4a8d3d1890c03d4f7afc3d29601f3e4e4c423e4cac653ef11e843e','8b55cb64c6de7ff3b890cd113f51b7555f0de95ddb2ce5ae800d353803f60b18');
INSERT INTO trace VALUES(2199023255558,2199023255553,NULL,2199023255554,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe0000000000000000cdcc4cbed2f0a3b800000000cccc4cbe2251c9b900000000b4cc4cbea6538aba0000000012cc4cbe6b5411bb0000000094c94cbee97d82bb0000000068c24cbee93fd3bb000000008eb14cbe08d01ebc00000000308f4cbe4ae361bc0000000014504cbecbd299bc0000000038e54bbe9278c9bc00000000e63e4bbe05f9fdbc0000000011534abee7811abd00000000d61f49bea73336bd0000000094ab47be1c0e51bd00000000df0446be','9ff0ce06278d20e65830fc9f12940455d0a197c72f5a14a186c015926d9623ee');
INSERT INTO trace VALUES(2199023255559,2199023255554,NULL,2199023255554,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000ff595ebbf97459bcd7b3eebc849d4ebd7ae19cbd4624dbbd976610be174736be198d5ebe754a84bef3df99be3fbbafbeff94c5be002bdbbecf40f0be','53cb4e5216437cd098e022c19bbfc2c0cc213ff64a53c7f4808cd3b85076dcbc');
INSERT INTO trace VALUES(2199023255560,2199023255554,NULL,2199023255554,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe82e1313a0000000080cc4cbedff52d3b000000002fc84cbe5befbe3b000000008bb64cbedf38253c000000001c8a4cbe89c37a3c000000000e334cbea0faae3c00000000f1a04bbeb646e63c0000000060c44abea40d113d000000005d9049be83a4303d0000000071fb47be6b51513d000000006e0046be9982723d00000000d39e43be53d7893d00000000d8da40bee82b9a3d0000000024bd3dbe5107aa3d000000003e523abeec39b93d00000000c8a936be','838d69f46ade5170375cf62e0a4d693aceff7c81de027ee38fede1f3586ff277');
INSERT INTO trace VALUES(3298534883329,3298534883329,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fa8305cb673d9823fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f3435fe473946ac3fd221337f7cd9b23f182d4454fb21b93f5e3855297a6abf3fd562aa3d043ec33f806a2125532bc73fb530de412b7dcb3f6179cce701cfcf3f4d4080e1b042d23fa46477349c6bd43ffa886e878794d63f15eccc9573bdd83f68cf4c2ad781da3fbbb2ccbe3a46dc3f89b499b5d273dd3f12d7c311266fde3fd956a28baed3de3f5bf7dd6af205df3f9377fff069a1de3f0b55d59416a6dd3fbbb2ccbe3a46dc3f68cf4c2ad781da3fcccbb23ca726d83ff0c5084cf066d53fcc9f44026d10d23fc234bb3b4a0fcd3f6f25cd6cac34c53f182d4454fb21b93f503db83b776a9f3fee20ad669e6ba4bf3435fe473946bcbf806a2125532bc7bf6179cce701cfcfbf22c43b555839d4bf4a2b775d63f4d7bf36d119216fafdbbfd956a28baed3debf5a2e26beb2c9e0bf2830f3b44af7e1bfd221337f7cd9e2bffa72376a6a89e3bfa02300761407e4bf22c43b555839e4bf22c43b555839e4bf','4dc4de9d3675c04cae360a1e78f8918d71f463db13dc449d11b1bace9d0bb135');
INSERT INTO trace VALUES(3298534883330,3298534883329,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000d1c7e5367647473848103739f6e8f63910f78a3a19c3093b4410793bb195d13b4871263c9bf87b3c951ab73c4a7a003d17da2e3d7697673d7daf953db646bd3d2b94ea3d93b40e3ee6ae2a3e81e7483e1fef683ecb1c853e9e10963e74f5a63e3d64b73ebfeec63ec122d53e1d8de13eaebbeb3ec041f33e43bbf73eb6cff83eaf35f63e08b7ef3eb134e53e53a8d63ea924c43e41d6ad3e9103943ea7166e3e87c72e3ea65bd63d8bef113de51b10bd0112dabd103935be67517bbe92119fbef64fbebeb7efdabe6c90f4bed67305bf41e00ebf097d16bfc1431cbfd53620bf526022bf1ad122bf','d7dcb20ee5432daba689cd0d9849a0a027f50b09daddf8541918b0a73e711456');
INSERT INTO trace VALUES(3298534883331,3298534883330,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000df40d09def21693f89292cf2826a8f3f503db83b776a9f3f2631214e1ab4aa3fd9a321fc8ba2b33f2631214e1ab4ba3fc85ecd43e5abc13f75a7bbe9bbfdc53f23f0a98f924fca3f58b666ac6aa1ce3f827f2aa9a079d13f5703e61c4870d33f28462ad26702d53ffa886e878794d63fc88a3b7e1fc2d73f15eccc9573bdd83f9acd7f333f54d93f1b6ebb128386d93f1b6ebb128386d93f182d4454fb21d93f934b91b62f8bd83f4a2b775d63f4d73fc2084d0110f9d63f7266442b3499d53f5703e61c4870d33ffa5c004d4d7ed03f1faf32d10aebc93fc85ecd43e5abc13fc41d56855d47b13fa8305cb673d982bffc248a60bdfdb5bf6ae455ae24d0c4bf5375efede23ccebf5703e61c4870d3bf47eaff9edb8fd7bf6b10c4e85ee6dabf0b55d59416a6ddbf6179cce701cfdfbfd98deade6e97e0bffd9d770bd5e2e0bffd9d770bd5e2e0bf98bd4cef4c7ee0bfe0d89008be9cdfbf0b55d59416a6ddbf6f513ba7e64adbbf12ab55d7eb58d8bf28462ad26702d5bf7bfd3b2c91b0d0bf7c29aa66cbc6c6bfe02510799b6bb4bf182d4454fb21993fc85ecd43e5abc13fb57d5db2084cd03f47eaff9edb8fd73f9377fff069a1de3f5081f79f38a7e23fb236e21a56b2e53faf0ba279eb58e83fea6f88091bb4ea3f','dbeaec820e7395155e17a615b3f207c5f182be74a2c0f1c659b1d5c4ef58e26c');
INSERT INTO trace VALUES(3298534883332,3298534883330,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'51a54db9f0cbca381ba9c739eea0353beb362a3c1cc4c43cf2af303d0d58893df789c23d9a08013ef6f5223ee701463e8a1f693e46a4853e76c2953eec78a43ec563b13e012fbc3e3898c43ed06fca3e9799cd3eea0cce3e6bd4cb3e4d0dc73e40e6bf3e049eb63ea496aa3ef78c993ed75a823ec9934b3eb293093ef5a5813d433f46bcde5bb7bdc0a42abefbf476be1f399fbe3294bfbe63b4dbbe91e9f2bea35602bfc35108bf444d0bbfd1440bbff84708bf5b7902bfa01bf4be9396debef20ec5be05fba7beef3a85beb5d635bec975a8bd76cdb93c9b22093e1dfe7d3eb129b93ed66bf13e8223133f9d372b3fb568403f9c4a523f','f8383c22fe1f426f19925d66a61a201f1f61081ddf8be5a84e5a54414ebdd3ea');
INSERT INTO trace VALUES(3298534883333,3298534883331,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',31,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fdf40d09def21893fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f4239db4158d8ad3fd9a321fc8ba2b33f1faf32d10aebb93f32dd21d3c419c03fd9a321fc8ba2c33f83ab98e3da8fc73fb530de412b7dcb3f6179cce701cfcf3fcc9f44026d10d23f22c43b555839d43f78e832a84362d63f12ab55d7eb58d83fe62e114b934fda3f3a1291dff613dc3f','f6d97370b1a91e9b8be4be92322cc4dd59ee3408a3267f809f0ba669f3e105e6');
INSERT INTO trace VALUES(3298534883334,3298534883331,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000cba0d93638c73c383e0d3b3985c9053aedb89b3a67561e3b62c6913b33a6f83ba35a473c01d5973c7064dd3c1f671b3d2afd523dd3fd8a3dd133b23d0ed6de3dca2d083ee309233e35983f3e36685d3e5f007c3e22718d3e27c89c3e39c6ab3ef72dba3e27c6c73e535ad43e','1b020a4ecb3330ab9ef5920092cdd3ed8492af5eb9a7268f3c2411ab4a5e9754');
INSERT INTO trace VALUES(5497558138881,3298534883329,5497558138881,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000d1c7e5367647473848103739f6e8f63910f78a3a19c3093b4410793bb195d13b4871263c9bf87b3c951ab73c4a7a003d17da2e3d7697673d7daf953db646bd3d2b94ea3d93b40e3ee6ae2a3e81e7483e1fef683ecb1c853e9e10963e74f5a63e3d64b73ebfeec63ec122d53e1d8de13eaebbeb3ec041f33e43bbf73eb6cff83eaf35f63e08b7ef3eb134e53e53a8d63ea924c43e41d6ad3e9103943ea7166e3e87c72e3ea65bd63d8bef113de51b10bd0112dabd103935be67517bbe92119fbef64fbebeb7efdabe6c90f4bed67305bf41e00ebf097d16bfc1431cbfd53620bf526022bf1ad122bf','d7dcb20ee5432daba689cd0d9849a0a027f50b09daddf8541918b0a73e711456');
INSERT INTO trace VALUES(5497558138882,3298534883330,5497558138881,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'51a54db9f0cbca381ba9c739eea0353beb362a3c1cc4c43cf2af303d0d58893df789c23d9a08013ef6f5223ee701463e8a1f693e46a4853e76c2953eec78a43ec563b13e012fbc3e3898c43ed06fca3e9799cd3eea0cce3e6bd4cb3e4d0dc73e40e6bf3e049eb63ea496aa3ef78c993ed75a823ec9934b3eb293093ef5a5813d433f46bcde5bb7bdc0a42abefbf476be1f399fbe3294bfbe63b4dbbe91e9f2bea35602bfc35108bf444d0bbfd1440bbff84708bf5b7902bfa01bf4be9396debef20ec5be05fba7beef3a85beb5d635bec975a8bd76cdb93c9b22093e1dfe7d3eb129b93ed66bf13e8223133f9d372b3fb568403f9c4a523f','f8383c22fe1f426f19925d66a61a201f1f61081ddf8be5a84e5a54414ebdd3ea');
INSERT INTO trace VALUES(6597069766657,3298534883329,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000000000000000000000000000a03c32385bf08239e1cc503a11b9f93a1a8c7b3b03c2e13bbe5d3a3c6d4e903c2468d43c22ee153db0594c3d251d873d2700ae3d5ee0da3d32ca063e81db223e7852413e44be613edcc7813e680e933e6152a43e6429b53e7221c53e43c4d33e709ae03e812deb3e820cf33e4acff73eea19f93ebab7f63e827cf03e6044e63e0404d83e2cc9c53ea0bbaf3e761d963e4f93723eed66333ec38bdf3dfc82233d5f0200bdf412d3bdae6332be7d4279be46779ebe0228bebe493adbbe9f48f5bedb0106bfff980fbf3d5717bf59341dbf403121bfd75623bf04b623bf','4d92b0008ce1e082dfc5d5897681c2c45e12d3edf7de4f1dfbb17f2e22593aa7');
INSERT INTO trace VALUES(6597069766658,3298534883330,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'413d8cb9b2492f39169eeb3991e9303b8fc2243ce222bf3c7b282c3d5326863de565be3d2e03fd3d8b03203ed2b1423e6182653e2fb8833ef1c1933e7b6ca23ec652af3e381fba3e798dc23ec56bc83ea79bcb3e4614cc3e9cf8c93ee76ac53ef495be3e2cb4b53ea822aa3ec497993e22e5823ea7984d3ecf6b0c3eedaa883d7b8c06bc26e2aebdd25e26be82dc72be215c9dbebefabdbe656ddabec1fdf1be580f02bfb43608bfb5580bbff06f0bbfc49608bf2cef02bfa855f5be7019e0beb9cfc6be30eaa9be4d4487be43e939be9d1cb0bdf0539f3ceb9d063e73867c3e7811b93e4c0ef23ef2d9133f0f572c3fc8f0413fca36543f','bc8f9d8e999d09c38e40c81130664ed571489c2595fbe08663905e5be0510351');
INSERT INTO trace VALUES(8796093022209,3298534883329,8796093022209,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000d1c7e5367647473848103739f6e8f63910f78a3a19c3093b4410793bb195d13b4871263c9bf87b3c951ab73c4a7a003d17da2e3d7697673d7daf953db646bd3d2b94ea3d93b40e3ee6ae2a3e81e7483e1fef683ecb1c853e9e10963e74f5a63e3d64b73ebfeec63ec122d53e1d8de13eaebbeb3ec041f33e43bbf73eb6cff83eaf35f63e08b7ef3eb134e53e53a8d63ea924c43e41d6ad3e9103943ea7166e3e87c72e3ea65bd63d8bef113de51b10bd0112dabd103935be67517bbe92119fbef64fbebeb7efdabe6c90f4bed67305bf41e00ebf097d16bfc1431cbfd53620bf526022bf1ad122bf','d7dcb20ee5432daba689cd0d9849a0a027f50b09daddf8541918b0a73e711456');
INSERT INTO trace VALUES(8796093022210,3298534883330,8796093022209,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'51a54db9f0cbca381ba9c739eea0353beb362a3c1cc4c43cf2af303d0d58893df789c23d9a08013ef6f5223ee701463e8a1f693e46a4853e76c2953eec78a43ec563b13e012fbc3e3898c43ed06fca3e9799cd3eea0cce3e6bd4cb3e4d0dc73e40e6bf3e049eb63ea496aa3ef78c993ed75a823ec9934b3eb293093ef5a5813d433f46bcde5bb7bdc0a42abefbf476be1f399fbe3294bfbe63b4dbbe91e9f2bea35602bfc35108bf444d0bbfd1440bbff84708bf5b7902bfa01bf4be9396debef20ec5be05fba7beef3a85beb5d635bec975a8bd76cdb93c9b22093e1dfe7d3eb129b93ed66bf13e8223133f9d372b3fb568403f9c4a523f','f8383c22fe1f426f19925d66a61a201f1f61081ddf8be5a84e5a54414ebdd3ea');
INSERT INTO trace VALUES(9895604649985,9895604649985,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000000000000000000000000000000000008000000000000000800000000000000000182d4454fb21693f182d4454fb21893f75a7bbe9bbfd953fd221337f7cd9a23fbbb2ccbe3a46ac3fd221337f7cd9b23faf0ba279eb58b83f8cf510745ad8bd3f4cce9ddcd4e2c03fd221337f7cd9c23fef5326471407c43f','2bc473e180dae2dd4c30840875118384fd914750896ee7054586913dcb213bff');
INSERT INTO trace VALUES(9895604649986,9895604649985,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'8afe5dce2a18b4bfb048716da62991bf9fa2f4dc5642b23f72ede6a9f6d3c53fde3d67b28ae0d03fd536e70c4f6cd53feab8aa900ec4d73f6ebe408e1580d73fb80092d024acd43fb289ffbad28acf3fd33a7a2baf49c33f0482c9293ecdaa3f889388b37a2ca0bf4a8be2d9102cb6bf4ab86883606bbabf4ab86883606bbabf','00138b9a0bc7786d23a1699327d8207a7de244f67ea6e8a5bb208c9fbc60b38e');
INSERT INTO trace VALUES(9895604649987,9895604649985,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bfd34d9226b4bf103f00000000000000001220af839999c9bf5cd5ad76bb5e263f0000000000000000ac1138fd9899c9bf55411d2860bc243f000000000000000016953b139999c9bf1c83170931ea1abf0000000000000000557501619999c9bfe8115a14afaf4bbf000000000000000043bdefa08a99c9bfce409eb5798062bf000000000000000016be3a9f2e99c9bf033f9a9b403472bf0000000000000000771ed14ffb97c9bf0ab7b33216467ebf0000000000000000f209e9941f95c9bfb7fa0cae0c7886bf0000000000000000a453596ebb8fc9bf5f2eb3451ca28ebf00000000000000004d70e40a3f87c9bfc793daad008493bf0000000000000000a1c75b07c77bc9bfd0436a27498397bf000000000000000004748eda436ec9bf3c11c1a154059bbf00000000000000007885cdfe4e60c9bf70d4d04600d49dbf00000000000000001287c5dfb753c9bf9a249d4181d49fbf000000000000000046f994a1f649c9bf','a74e67eca962095428ff5010e9b196c9e30dc9c4eb85d0b9d725a34b9c492e70');
INSERT INTO trace VALUES(10995116277761,10995116277761,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000008000000000000000800000000000000000182d4454fb21693f182d4454fb21793f5e3855297a6a8f3f182d4454fb21993f5e3855297a6a9f3fa46477349c6ba43f75a7bbe9bbfda53f75a7bbe9bbfda53fa46477349c6ba43f00dfeec95c47a13fbbb2ccbe3a469c3f75a7bbe9bbfd953fd221337f7cd9923f','0975e3a7dda3b0d37d5eb15fe61a744bf33d0cdb3f4d3bad4891c06bfc071812');
INSERT INTO trace VALUES(10995116277762,10995116277761,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000fb7e6abc7493b83ffb7e6abc7493c83f3bdf4f8d976ed23fd6cef753e3a5cb3fb61e85eb51b8be3f007f6abc7493983f40df4f8d976eb2bf1b2fdd240681c5bf4b37894160e5d0bfb61e85eb51b8cebf40df4f8d976ec2bf007f6abc7493a8bf007f6abc7493a83f40df4f8d976ec23f40df4f8d976ec23f','918dd5350a1f18fbddf009cb1aeb7a7f9d3b855209d768e631f4cceb3388ddf2');
INSERT INTO trace VALUES(10995116277763,10995116277761,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf000000000000000000000000000000009a9999999999c9bf62c757d1d8b216bf00000000000000003e0d59719999c9bfc4753a6c92b23ebf00000000000000001a96acff9499c9bffbbdd68e88a856bf000000000000000040bc797d7199c9bfffbf3a13cc3467bf000000000000000045b3134df198c9bf1fab7bbe1daf72bf0000000000000000d0fb1a2de597c9bf70e14c344fbf79bf0000000000000000291ca4bd5c96c9bfa86c003ecdab7fbf00000000000000001a06d14eb394c9bf2f3b2c5159b181bf0000000000000000ee02e7b27b93c9bf836ec53d47f681bf00000000000000002f10eea64b93c9bf88b6f3e865bd80bf000000000000000056c463e71f94c9bf3f83000d63f17cbf0000000000000000b90d4d288295c9bf87a5a81d317877bf00000000000000006501d9efe896c9bf04032d4ce83072bf000000000000000063aa07e8fb97c9bf8cca91bff8666cbf000000000000000037a2cd7d9d98c9bf','264ffbb84f2733029b02d111f32733edba94a29406d23cadbf1f980fa7c0a393');
CREATE TABLE robot_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO robot_file VALUES(1,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
INSERT INTO robot_file VALUES(2,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
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
INSERT INTO diagnosis VALUES(4398046511105,3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 7a97ef6bdadc69be886b9bdc90357718f27ce179 918581ee4dec9eded16ce2005c7a02d5e513648d76b33a7ed1631ad2bf337421 7f3ff28d0cd3930dac3419e7c2c847495deb8a2424ccface0c37ac771b1b62d5 diagnosis segments 0 among [coulomb_friction,joint_offset_torque] process joint.hinge 0.0005 0.02 0948cd4e2034f1c07cbde5a3ed0c5323463e58cfea8774b48dd1e7ed4621054c 616d21c3ead47ee69f2135e10e246d76cc5151794a27b7efdaa75eaec1d48618 e7a3d9dac5139e8ef76b019fa79904babd03aa3aecf39397d7db3f2ee0cb135f d9af0baf9af9196c4a5a5e1af8e25b3495f53254afd650e3040385be63566fca bf5f6071352973b8bab0e9e4caf2db9026c4a5a72b4e729d5432a251121ef98c 7a6a27ac6c5329db2ddcaa560d9ec4e7603e800d0d5648c71b11e36be9e16e54 40753ab64c53486896d047f2be5ecc5177f5e5ff62c729810521836a7bf67abf 6af5fc9bee13d1ebccad63f23f65a546f54cfa021ac22a2687c43a0d671f465d 168eae2dd8e3cc124d77dca7930921840e2dfbb44f442d9a99a92665bc8efc55 5dd6710510e5e9e46226ce88719680041eccb2f7c747c071d036a272b4579bd3','effect_found',0.87056325909203613466,1,0.0005000000000000000104,2,10.891672021713436179,replace('{\n  "verdict": "effect_found",\n  "probability": 0.8705632590920361,\n  "calibrated": true,\n  "at_threshold": [],\n  "evidence": {\n    "further_effects": 1.0,\n    "log_base_error": 1.0370945550600832,\n    "log_error": 0.5345306783995954,\n    "log_gain": 2.85386687414552,\n    "log_lead": 2.92341994343349,\n    "look_alikes": 0.0,\n    "structure": 0.4377071355435253,\n    "sureness": 3.608700827764734,\n    "surprise": 3.3010299956639813,\n    "unsteady": 0.0\n  },\n  "noise_floor": {\n    "angle": 0.0010388761108689913\n  },\n  "units": {\n    "angle": "rad"\n  },\n  "random_forces": [\n    {\n      "joint": "joint.hinge",\n      "deviation": 0.0018702013517488477,\n      "unit": "N*m",\n      "duration_s": 0.025\n    },\n    {\n      "joint": "joint.hinge",\n      "deviation": 0.0006606299587136061,\n      "unit": "N*m",\n      "duration_s": 0.25\n    }\n  ],\n  "base": {\n    "fit_rmse": {\n      "angle": 0.006143257116975041\n    },\n    "cv_rmse": {\n      "angle": 0.011315097870778258\n    },\n    "ratio_to_floor": 10.891672021713436,\n    "segment_s": 1.83\n  },\n  "ranking": [\n    {\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.022557801694957896,\n              "ci95": [\n                0.01956833142776276,\n                0.02554727196215303\n              ],\n              "unit": "N*m"\n            }\n          }\n        },\n        {\n          "effect": "joint_offset_torque",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.0028334229128082825,\n              "ci95": [\n                0.0007377768792234595,\n                0.004929068946393105\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "class": [],\n      "noise_floor": {\n        "angle": 0.0010388761108689913\n      },\n      "fit_rmse": {\n        "angle": 0.002287516970170896\n      },\n      "cv_rmse": {\n        "angle": 0.0035570865964148057\n      },\n      "ratio_to_floor": 3.423975736085991,\n      "segment_s": 1.83,\n      "gain": 837.339527336544,\n      "gain_ci95": [\n        273.6125241733117,\n        1401.0665304997765\n      ],\n      "gain_standard_error": 287.6211030456881,\n      "probability": 1.0\n    }\n  ],\n  "values": {\n    "body.arm.mass": {\n      "value": 0.54938202967115,\n      "ci95": [\n        0.5448861500804915,\n        0.5538779092618086\n      ],\n      "unit": "kg"\n    },\n    "joint.hinge.damping": {\n      "value": 0.01937574700443235,\n      "ci95": [\n        0.016588195873090707,\n        0.02216329813577399\n      ],\n      "unit": "N*m*s/rad"\n    },\n    "joint.hinge.damping@steps": {\n      "value": 0.01990901854343427,\n      "ci95": [\n        0.01842699329929158,\n        0.02139104378757696\n      ],\n      "unit": "N*m*s/rad"\n    }\n  },\n  "segment_lengths": [\n    {\n      "segment_s": 0.1,\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.011203813526362174,\n              "ci95": [\n                0.0,\n                0.03769378116984432\n              ],\n              "unit": "N*m"\n            }\n          }\n        },\n        {\n          "effect": "joint_offset_torque",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": -0.00614411290835983,\n              "ci95": [\n                -0.021664477208503424,\n                0.009376251391783762\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "against": 1.4860930887569013\n    },\n    {\n      "segment_s": 0.5,\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.026127626510136774,\n              "ci95": [\n                0.023561269869153113,\n                0.028693983151120435\n              ],\n              "unit": "N*m"\n            }\n          }\n        },\n        {\n          "effect": "joint_offset_torque",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.003788928587987747,\n              "ci95": [\n                0.002731900344585002,\n                0.004845956831390492\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "against": 9.309987218365363\n    }\n  ],\n  "p_by_chance": 0.0005,\n  "chance_95": 2.2000067896172677,\n  "free_force": {\n    "p": 0.365,\n    "gain": {\n      "value": -0.14845633201154484,\n      "standard_error": 0.09385986121833788,\n      "ci95": [\n        -0.32841940222868793,\n        0.0004613300703777412\n      ]\n    }\n  },\n  "answer_gain": {\n    "value": 714.2773425033929,\n    "standard_error": 197.93199175943425,\n    "ci95": [\n      416.0836160339198,\n      1082.6648895341607\n    ]\n  },\n  "formulas": [],\n  "formulas_of_rest": true,\n  "residual_force": [],\n  "hypotheses": 2,\n  "findings": [\n    "what is left depends on no joint''s position, velocity or command",\n    "body.arm.mass (0.567 kg → 0.549 kg), joint.hinge.damping (30.9 mN*m*s/rad → 19.4 mN*m*s/rad), joint.hinge.damping@steps (26.7 mN*m*s/rad → 19.9 mN*m*s/rad) had soaked it up",\n    "commands act 15.1 ms earlier than recorded: a matter of recording, which this fit allows for; compare and trial do not, unless the times of commands are shifted by as much",\n    "over segments of other lengths, coulomb_friction @ joint.hinge: torque 0.0112 at 0.1 s, 0.0261 at 0.5 s, 0.0226 at 1.83 s (N*m): they agree within what is uncertain of them",\n    "over segments of other lengths, joint_offset_torque @ joint.hinge: torque -0.00614 at 0.1 s, 0.00379 at 0.5 s, 0.00283 at 1.83 s (N*m): they agree within what is uncertain of them"\n  ],\n  "next_test": "",\n  "next_test_worth": "",\n  "not_testable": [],\n  "seconds": 0.889067162\n}\n','\n',char(10)));
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
INSERT INTO candidate_model VALUES(4398046511105,1,'["coulomb_friction @ joint.hinge","joint_offset_torque @ joint.hinge"]','[]',837.33952733654405161,273.61252417331172637,1401.0665304997764905,3.4239757360859908175,1.0);
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
INSERT INTO candidate_value VALUES(4398046511105,1,0,'coulomb_friction','joint.hinge','torque','N*m',0.022557801694957895638,0.019568331427762760549,0.025547271962153030727);
INSERT INTO candidate_value VALUES(4398046511105,1,1,'joint_offset_torque','joint.hinge','torque','N*m',0.0028334229128082824566,0.00073777687922345954601,0.0049290689463931053673);
CREATE TABLE unfinished_diagnosis (
  revision INTEGER NOT NULL REFERENCES revision (id),
  settings TEXT NOT NULL,
  document TEXT NOT NULL CHECK (json_valid(document)),
  PRIMARY KEY (revision, settings)
) STRICT, WITHOUT ROWID;
CREATE TABLE failed_trial (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES run (number),
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  trial TEXT NOT NULL,
  test TEXT NOT NULL,
  failed TEXT NOT NULL,
  reason TEXT NOT NULL
) STRICT;
INSERT INTO failed_trial VALUES(2199023255553,2,2199023255553,'1','4','2026-11-28T12:00:32Z','target "process" (/srv/lacuna/lib/lacuna/plugins/process.so): "python3 pendulum.py" says: the motor is hot');
CREATE TABLE where_it_fails (
  comparison INTEGER PRIMARY KEY REFERENCES comparison (id),
  document TEXT NOT NULL CHECK (json_valid(document))
) STRICT;
INSERT INTO where_it_fails VALUES(3298534883329,'{"findings":[{"kind":"trial","share":0.9818204982355369,"sentence":"98 % of squared error in steps.csv, 50 % of samples","view":"free_run","trial":"steps.csv","share_of_samples":0.5,"stretches":[{"trial":"steps.csv","spans":[[0.0,1.83]]}]}],"where":{"samples":116,"features":[{"name":"position","of":"","unit":"rad"},{"name":"velocity","of":"","unit":"rad/s"},{"name":"|velocity|","of":"","unit":"rad/s"},{"name":"direction of motion","of":"","unit":"1"},{"name":"time since the last reversal","of":"","unit":"s"},{"name":"command","of":"","unit":"N*m"},{"name":"time","of":"","unit":"s"},{"name":"load","of":"","unit":"N*m"},{"name":"accumulated work","of":"","unit":"J"}],"whiteness":[{"channel":"angle","lags_s":[0.03,0.06,0.09,0.12,0.15,0.18,0.21,0.24,0.27,0.3,0.32999999999999996,0.36,0.39,0.42],"autocorrelation":[0.961631940113574,0.9120065688913237,0.8408452844190456,0.7583507694159217,0.6729080824953994,0.5875986319568797,0.5072239767054091,0.4405361563621319,0.3882157649361581,0.3444074123380523,0.31968507639543897,0.30471990836968776,0.3006220888674986,0.29761433176832236],"band99":0.2391570260382251,"share_outside":1.0,"ljung_box":605.6095941547585,"degrees_of_freedom":14,"p":3.4029377369417864e-120}],"views":[{"view":"free_run","horizon_s":null,"times_floor":6.076861982179576,"channels":[{"channel":"angle","unit":"rad","share_of_error":1.0,"mean":{"testable":true,"share":0.0018412045982195112,"statistic":0.018683046723388615,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":0.8957501252075863,"bins":[]},"independence":[{"name":"position","of":"","unit":"rad","testable":true,"share":0.14922518526177267,"statistic":0.8486298415381954,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.6360031414554411,"to":-0.5152714939155502,"feature":-0.5693165416213163,"mean":0.005638071918310299,"band99":0.018271167746083797,"samples":11},{"from":-0.4962792947275735,"to":-0.36669444046444294,"feature":-0.43551552194496385,"mean":0.00623080554751088,"band99":0.013296905040182687,"samples":11},{"from":-0.32724924306002845,"to":-0.08604906220208375,"feature":-0.21745022436334324,"mean":0.0002137735922500209,"band99":0.008527358711984283,"samples":11},{"from":-0.08093572122596601,"to":0.006396018358625154,"feature":-0.010061768092685703,"mean":-0.0012158321673962319,"band99":0.002565033629099316,"samples":11},{"from":0.010158843837551702,"to":0.056540928521116654,"feature":0.030661006715027635,"mean":-0.005148320635815885,"band99":0.017879281748613033,"samples":11},{"from":0.06691081220008167,"to":0.13936071488200552,"feature":0.10790024038796227,"mean":-0.003010406838660449,"band99":0.02161572957671585,"samples":11},{"from":0.16668281127617926,"to":0.25785486888981723,"feature":0.21130084055898765,"mean":-0.00044229548543053577,"band99":0.019563585599478073,"samples":11},{"from":0.25998529936078835,"to":0.352377255277583,"feature":0.3094352089031096,"mean":0.0005938980520119345,"band99":0.01724239991240782,"samples":11},{"from":0.35818663091979064,"to":0.3953287526605206,"feature":0.37842892798423183,"mean":-0.000803789135745394,"band99":0.004718373917515994,"samples":11},{"from":0.39795842362231715,"to":0.48087831161017036,"feature":0.4440547204063427,"mean":-0.0016430616826780518,"band99":0.004632751962235059,"samples":11},{"from":0.4838505752908916,"to":0.836092581296292,"feature":0.6372664966064072,"mean":0.0060405788929295545,"band99":0.016086966587011163,"samples":6}],"depends":false},{"name":"velocity","of":"","unit":"rad/s","testable":true,"share":0.04622048653305426,"statistic":0.6775626593088662,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-2.483588357845621,"to":-2.2327412549185404,"feature":-2.358484443077677,"mean":-0.000684386602292911,"band99":0.010880971297652836,"samples":11},{"from":-2.187748816313826,"to":-1.6362461737446832,"feature":-1.9531521153120766,"mean":-0.0005851758677065037,"band99":0.011842646508544498,"samples":11},{"from":-1.58146091185646,"to":-0.8911703105006026,"feature":-1.2734462649922742,"mean":0.0012396352371372456,"band99":0.014628109099183984,"samples":11},{"from":-0.8706654221364061,"to":-0.20818266540059235,"feature":-0.5313595919345956,"mean":-0.0008492631195465636,"band99":0.007911656900254952,"samples":11},{"from":-0.1669805121820666,"to":0.05161304462683467,"feature":-0.028477421941821304,"mean":0.0012774643204284848,"band99":0.008914708774593293,"samples":11},{"from":0.062089880362406945,"to":0.3907999972507205,"feature":0.19764333860330643,"mean":-0.0034766979138609816,"band99":0.012441324533325361,"samples":11},{"from":0.3962483498478286,"to":0.6893724415409938,"feature":0.5415321121532858,"mean":-0.0026924896885527766,"band99":0.01872072703194545,"samples":11},{"from":0.7415166824783639,"to":0.9736351543600293,"feature":0.8532713510506752,"mean":4.1508007431217964e-05,"band99":0.019412754603054916,"samples":11},{"from":0.9824782492051449,"to":1.1055684775719516,"feature":1.0589044291895346,"mean":-0.00016796570987756272,"band99":0.026669792005240764,"samples":11},{"from":1.113962005072262,"to":3.2432740813699352,"feature":2.195717547679464,"mean":0.006998232124455234,"band99":0.0039223503144850515,"samples":11},{"from":3.2724921397120768,"to":3.7217292925335315,"feature":3.5604179636384763,"mean":0.0047792132502893474,"band99":0.0014190200925713037,"samples":6}],"depends":false},{"name":"|velocity|","of":"","unit":"rad/s","testable":true,"share":0.033198908906000996,"statistic":0.30850752587658,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.0004536914816391428,"to":0.0803514265478565,"feature":0.036339041020262725,"mean":-0.0010196448393054254,"band99":0.0024139769239851765,"samples":11},{"from":0.10321698341308011,"to":0.29230787051411117,"feature":0.19525369125260575,"mean":-0.0009353036280093217,"band99":0.01698907980984212,"samples":11},{"from":0.33593578003236046,"to":0.5295889949238931,"feature":0.4326460456124226,"mean":-0.001055007241825248,"band99":0.01641885871105637,"samples":11},{"from":0.5405459226351635,"to":0.7487287958130472,"feature":0.6431489663396641,"mean":-0.0011528577780814757,"band99":0.013583720748369306,"samples":11},{"from":0.7815328205639362,"to":0.9479816101616105,"feature":0.8634389884145564,"mean":-0.00025468761108893767,"band99":0.019306794132382874,"samples":11},{"from":0.9736351543600293,"to":1.089324471614403,"feature":1.0346719552305372,"mean":0.0001803204580388308,"band99":0.020883927498279074,"samples":11},{"from":1.0967849177706155,"to":1.4024965125752946,"feature":1.206841366358761,"mean":0.0027290891866190562,"band99":0.012613608170256934,"samples":11},{"from":1.5626122678708478,"to":1.9768090171443216,"feature":1.7613826117967322,"mean":-0.00026690986553459806,"band99":0.01164825856685857,"samples":11},{"from":2.103745288306169,"to":2.363061529689776,"feature":2.2244639349931936,"mean":-0.0008166586875799735,"band99":0.011060324098413475,"samples":11},{"from":2.368378832137663,"to":3.2432740813699352,"feature":2.6198417358590245,"mean":0.003692520794381977,"band99":0.011609493660746898,"samples":11},{"from":3.2724921397120768,"to":3.7217292925335315,"feature":3.5604179636384763,"mean":0.0047792132502893474,"band99":0.0014190200925713037,"samples":6}],"depends":false},{"name":"direction of motion","of":"","unit":"1","testable":true,"share":0.0008766321574000499,"statistic":0.008450498714007871,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":1.0,"bins":[{"from":-1.0,"to":-1.0,"feature":-1.0000000000000007,"mean":8.83372724146012e-05,"band99":0.010834813589158962,"samples":48},{"from":0.0,"to":0.0,"feature":0.0,"mean":-0.00017497158490313575,"band99":3.0106037027550144e-05,"samples":4},{"from":1.0,"to":1.0,"feature":1.0,"mean":0.0005819444598314288,"band99":0.015193571349205194,"samples":64}],"depends":false},{"name":"time since the last reversal","of":"","unit":"s","testable":true,"share":0.043866885145769564,"statistic":0.3665395453346356,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.0,"to":0.030000000000000027,"feature":0.013636363636363643,"mean":0.003300756066199782,"band99":0.014300785958864436,"samples":11},{"from":0.05999999999999994,"to":0.11999999999999988,"feature":0.08249999999999996,"mean":0.002821544388754162,"band99":0.01592936665816453,"samples":12},{"from":0.12,"to":0.18,"feature":0.15249999999999997,"mean":0.002255108820097439,"band99":0.012653797422232676,"samples":12},{"from":0.18000000000000005,"to":0.24,"feature":0.22090909090909092,"mean":0.0007011180302177796,"band99":0.011935180604062701,"samples":11},{"from":0.27,"to":0.32999999999999985,"feature":0.2890909090909091,"mean":-0.0003035510496322273,"band99":0.013111697311998632,"samples":11},{"from":0.32999999999999996,"to":0.3899999999999999,"feature":0.3545454545454545,"mean":4.147206011178911e-05,"band99":0.0127352763004893,"samples":11},{"from":0.39,"to":0.44999999999999996,"feature":0.42249999999999993,"mean":-0.0024639659397890055,"band99":0.017448509467682016,"samples":12},{"from":0.45000000000000007,"to":0.5399999999999999,"feature":0.49363636363636365,"mean":0.0007336011698330081,"band99":0.016318870646164566,"samples":11},{"from":0.54,"to":0.63,"feature":0.585,"mean":-0.0013112698958362722,"band99":0.02189089198308684,"samples":12},{"from":0.6599999999999999,"to":0.9,"feature":0.7569230769230768,"mean":-0.0018492014890190407,"band99":0.003869542115435586,"samples":13}],"depends":false},{"name":"command","of":"","unit":"N*m","testable":true,"share":0.019045467245481857,"statistic":0.08197227085200047,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.4125,"to":-0.247,"feature":-0.3446363636363636,"mean":-0.0016905754226062301,"band99":0.003121111362562261,"samples":11},{"from":-0.2205,"to":-0.15,"feature":-0.15512000000000006,"mean":0.006954628392139535,"band99":0.009656980058944066,"samples":25},{"from":-0.135,"to":0.021,"feature":-0.03795454545454547,"mean":-0.002701737768589876,"band99":0.007736484044519798,"samples":11},{"from":0.022,"to":0.1155,"feature":0.07345454545454545,"mean":-0.0051356209224158655,"band99":0.0037805912294058067,"samples":11},{"from":0.1375,"to":0.25,"feature":0.23071666666666663,"mean":0.000607873703478675,"band99":0.015687094904628208,"samples":30},{"from":0.2535,"to":0.329,"feature":0.29409090909090907,"mean":-0.007297954400156778,"band99":0.010449263385926322,"samples":11},{"from":0.334,"to":0.35,"feature":0.34705882352941175,"mean":0.0019863294652416146,"band99":0.017652940634639607,"samples":17}],"depends":false},{"name":"time","of":"","unit":"s","testable":true,"share":0.0658437269306652,"statistic":0.4175464351352452,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.12,"to":0.27,"feature":0.19499999999999998,"mean":0.003981176986698941,"band99":0.015609318000682632,"samples":12},{"from":0.3,"to":0.45,"feature":0.37499999999999994,"mean":0.0011792533660742346,"band99":0.02588801052586916,"samples":12},{"from":0.48,"to":0.63,"feature":0.5549999999999999,"mean":-0.007894223076847206,"band99":0.023915649286039994,"samples":12},{"from":0.66,"to":0.81,"feature":0.7349999999999999,"mean":-0.005944507649433219,"band99":0.017343930051429323,"samples":12},{"from":0.84,"to":0.99,"feature":0.9149999999999999,"mean":0.001101067289871887,"band99":0.006610659883508452,"samples":12},{"from":1.02,"to":1.17,"feature":1.095,"mean":0.0017217844888349119,"band99":0.014963695005460393,"samples":12},{"from":1.2,"to":1.35,"feature":1.2750000000000001,"mean":0.004742128400141018,"band99":0.031049423340548266,"samples":12},{"from":1.38,"to":1.53,"feature":1.4549999999999998,"mean":-7.493626394984453e-05,"band99":0.011037383823237455,"samples":12},{"from":1.56,"to":1.71,"feature":1.635,"mean":0.0007713405054476086,"band99":0.012078771299798773,"samples":12},{"from":1.74,"to":1.83,"feature":1.7850000000000001,"mean":0.005723467450429981,"band99":0.014751094857276787,"samples":8}],"depends":false},{"name":"load","of":"","unit":"N*m","testable":true,"share":0.030278609223060252,"statistic":0.13669613681529055,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.40616369016817927,"to":-0.19016676405151373,"feature":-0.2997327732898104,"mean":-0.0008022612199593245,"band99":0.0032605295084037044,"samples":11},{"from":-0.18458476554897957,"to":-0.12663064006539154,"feature":-0.154363078263292,"mean":0.00952758010858667,"band99":0.013630934108343023,"samples":11},{"from":-0.12091670308842287,"to":-0.0940697832707377,"feature":-0.10514407231700194,"mean":0.004787634880725058,"band99":0.005262220126363705,"samples":11},{"from":-0.09145783570211888,"to":0.013845056385307822,"feature":-0.03327538840393598,"mean":-0.00043736171377125335,"band99":0.005714109562627135,"samples":11},{"from":0.018778573061661905,"to":0.10663173513541122,"feature":0.059487157543843226,"mean":-0.007141885592839504,"band99":0.00322155202369363,"samples":11},{"from":0.12572654267155642,"to":0.21656337866497258,"feature":0.1666662547971339,"mean":-0.009745417741872564,"band99":0.01601428398527752,"samples":11},{"from":0.22366389225108255,"to":0.23181099781631967,"feature":0.22707476673817287,"mean":0.007954865135361812,"band99":0.01067329502176783,"samples":11},{"from":0.23389979215373083,"to":0.25084122837860306,"feature":0.24185646512345968,"mean":0.00015943091329412388,"band99":0.00910904769005862,"samples":11},{"from":0.2547868661557611,"to":0.2674791153442054,"feature":0.26246348971954486,"mean":7.814656761052647e-05,"band99":0.012543651293585804,"samples":11},{"from":0.27274698945412085,"to":0.300472988762563,"feature":0.28512323661402644,"mean":0.0014175002215585728,"band99":0.020635410180253375,"samples":11},{"from":0.30404095576350476,"to":0.3163480308016269,"feature":0.3116204753421591,"mean":-0.003832633163355914,"band99":0.0018769671774645686,"samples":6}],"depends":false},{"name":"accumulated work","of":"","unit":"J","testable":true,"share":0.14087194773319675,"statistic":0.8228842891213989,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.0,"to":0.0006931448966383741,"feature":0.00012158668872100188,"mean":-0.0023129029546775553,"band99":0.0031938392031698195,"samples":11},{"from":0.0012534543894171617,"to":0.020458303810910166,"feature":0.008559150720792146,"mean":-0.006929466760454243,"band99":0.026649840685003867,"samples":11},{"from":0.021327382725749428,"to":0.0630644939138009,"feature":0.041379514450464644,"mean":-5.257855877457691e-05,"band99":0.032237210144996975,"samples":11},{"from":0.06321702044039185,"to":0.08670729333006931,"feature":0.07863387519160701,"mean":-0.0010793621961919242,"band99":0.008359873784946698,"samples":11},{"from":0.08880593576605646,"to":0.11695656330380759,"feature":0.10297431427088888,"mean":0.00075886466239768,"band99":0.003224254572575289,"samples":11},{"from":0.11958525099015554,"to":0.14215341804132564,"feature":0.12864912024089656,"mean":-0.001462417753189041,"band99":0.0068468368465364506,"samples":11},{"from":0.14327661300708724,"to":0.16724361211609143,"feature":0.1575203108748854,"mean":-0.0017026229861630802,"band99":0.013102275162164738,"samples":11},{"from":0.1690100311989622,"to":0.1900165476204505,"feature":0.18106704757581935,"mean":0.008252259632020927,"band99":0.017545455620198446,"samples":11},{"from":0.19340618730298398,"to":0.24053762157922412,"feature":0.21453794775886817,"mean":0.0019116372235682313,"band99":0.012928075064283461,"samples":11},{"from":0.2512518105909246,"to":0.3706468008858738,"feature":0.2889520170942729,"mean":0.0014851103316815637,"band99":0.004126880602889147,"samples":11},{"from":0.3997741947089819,"to":0.5279137155656716,"feature":0.46637481167316414,"mean":0.008871836853850337,"band99":0.0006702311107144022,"samples":6}],"depends":false}],"selected":[],"not_on":["position","velocity","|velocity|","direction of motion","time since the last reversal","command","time","load","accumulated work"]}],"tree":[{"parent":-1,"share_of_error":1.0,"share_of_samples":1.0}],"regimes":[]},{"view":"acceleration","horizon_s":null,"times_floor":3.8811448428583915,"channels":[{"channel":"angle","unit":"rad/s^2","share_of_error":1.0,"mean":{"testable":true,"share":0.001853892889491011,"statistic":0.25049895360478075,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":0.6345491295855435,"bins":[]},"independence":[{"name":"position","of":"","unit":"rad","testable":true,"share":0.023041642962359932,"statistic":1.5135155435260026,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.5878453811486062,"to":-0.47766434021134596,"feature":-0.522398261331876,"mean":-0.13263639904240737,"band99":0.619708638951581,"samples":10},{"from":-0.4639926483611306,"to":-0.310680936494115,"feature":-0.3960569393446689,"mean":0.29929552241666857,"band99":0.5471428117408571,"samples":10},{"from":-0.30489693599611223,"to":-0.08093572122596601,"feature":-0.18349580096685988,"mean":0.3762722424807479,"band99":1.1406368251886239,"samples":10},{"from":-0.03518285138869377,"to":0.025566380748013894,"feature":0.004301224953871331,"mean":-0.2135575881470984,"band99":0.7338184517739381,"samples":10},{"from":0.03136662311426066,"to":0.11454042125360768,"feature":0.07234772559867633,"mean":-0.038922208747639436,"band99":0.4539441774409618,"samples":10},{"from":0.13747389208179517,"to":0.20584561966562126,"feature":0.16660652303236584,"mean":-0.02694488057637085,"band99":0.2938736541104817,"samples":10},{"from":0.22747468129565476,"to":0.30270550058730816,"feature":0.2628681543402332,"mean":-0.1500131282801086,"band99":0.13933536924487638,"samples":10},{"from":0.3027055587649498,"to":0.3715155219017684,"feature":0.34436943899585654,"mean":-0.1994572091527938,"band99":0.4422905443740583,"samples":10},{"from":0.37429135172178185,"to":0.41628077841752364,"feature":0.3919129451456809,"mean":0.27230762983552337,"band99":1.0848255188576528,"samples":10},{"from":0.4192529649666109,"to":0.48595970499136415,"feature":0.46407536553950324,"mean":-0.18634398078652123,"band99":0.9384634949234736,"samples":10}],"depends":false},{"name":"velocity","of":"","unit":"rad/s","testable":true,"share":0.07523931596379446,"statistic":2.260207253213924,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-2.483588357845621,"to":-2.2555859079621485,"feature":-2.371058761893591,"mean":0.0956110706719837,"band99":1.1076852305933564,"samples":10},{"from":-2.2327412549185404,"to":-1.7860246570107545,"feature":-2.0313038959743372,"mean":0.04221075315587518,"band99":0.7824288257378852,"samples":10},{"from":-1.7681293898633297,"to":-1.108779175846622,"feature":-1.4455947855450577,"mean":0.0782544323626155,"band99":0.5570499808330422,"samples":10},{"from":-1.0753832371152334,"to":-0.3360143198079106,"feature":-0.7273314529875523,"mean":0.08734980319025455,"band99":0.1756908154645423,"samples":10},{"from":-0.29230787051411117,"to":0.10321698341308011,"feature":-0.04861614066892361,"mean":0.02579440638207286,"band99":1.3993249969960269,"samples":10},{"from":0.14688113418888704,"to":0.41677431227013956,"feature":0.2752505849337059,"mean":-0.2693797408107162,"band99":0.4662764901981248,"samples":10},{"from":0.5042267872515835,"to":0.8181230868723416,"feature":0.6462349718446974,"mean":-0.22644301004870782,"band99":0.562563132416736,"samples":10},{"from":0.829080430138198,"to":1.0458184669374389,"feature":0.9477924413515171,"mean":-0.2608893924182926,"band99":0.4967781163769912,"samples":10},{"from":1.0555250572788215,"to":1.4024965125752946,"feature":1.1219968479230782,"mean":-0.1240131857512343,"band99":0.4124326060087922,"samples":10},{"from":1.72755452800381,"to":3.7217292925335315,"feature":3.0606568949639152,"mean":0.5515048632661494,"band99":0.6533927583623714,"samples":10}],"depends":false},{"name":"|velocity|","of":"","unit":"rad/s","testable":true,"share":0.10793314296261378,"statistic":1.1203660411074707,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.02565532550806823,"to":0.18600373771775794,"feature":0.09261931898615736,"mean":-0.16060302148487032,"band99":1.513893013328286,"samples":10},{"from":0.19357363622952373,"to":0.3962483498478286,"feature":0.28393515208828884,"mean":-0.05418804194863559,"band99":1.240338714909138,"samples":10},{"from":0.41677431227013956,"to":0.6866393310052249,"feature":0.5429130655978454,"mean":-0.18170056602199922,"band99":0.555476103152885,"samples":10},{"from":0.6893724415409938,"to":0.87215660380476,"feature":0.8001170235504634,"mean":-0.21697469399997066,"band99":0.44152748172135814,"samples":10},{"from":0.8911703105006026,"to":1.0555250572788215,"feature":0.9844189582980396,"mean":-0.13240657235268727,"band99":0.36023991284283813,"samples":10},{"from":1.0655531436726136,"to":1.1139626284041384,"feature":1.094610932233852,"mean":-0.10423660609703037,"band99":0.4183986303457762,"samples":10},{"from":1.2490991090629309,"to":1.72755452800381,"feature":1.4709090330319727,"mean":0.25985398619732253,"band99":0.6846825561683193,"samples":10},{"from":1.7681293898633297,"to":2.1348246663075168,"feature":1.9764423566680502,"mean":0.11264565185448297,"band99":0.8292684611050818,"samples":10},{"from":2.187748816313826,"to":2.4361077144315733,"feature":2.3182162520662484,"mean":-0.004093637861202475,"band99":0.9701920408869587,"samples":10},{"from":2.465326811660171,"to":3.7217292925335315,"feature":3.1724184302834963,"mean":0.48170350171459014,"band99":0.9208127137868644,"samples":10}],"depends":false},{"name":"direction of motion","of":"","unit":"1","testable":true,"share":0.25954264439159996,"statistic":20.314731556933626,"band99":30.551624999578195,"degrees_of_freedom":[1,8],"p":0.03569702574747789,"bins":[{"from":-1.0,"to":-1.0,"feature":-1.0000000000000004,"mean":0.5187695377217697,"band99":0.5333208054985661,"samples":45},{"from":1.0,"to":1.0,"feature":1.0000000000000002,"mean":-0.4244478035905387,"band99":0.41070500077572336,"samples":55}],"depends":false},{"name":"time since the last reversal","of":"","unit":"s","testable":true,"share":0.08579029710203447,"statistic":2.173504593141551,"band99":33.4932119734404,"degrees_of_freedom":[2,6],"p":1.0,"bins":[{"from":0.0,"to":0.08999999999999986,"feature":0.040909090909090895,"mean":0.07599668717043695,"band99":1.602345985804745,"samples":11},{"from":0.08999999999999997,"to":0.15000000000000002,"feature":0.13090909090909086,"mean":0.08242258105787878,"band99":0.75285555742165,"samples":11},{"from":0.17999999999999994,"to":0.21000000000000002,"feature":0.19499999999999995,"mean":0.05789016246452432,"band99":0.724816568269993,"samples":10},{"from":0.24,"to":0.27,"feature":0.255,"mean":0.09585538759171036,"band99":0.5545793272474555,"samples":10},{"from":0.3,"to":0.33000000000000007,"feature":0.31500000000000006,"mean":0.015058357419679112,"band99":0.4120919928243939,"samples":10},{"from":0.3599999999999999,"to":0.39,"feature":0.3749999999999999,"mean":0.07978287599784999,"band99":0.43713232246058825,"samples":10},{"from":0.41999999999999993,"to":0.48,"feature":0.4449999999999999,"mean":0.06795294434493881,"band99":0.6425696426171319,"samples":12},{"from":0.4800000000000001,"to":0.5700000000000001,"feature":0.534,"mean":-0.003971867761919004,"band99":0.5416328657374455,"samples":10},{"from":0.5999999999999999,"to":0.72,"feature":0.642,"mean":-0.18956149288054192,"band99":0.7428391431318392,"samples":10},{"from":0.75,"to":0.9,"feature":0.8250000000000001,"mean":-0.5180969184939616,"band99":0.8619454873064428,"samples":6}],"depends":false},{"name":"command","of":"","unit":"N*m","testable":true,"share":0.0270058200810826,"statistic":0.4116839730082715,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.3705,"to":-0.1645,"feature":-0.27705,"mean":-0.008280456352076027,"band99":0.43188189230110624,"samples":10},{"from":-0.15,"to":-0.15,"feature":-0.15,"mean":-0.0020851039890262455,"band99":0.6651133227566434,"samples":22},{"from":-0.135,"to":0.0445,"feature":-0.0348,"mean":-0.11280395106167265,"band99":0.9245896066402667,"samples":10},{"from":0.0525,"to":0.145,"feature":0.09915,"mean":-0.17520707703307783,"band99":0.6440444022054637,"samples":10},{"from":0.1605,"to":0.25,"feature":0.23495833333333327,"mean":0.10213046921850669,"band99":0.4758031010669517,"samples":24},{"from":0.2535,"to":0.3235,"feature":0.2906,"mean":-0.11502270729965675,"band99":0.8964917849331877,"samples":10},{"from":0.329,"to":0.35,"feature":0.3449285714285715,"mean":0.1219916388556605,"band99":1.4175348759708002,"samples":14}],"depends":false},{"name":"time","of":"","unit":"s","testable":true,"share":0.07609438545955931,"statistic":0.6044447350238905,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.24,"to":0.36,"feature":0.3,"mean":-0.30363443368018717,"band99":0.8671856822769254,"samples":10},{"from":0.39,"to":0.51,"feature":0.4499999999999999,"mean":-0.21057274840366577,"band99":0.5786909823420322,"samples":10},{"from":0.54,"to":0.66,"feature":0.6000000000000001,"mean":0.11571080331465933,"band99":0.9375215326702092,"samples":10},{"from":0.69,"to":0.81,"feature":0.7499999999999999,"mean":-0.06724557414499768,"band99":0.7379862507318256,"samples":10},{"from":0.84,"to":0.96,"feature":0.8999999999999998,"mean":-0.14209279331009939,"band99":1.2557632802036305,"samples":10},{"from":0.99,"to":1.11,"feature":1.05,"mean":0.017682691601934572,"band99":0.782355003953844,"samples":10},{"from":1.14,"to":1.26,"feature":1.1999999999999997,"mean":0.04010734964565425,"band99":0.3672571492034462,"samples":10},{"from":1.29,"to":1.41,"feature":1.35,"mean":-0.20134214941445824,"band99":0.5320247979872555,"samples":10},{"from":1.44,"to":1.56,"feature":1.4999999999999998,"mean":0.32590505588625523,"band99":1.3808570049470745,"samples":10},{"from":1.59,"to":1.71,"feature":1.65,"mean":0.42548179850490486,"band99":1.1850628026171206,"samples":10}],"depends":false},{"name":"load","of":"","unit":"N*m","testable":true,"share":0.03425332728580066,"statistic":3.1918312293654814,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.33008532599743806,"to":-0.1704014053166177,"feature":-0.23075834167353867,"mean":0.7269892933060191,"band99":1.2080592129515355,"samples":10},{"from":-0.16289562606545105,"to":-0.11825358707891534,"feature":-0.14042405435854968,"mean":0.2156318826176678,"band99":0.5798516483436755,"samples":10},{"from":-0.11211513792244567,"to":-0.09145783570211888,"feature":-0.10088723410218021,"mean":0.4923092160354688,"band99":0.6098838465543616,"samples":10},{"from":-0.09142525860695375,"to":0.0418144267536234,"feature":-0.01773311696929371,"mean":0.04055714517023252,"band99":1.0068325813718304,"samples":10},{"from":0.04687639997985796,"to":0.1319177551067673,"feature":0.09262911887067703,"mean":-0.11334026045559327,"band99":0.7189556100691296,"samples":10},{"from":0.14711680711759384,"to":0.22390404005590964,"feature":0.18967856471756106,"mean":-0.22023066895099425,"band99":0.6448211652692801,"samples":10},{"from":0.22420530275004957,"to":0.236594293963652,"feature":0.22915590723527143,"mean":-0.3299589342022042,"band99":0.3803013612294198,"samples":10},{"from":0.23883110171288774,"to":0.261949021536757,"feature":0.250566119907795,"mean":0.11298153614194813,"band99":0.6163850813132398,"samples":10},{"from":0.2624056187211716,"to":0.2812673088619406,"feature":0.26838196906269013,"mean":-0.22108778781042698,"band99":0.8891874908217365,"samples":10},{"from":0.2827668272495468,"to":0.3163480308016269,"feature":0.3033146151614084,"mean":-0.7038514218521177,"band99":1.0803213019807827,"samples":10}],"depends":false},{"name":"accumulated work","of":"","unit":"J","testable":true,"share":0.14965071388333348,"statistic":2.0991713796269367,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":9.571383208279704e-06,"to":0.005369978800545318,"feature":0.0013563052034534276,"mean":-0.4013551605649443,"band99":0.949482848980433,"samples":10},{"from":0.007985920800824376,"to":0.04211079229545879,"feature":0.024457090826608966,"mean":-0.19331765267273454,"band99":0.6804008413133239,"samples":10},{"from":0.0440105146142047,"to":0.07851813171474989,"feature":0.062468949968065554,"mean":-0.2112426689327954,"band99":0.31237768442057307,"samples":10},{"from":0.08182477873368801,"to":0.09688636445034074,"feature":0.08773603617220375,"mean":0.14785018360660993,"band99":0.7012027217283296,"samples":10},{"from":0.10168183988051706,"to":0.12298870903186758,"feature":0.11266260658035879,"mean":-0.19426874734634214,"band99":0.9863554738254094,"samples":10},{"from":0.12323765139031177,"to":0.1480951073285778,"feature":0.13418822779174716,"mean":0.10031389555614645,"band99":0.520683029906342,"samples":10},{"from":0.14999197535903103,"to":0.1690100311989622,"feature":0.1610361730487037,"mean":-0.0016899174031587312,"band99":0.7037273341427055,"samples":10},{"from":0.17118923423489543,"to":0.1900165476204505,"feature":0.18227274921350503,"mean":-0.11135542307791663,"band99":0.5838147322807395,"samples":10},{"from":0.19340618730298398,"to":0.23767811287832197,"feature":0.21193798037683256,"mean":0.27224420630627155,"band99":0.666019607975088,"samples":10},{"from":0.24053762157922412,"to":0.42824697645925264,"feature":0.31494971086855644,"mean":0.5928212845288637,"band99":1.0795437377004722,"samples":10}],"depends":false}],"selected":[],"not_on":["position","velocity","|velocity|","direction of motion","time since the last reversal","command","time","load","accumulated work"]}],"tree":[{"parent":-1,"share_of_error":1.0,"share_of_samples":1.0}],"regimes":[]}]}}');
CREATE TABLE ensemble_model (
  pass INTEGER NOT NULL REFERENCES pass (id),
  rank INTEGER NOT NULL CHECK (rank >= 1),
  model INTEGER NOT NULL REFERENCES model (id),
  score REAL,
  structure TEXT NOT NULL,
  PRIMARY KEY (pass, rank)
) STRICT, WITHOUT ROWID;
INSERT INTO ensemble_model VALUES(1099511627778,1,1099511627782,0.00087304898096649040471,'coulomb_friction');
INSERT INTO ensemble_model VALUES(1099511627778,2,1099511627784,0.0024346245497159947623,'coulomb_friction');
INSERT INTO ensemble_model VALUES(1099511627778,3,1099511627788,0.0048877583975718572398,'no optional effect');
INSERT INTO ensemble_model VALUES(1099511627779,1,1099511627793,0.0046101901033581121208,'no optional effect');
INSERT INTO ensemble_model VALUES(1099511627779,2,1099511627799,0.009161361302777155588,'coulomb_friction');
INSERT INTO ensemble_model VALUES(1099511627779,3,1099511627795,0.010975380381570289112,'no optional effect');
INSERT INTO ensemble_model VALUES(2199023255554,1,2199023255554,0.0038656872525911784715,'');
INSERT INTO ensemble_model VALUES(2199023255554,2,2199023255555,0.0046342950692290748107,'');
CREATE TABLE ensemble_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  rank INTEGER NOT NULL CHECK (rank >= 1),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, rank, position)
) STRICT, WITHOUT ROWID;
INSERT INTO ensemble_value VALUES(1099511627778,1,0,0.05972615920382814969);
INSERT INTO ensemble_value VALUES(1099511627778,1,1,0.02711595782742521471);
INSERT INTO ensemble_value VALUES(1099511627778,2,0,0.032429871334004115035);
INSERT INTO ensemble_value VALUES(1099511627778,2,1,0.029955657910691654149);
INSERT INTO ensemble_value VALUES(1099511627778,3,0,0.1426725859378954464);
INSERT INTO ensemble_value VALUES(1099511627778,3,1,NULL);
INSERT INTO ensemble_value VALUES(1099511627779,1,0,0.083759962422083736321);
INSERT INTO ensemble_value VALUES(1099511627779,1,1,NULL);
INSERT INTO ensemble_value VALUES(1099511627779,2,0,0.0087241125196667497487);
INSERT INTO ensemble_value VALUES(1099511627779,2,1,0.038869776258322837059);
INSERT INTO ensemble_value VALUES(1099511627779,3,0,0.12356495356645039174);
INSERT INTO ensemble_value VALUES(1099511627779,3,1,NULL);
INSERT INTO ensemble_value VALUES(2199023255554,1,0,0.089389021853670855288);
INSERT INTO ensemble_value VALUES(2199023255554,2,0,0.058938493447797862812);
CREATE TABLE set_aside (
  pass INTEGER NOT NULL REFERENCES pass (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  PRIMARY KEY (pass, trial)
) STRICT, WITHOUT ROWID;
CREATE TABLE trial_setting (
  trial INTEGER NOT NULL REFERENCES trial (id),
  position INTEGER NOT NULL,
  address TEXT NOT NULL,
  value REAL NOT NULL,
  PRIMARY KEY (trial, position)
) STRICT, WITHOUT ROWID;
INSERT INTO trial_setting VALUES(3298534883329,0,'body.arm.mass',0.5500000000000000444);
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
       diagnosis.base_times_floor, best.times_floor, diagnosis.document ->> '$.stopped.during' AS stopped,
       diagnosis.id >> 40 AS run, diagnosis.id
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
       coalesce(last.evaluations, 0) AS evaluations, coalesce(last.steps, 0) AS steps, checkpoint.seconds, run.seed,
       (SELECT stopped FROM pass WHERE pass.run = eea_run.run AND stopped IS NOT NULL) AS stopped
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
WHERE truth IS NOT NULL AND value IS NOT NULL AND NOT EXISTS (
  SELECT * FROM objective_score
  WHERE objective_score.pass = (best_model.run << 40) + 1 + best_model.pass AND objective_score.name = best_model.address)
UNION ALL
SELECT experiment.name, pass.run, eea_run.replicate, pass.number, objective_score.name, objective_score.value,
       objective_score.unit
FROM objective_score
JOIN pass ON pass.id = objective_score.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment;
CREATE VIEW ensembles AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass, ensemble_model.rank,
       (ensemble_model.model & 1099511627775) - 1 AS model, ensemble_model.structure, ensemble_model.score,
       free_value.position, free_value.address, ensemble_value.value, free_value.unit, free_value.truth
FROM ensemble_model
JOIN pass ON pass.id = ensemble_model.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
LEFT JOIN ensemble_value ON ensemble_value.pass = ensemble_model.pass AND ensemble_value.rank = ensemble_model.rank
LEFT JOIN free_value ON free_value.run = pass.run AND free_value.position = ensemble_value.position;
CREATE VIEW foretold AS
SELECT experiment.name AS experiment, target_trial.run, eea_run.replicate, target_trial.number AS trial,
       target_trial.surprise, metric.name AS metric, target_trial.for_transfer,
       (SELECT count(*) FROM set_aside WHERE set_aside.trial = target_trial.trial
          AND set_aside.pass >> 40 = target_trial.run) AS passes_set_aside
FROM target_trial
JOIN eea_run ON eea_run.run = target_trial.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN metric ON metric.id = eea_run.metric;
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
CREATE VIEW failed_trials AS
SELECT experiment.name AS experiment, failed_trial.run, failed_trial.trial, failed_trial.test, failed_trial.failed,
       failed_trial.reason
FROM failed_trial
JOIN experiment ON experiment.id = failed_trial.experiment;
COMMIT;
PRAGMA application_id = 1281450862;
PRAGMA user_version = 13;
