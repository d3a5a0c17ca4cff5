-- Schema version 9, written by the program of commit 92d30f81: what sqlite3's .dump prints, and the header's numbers.
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE schema_text (
  name TEXT NOT NULL PRIMARY KEY,
  sha256 TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO schema_text VALUES('views','13c4814aeb3bb4dd61b8825dd41d4a88f29c6ee7c1655c28d9e51ac30f7d4d67');
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
  overrides TEXT NOT NULL CHECK (json_valid(overrides)),
  UNIQUE (experiment, digest)
) STRICT;
INSERT INTO experiment_text VALUES(1099511627777,1099511627777,'d604db8f7ac760db71dc5286254693db119ef02956db899f1112b89efcbff35b','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] } }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(2199023255553,2199023255553,'c93d9972a18f2af34ee49f17bacdb82c3ab2def0cd48e8c5982c3ce78b1cd0d2','outside.toml',replace('# The pendulum as a program of its own, which refuses its second test.\n\n[experiment]\nname = "outside"\nseed = 1\npasses = 1\n\n[target]\nkind = "process"\ncommand = ["python3", "pendulum.py"]\nstart_limit = "10 s"\ntrial_limit = "20 s"\nrepeats = 1\npause = 0.0\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = []\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 1 }\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 1 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(3298534883329,3298534883329,'f785f7e4841723bda85e9488dd88a39ff8abdf5ab786d0296a7119bc1cd05feb','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = []\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(7696581394433,3298534883329,'8662400ecf8a693fd21df3ae825c4e107601ee373acd3d53c19033e11a5075a1','rig.toml',replace('# A servo pendulum, three short recordings of it.\n\n[experiment]\nname = "rig"\nseed = 1\n\n[target]\nkind = "recorded"\nfiles = ["data/sine.csv", "data/steps.csv"]\nholdout = ["data/chirp.csv"]\nhold = "zero"\n\n[target.time]\ncolumn = "t_s"\n\n[target.sensors]\nangle = { column = "angle_deg", unit = "deg" }\n\n[target.commands]\nmotor = { column = "torque_Nm", unit = "N*m" }\n\n[model]\nfile = "robot.toml"\neffects = [\n  { id = "coulomb_friction", effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.02223 } },\n]\n\n[model.free]\n"body.arm.mass" = ["0.3 kg", "1.0 kg"]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "30 ms"\n\n[fit]\nmethod = "free_run"\nstarts = 1\n\n[noise]\nprocess = { "joint.hinge" = "0.5 mN*m" }\nprocess_correlation_time = "20 ms"\n','\n',char(10)),'[]');
INSERT INTO experiment_text VALUES(10995116277761,1099511627777,'0bc800d15020723beb3b7213350d5eb558b9cdb8259921536402226f0a129d0e','evolve.toml',replace('# A simulated pendulum with a dry friction that models may have, in a very small run.\n\n[experiment]\nname = "evolve"\nseed = 1\npasses = 2\n\n[target]\nkind = "simulated"\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\nnoise = { "sensor.angle" = "0.3 mrad" }\nhidden = { "joint.hinge.damping" = { uniform = [0.01, 0.05] } }\nhidden_seed = 4\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = "0.03 N*m" }, fixed = ["torque"] }]\n\n[model]\nfile = "robot.toml"\nset = { "actuator.motor.force_limit" = 0.6 }\neffects = [{ effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] } }]\n\n[model.free]\n"joint.hinge.damping" = [0.0, 0.2]\n\n[engine]\nstep = "20 ms"\n\n[test]\nencoding = "command_series"\nduration = "0.3 s"\n\n[estimation]\nparameters = { population = 4, keep = 2, generations = 2 }\nobjective = "parameter_error"\n\n[exploration]\nfitness = "model_disagreement"\nfitness_parameters = { noise = 3e-4 }\nparameters = { population = 4, keep = 2, generations = 2 }\n\n[fit]\nmethod = "free_run"\nstarts = 1\n','\n',char(10)),'["engine.substeps=20000","estimation.parameters.generations=20"]');
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
INSERT INTO run VALUES(1,'dfd4efb12ac3c07a59a39ba407801f1c',1099511627777,'lacuna run evolve.toml --db sample.db --threads 1',1,1,'2026-11-28T12:57:36Z','2026-11-28T12:57:36Z','done');
INSERT INTO run VALUES(2,'692231297bce594fd348a3085d17150e',2199023255553,'lacuna run outside.toml --db sample.db --threads 1',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(3,'4d4855e5ca664422c209c08b0a9f4267',3298534883329,'lacuna compare rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(4,'e25f1707f734787cef86de6395ce60d8',3298534883329,'lacuna diagnose rig.toml --db sample.db --threads 1 --among coulomb_friction joint_offset_torque',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(5,'ecf0cb180c1252a7ea34e65529e47de0',3298534883329,'lacuna diagnose rig.toml --db sample.db --threads 1 --among coulomb_friction joint_offset_torque sensor_delay',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','interrupted');
INSERT INTO run VALUES(6,'0162f32b08937cfd9b9a6a3b3fd825a1',3298534883329,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(7,'d3842a25e0561e5630c3335761822196',7696581394433,'lacuna add rig.toml coulomb_friction --where joint.hinge --db sample.db --threads 1',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(8,'f3b7691ecb66c32461d50526651b4846',7696581394433,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(9,'578217b2b0679f3c7bf3f71615f945ed',3298534883329,'lacuna undo rig.toml --db sample.db --threads 1',1,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:37Z','done');
INSERT INTO run VALUES(10,'8fc756029516fb065abbf4c70e7251b2',10995116277761,'lacuna run evolve.toml --db sample.db --threads 1 --seed 2 --set engine.substeps=20000 --set estimation.parameters.generations=20',2,1,'2026-11-28T12:57:37Z','2026-11-28T12:57:38Z','interrupted');
INSERT INTO run VALUES(11,'e801f00d4a4caba6a3ad668769af9059',1099511627777,'lacuna trial evolve.toml --db sample.db --threads 1 --test ''triangle motor 0.3 N*m 4 Hz 0.3 s''',1,1,'2026-11-28T12:57:38Z','2026-11-28T12:57:38Z','done');
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
INSERT INTO provenance VALUES(1,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(2,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(3,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(4,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(5,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(6,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(7,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(8,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(9,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(10,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
INSERT INTO provenance VALUES(11,'0.1.0','92d30f8105f5e72aa89268185a40abbbc02f7ab1','gcc 12.2.0','Release','0.16.2','3.40.1','3.4.0','Intel(R) Xeon(R) Processor','Linux x86_64');
CREATE TABLE plugin_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  build_id TEXT NOT NULL,
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/command_series.so','c84f3467e4b1bf84217f412e53c90d7e936c6181a6adf8dd63bf2d50303efee2','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','2409777565ff3d5fff310979d79dae4b8d5168dec86a7c3793d66a604fd9a7bb','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','969497b1c761721dffe3fe3cf7c628cba37c9f4374971b5a5805a1186cae3056','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','644e54dfd2537c3bd10ee236df44a1eea729c32068357e414cc7144ddf6ae717','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','3d5225e4b854e0bf91a4f7bd017c870f0f04bda505b5acb735a51ec6df49fe90','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/parameters.so','5c540307e4ce3e84c688079ae7eab5dcd7330638f81a27a332b54080c8fe951d','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/simulated.so','de790b18aeaca1e37ef2ec3b179a7d80e93b9da6ef4c7252037065e778eb1749','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/truncation.so','b48126131a367c84d354fc8ffe6b2c54a0921ee7bbb38f8cd6a5369f0b37c02f','0.1.0');
INSERT INTO plugin_file VALUES(1,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','de93b91a91c47f492fd3d9bef4f81df83c31088d31fa9c3e8599ebd417e02852','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/command_series.so','c84f3467e4b1bf84217f412e53c90d7e936c6181a6adf8dd63bf2d50303efee2','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','2409777565ff3d5fff310979d79dae4b8d5168dec86a7c3793d66a604fd9a7bb','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','969497b1c761721dffe3fe3cf7c628cba37c9f4374971b5a5805a1186cae3056','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','644e54dfd2537c3bd10ee236df44a1eea729c32068357e414cc7144ddf6ae717','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/parameters.so','5c540307e4ce3e84c688079ae7eab5dcd7330638f81a27a332b54080c8fe951d','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/process.so','8477d4996da4905c42e8d07ea48c055bf1eb977d76351ed2f8e91e58af35079f','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/truncation.so','b48126131a367c84d354fc8ffe6b2c54a0921ee7bbb38f8cd6a5369f0b37c02f','0.1.0');
INSERT INTO plugin_file VALUES(2,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','de93b91a91c47f492fd3d9bef4f81df83c31088d31fa9c3e8599ebd417e02852','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(3,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(4,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(5,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(6,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(7,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(8,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(9,'/srv/lacuna/lib/lacuna/plugins/recorded.so','af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/command_series.so','c84f3467e4b1bf84217f412e53c90d7e936c6181a6adf8dd63bf2d50303efee2','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/mean_absolute_difference.so','2409777565ff3d5fff310979d79dae4b8d5168dec86a7c3793d66a604fd9a7bb','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/model_disagreement.so','969497b1c761721dffe3fe3cf7c628cba37c9f4374971b5a5805a1186cae3056','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/one_point_crossover.so','644e54dfd2537c3bd10ee236df44a1eea729c32068357e414cc7144ddf6ae717','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/parameter_error.so','3d5225e4b854e0bf91a4f7bd017c870f0f04bda505b5acb735a51ec6df49fe90','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/parameters.so','5c540307e4ce3e84c688079ae7eab5dcd7330638f81a27a332b54080c8fe951d','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/simulated.so','de790b18aeaca1e37ef2ec3b179a7d80e93b9da6ef4c7252037065e778eb1749','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/truncation.so','b48126131a367c84d354fc8ffe6b2c54a0921ee7bbb38f8cd6a5369f0b37c02f','0.1.0');
INSERT INTO plugin_file VALUES(10,'/srv/lacuna/lib/lacuna/plugins/uniform_reset.so','de93b91a91c47f492fd3d9bef4f81df83c31088d31fa9c3e8599ebd417e02852','0.1.0');
INSERT INTO plugin_file VALUES(11,'/srv/lacuna/lib/lacuna/plugins/coulomb_friction.so','fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3','0.1.0');
INSERT INTO plugin_file VALUES(11,'/srv/lacuna/lib/lacuna/plugins/declared.so','dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964','0.1.0');
INSERT INTO plugin_file VALUES(11,'/srv/lacuna/lib/lacuna/plugins/simulated.so','de790b18aeaca1e37ef2ec3b179a7d80e93b9da6ef4c7252037065e778eb1749','0.1.0');
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
INSERT INTO revision VALUES(7696581394433,3298534883329,2,3298534883329,'26ec4713dd15909dbcd1b5c09a79756369b61e8017cba6d1cb79c0c76535af81','servo-pendulum','{"actuators":[{"command_lower":"-inf","command_upper":"inf","delay":0.0,"force_limit":"inf","gain":1.0,"joint":"hinge","kd":0.0,"ki":0.0,"kind":0,"kp":0.0,"name":"motor","offset":0.0,"transmission":{"damping":0.0,"gap":0.0,"ratio":1.0,"rotor_inertia":0.0,"stiffness":"inf"}}],"bodies":[{"com":[0.0,0.0,-0.2],"inertia":[0.005,0.005,0.0005,0.0,0.0,0.0],"inertia_scales_with_mass":true,"mass":0.5,"name":"arm","orientation":[1.0,0.0,0.0,0.0],"position":[0.0,0.0,0.0],"shapes":[]}],"contact":{"damping":0.0,"friction":"inf","ground":false,"slope":0.0,"stiffness":"inf"},"gravity":[0.0,0.0,-9.81],"joints":[{"anchor":[0.0,0.0,0.0],"armature":0.005,"axis":[0.0,1.0,0.0],"axis2":[1.0,0.0,0.0],"child":"arm","damping":0.01,"dry_friction":0.0,"force":0.0,"kind":0,"lower":"-inf","name":"hinge","parent":"world","rest":0.0,"stiffness":0.0,"upper":"inf"}],"name":"servo-pendulum","sensors":[{"beacon":[0.0,0.0,0.0],"delay":0.0,"element":"hinge","kind":0,"name":"angle","noise":0.0003,"offset":0.0,"quantum":0.0030679615757712823,"scale":1.0}]}','[{"address":"body.arm.mass","lower":0.3,"start":0.5,"unit":"kg","upper":1.0},{"address":"joint.hinge.damping","lower":0.0,"start":0.01,"unit":"N*m*s/rad","upper":0.2},{"address":"effect.coulomb_friction.torque","lower":0.0,"start":0.02223,"unit":"N*m","upper":10000.0}]','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.02223},"where":["joint.hinge"]}]','{"control_period":0.0,"delay_rounding":"none","engine":"ode","joint_erp":0.2,"step":0.03,"substeps":1}','82d5ec7dfb80ec8d2449060eaff75cc40727f2ce7bb4661d9e258ec71cd5a8a7','[{"effect":"coulomb_friction","fixed":[],"id":"coulomb_friction","start":{"torque":0.02223},"where":["joint.hinge"]}]','[]','coulomb_friction');
CREATE TABLE revision_use (
  run INTEGER NOT NULL REFERENCES run (number),
  position INTEGER NOT NULL,
  revision INTEGER NOT NULL REFERENCES revision (id),
  PRIMARY KEY (run, position)
) STRICT, WITHOUT ROWID;
INSERT INTO revision_use VALUES(3,0,3298534883329);
INSERT INTO revision_use VALUES(4,0,3298534883329);
INSERT INTO revision_use VALUES(5,0,3298534883329);
INSERT INTO revision_use VALUES(6,0,3298534883329);
INSERT INTO revision_use VALUES(7,0,7696581394433);
INSERT INTO revision_use VALUES(8,0,7696581394433);
INSERT INTO revision_use VALUES(9,0,3298534883329);
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
INSERT INTO trial VALUES(1099511627779,1099511627777,'run 1, trial 2','','a4f2583b61ca2243970f82205ad058147db93ed67ce01f48aa2f05623aece54a',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(2199023255553,2199023255553,'run 2, trial 0','','1e6a70e90e62e6e55304d195af1ff9e9010d25059e5dd29944a5191853d8f7ee',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(2199023255554,2199023255553,'run 2, trial 1','','64cd4e7e3078a2482712591b94c3c79f05c405abdffe01c7e23a6bd39e2842ba',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(3298534883329,3298534883329,'sine.csv','sine.csv','e3ebed47fa02f514f6bc6550bccbd376892c54496379f41872dc75297a1e4cdd',0,1.830000000000000071,62);
INSERT INTO trial VALUES(3298534883330,3298534883329,'steps.csv','steps.csv','ab6bc9493e69a859ca0776df276c8e2e3a993fd6f3cbe042acf2fb6dfbae564c',0,1.830000000000000071,62);
INSERT INTO trial VALUES(3298534883331,3298534883329,'chirp.csv','chirp.csv','336df2d7813e9a0bec213a5bbf62831db7c9326effc1d35d1aa03cfd1e85853e',1,0.9000000000000000222,31);
INSERT INTO trial VALUES(10995116277761,1099511627777,'run 10, trial 0','','357d04006265dc35d69c56580494972d84b0456be87ce5f5d226368c7c4b78f9',0,0.29999999999999998889,16);
INSERT INTO trial VALUES(12094627905537,1099511627777,'trial-1','','995ee74ee5b05c230135e288a64d4b7d4ba6ee0d909c48945437ab8dfc324365',0,0.29999999999999998889,16);
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
INSERT INTO fit VALUES(3298534883329,3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 92d30f8105f5e72aa89268185a40abbbc02f7ab1 dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964 af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','free_run','huber',3.0,1,13.046152850169198345,116,144,0,1,1,0.43924859889937162282,'[[3.8233725245425114e-05,-7.720817428150942e-06],[-7.72081742815094e-06,3.563987353763015e-06]]','[]','["residuals are correlated over 0.44 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.017, joint.hinge.damping by -0.0065; the intervals reach as far, more substeps make them narrower"]');
INSERT INTO fit VALUES(7696581394433,7696581394433,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 92d30f8105f5e72aa89268185a40abbbc02f7ab1 fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3 dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964 af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18','free_run','huber',3.0,1,5.5743160586291509162,116,310,0,1,1,0.7728639607163274583,'[[2.1551911869566754e-05,-2.2475886923699657e-06,-1.933351964432982e-06],[-2.2475886923699746e-06,1.884289007222299e-06,-1.4054401758923332e-06],[-1.9333519644329793e-06,-1.4054401758923143e-06,2.20249857264401e-06]]','[]','["residuals are correlated over 0.77 s; the intervals rest on 12 blocks of the recording only","integration in infinitely short steps would move body.arm.mass by +0.02, joint.hinge.damping by +0.00079, effect.coulomb_friction.torque by -0.013; the intervals reach as far, more substeps make them narrower"]');
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
INSERT INTO fit_stage VALUES(3298534883329,0,'free run',0.0,2,1,1,3,1,13.046152850169198345,'[0.5548900339404577,0.030963922380422348]');
INSERT INTO fit_stage VALUES(7696581394433,0,'free run',0.0,2,1,1,10,1,5.5743160586291509162,'[0.5556568737226383,0.019642645590181928,0.018398816636882052]');
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
INSERT INTO fitted_value VALUES(3298534883329,0,'body.arm.mass','kg',0.5,0.55489003394045766093,0.0061833425625162571903,0.54111268814177482244,0.58591794440984812375,NULL,1);
INSERT INTO fitted_value VALUES(3298534883329,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.030963922380422347763,0.0018878525773383405227,0.020304820955040919078,0.03517032005481232626,NULL,1);
INSERT INTO fitted_value VALUES(7696581394433,0,'body.arm.mass','kg',0.5,0.55565687372263827814,0.0046424036736982228837,0.5451550269995811826,0.58631276272683841011,NULL,1);
INSERT INTO fitted_value VALUES(7696581394433,1,'joint.hinge.damping','N*m*s/rad',0.010000000000000000208,0.019642645590181927878,0.0013726940690562843862,0.016537395869535641279,0.02354136943106868024,NULL,1);
INSERT INTO fitted_value VALUES(7696581394433,2,'effect.coulomb_friction.torque','N*m',0.02222999999999999976,0.018398816636882052433,0.0014840817270770536705,0.0018105596802586373939,0.021756042745967339724,NULL,1);
CREATE TABLE holdout_look (
  id INTEGER PRIMARY KEY,
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  revision INTEGER NOT NULL REFERENCES revision (id),
  command TEXT NOT NULL,
  time TEXT NOT NULL,
  UNIQUE (experiment, number)
) STRICT;
INSERT INTO holdout_look VALUES(3298534883329,3298534883329,1,3298534883329,'lacuna compare rig.toml --db sample.db --threads 1','2026-11-28T12:57:37Z');
CREATE TABLE comparison (
  id INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL REFERENCES revision (id),
  kind TEXT NOT NULL CHECK (kind IN ('refitted', 'as_written')),
  fit INTEGER REFERENCES fit (id),
  look INTEGER,
  step REAL,
  findings TEXT NOT NULL CHECK (json_valid(findings))
) STRICT;
INSERT INTO comparison VALUES(3298534883329,3298534883329,'refitted',3298534883329,1,0.029999999999999998889,'["the numerical error of angle is not small beside its error and floor; set more engine.substeps"]');
INSERT INTO comparison VALUES(6597069766657,3298534883329,'refitted',3298534883329,NULL,0.029999999999999998889,'["the numerical error of angle is not small beside its error and floor; set more engine.substeps"]');
INSERT INTO comparison VALUES(7696581394433,7696581394433,'refitted',7696581394433,NULL,0.029999999999999998889,'["the numerical error of angle is not small beside its error and floor; set more engine.substeps"]');
INSERT INTO comparison VALUES(9895604649985,3298534883329,'refitted',3298534883329,NULL,0.029999999999999998889,'["the numerical error of angle is not small beside its error and floor; set more engine.substeps"]');
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
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.0,'rad',58,0.014169858751977366245,0.042863751788506140871,NULL,-0.0032455134381021554651,NULL,NULL,NULL,0.026594846608956598799,0.56999999999999995115,0.0067514453745871200185,0.085104174720160338796);
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.10000000000000000555,'rad',0,0.001311104969151411035,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883329,'angle',0.5,'rad',0,0.0089293733790596699351,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.0,'rad',58,0.010749785428433829628,0.02981354565364067663,NULL,0.0033923911296447951425,NULL,NULL,NULL,0.029375441068684504664,1.830000000000000071,0.00098299953687659507271,0.11406395905448168948);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0021974947407376534298,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883330,'angle',0.5,'rad',0,0.008404687019421886937,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.0,'rad',27,0.015162070498810992225,0.10424600689894557292,NULL,-0.012462288829920056473,NULL,NULL,NULL,0.024381254691390102928,0.63000000000000000444,0.0040768215043349180157,0.047776292017303816084);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.10000000000000000555,'rad',0,0.0011094311322454165728,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(3298534883329,3298534883331,'angle',0.5,'rad',0,0.012146017023224341124,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.0,'rad',58,0.014169858751977366245,0.042863751788506140871,NULL,-0.0032455134381021554651,NULL,NULL,NULL,0.026594846608956598799,0.56999999999999995115,0.0067514453745871200185,0.085104174720160338796);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.10000000000000000555,'rad',0,0.001311104969151411035,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883329,'angle',0.5,'rad',0,0.0089293733790596699351,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.0,'rad',58,0.010749785428433829628,0.02981354565364067663,NULL,0.0033923911296447951425,NULL,NULL,NULL,0.029375441068684504664,1.830000000000000071,0.00098299953687659507271,0.11406395905448168948);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0021974947407376534298,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(6597069766657,3298534883330,'angle',0.5,'rad',0,0.008404687019421886937,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(7696581394433,3298534883329,'angle',0.0,'rad',58,0.0044995458285552025062,0.01361110360604577546,NULL,0.0025856516839439474923,NULL,NULL,NULL,0.0089941001305888224059,1.080000000000000071,0.0070572121076630930577,0.054237770255978139111);
INSERT INTO comparison_score VALUES(7696581394433,3298534883329,'angle',0.10000000000000000555,'rad',0,0.0011753042547942014247,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(7696581394433,3298534883329,'angle',0.5,'rad',0,0.0031471104659927437961,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(7696581394433,3298534883330,'angle',0.0,'rad',58,0.005839774310385728237,0.016196079370024107219,NULL,0.0044663209774453019665,NULL,NULL,NULL,0.012460139835565486876,1.3799999999999998934,0.00097309284280448511,0.062816285760988466169);
INSERT INTO comparison_score VALUES(7696581394433,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0017404545198303898907,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(7696581394433,3298534883330,'angle',0.5,'rad',0,0.0052011513234351252482,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(9895604649985,3298534883329,'angle',0.0,'rad',58,0.014169858751977366245,0.042863751788506140871,NULL,-0.0032455134381021554651,NULL,NULL,NULL,0.026594846608956598799,0.56999999999999995115,0.0067514453745871200185,0.085104174720160338796);
INSERT INTO comparison_score VALUES(9895604649985,3298534883329,'angle',0.10000000000000000555,'rad',0,0.001311104969151411035,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(9895604649985,3298534883329,'angle',0.5,'rad',0,0.0089293733790596699351,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(9895604649985,3298534883330,'angle',0.0,'rad',58,0.010749785428433829628,0.02981354565364067663,NULL,0.0033923911296447951425,NULL,NULL,NULL,0.029375441068684504664,1.830000000000000071,0.00098299953687659507271,0.11406395905448168948);
INSERT INTO comparison_score VALUES(9895604649985,3298534883330,'angle',0.10000000000000000555,'rad',0,0.0021974947407376534298,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO comparison_score VALUES(9895604649985,3298534883330,'angle',0.5,'rad',0,0.008404687019421886937,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
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
INSERT INTO noise_floor VALUES(3298534883329,3298534883329,'angle','rad',0.0067514453745871200185,0.00093507523005767695725,0.0,0.0066863778654938730433,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(3298534883329,3298534883330,'angle','rad',0.00098299953687659507271,0.00093507523005767695725,0.0,0.00030318707695444879063,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(3298534883329,3298534883331,'angle','rad',0.0040768215043349180157,0.00093507523005767695725,0.0,0.0039681365768254759848,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 3.97 mrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883329,'angle','rad',0.0067514453745871200185,0.00093507523005767695725,0.0,0.0066863778654938730433,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(6597069766657,3298534883330,'angle','rad',0.00098299953687659507271,0.00093507523005767695725,0.0,0.00030318707695444879063,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
INSERT INTO noise_floor VALUES(7696581394433,3298534883329,'angle','rad',0.0070572121076630930577,0.00093507523005767695725,0.0,0.0069949894243436236754,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.99 mrad');
INSERT INTO noise_floor VALUES(7696581394433,3298534883330,'angle','rad',0.00097309284280448511,0.00093507523005767695725,0.0,0.00026933992435191809154,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 269 µrad');
INSERT INTO noise_floor VALUES(9895604649985,3298534883329,'angle','rad',0.0067514453745871200185,0.00093507523005767695725,0.0,0.0066863778654938730433,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 6.69 mrad');
INSERT INTO noise_floor VALUES(9895604649985,3298534883330,'angle','rad',0.00098299953687659507271,0.00093507523005767695725,0.0,0.00030318707695444879063,'declared by the robot''s sensor, with encoder step 3.07 mrad/√12; random force adds 303 µrad');
CREATE TABLE numerical_error (
  comparison INTEGER NOT NULL REFERENCES comparison (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  channel TEXT NOT NULL,
  horizon REAL NOT NULL,
  error REAL NOT NULL,
  PRIMARY KEY (comparison, trial, channel, horizon)
) STRICT, WITHOUT ROWID;
INSERT INTO numerical_error VALUES(3298534883329,3298534883329,'angle',0.0,0.007200759186889470198);
INSERT INTO numerical_error VALUES(3298534883329,3298534883330,'angle',0.0,0.0098317772017465360212);
INSERT INTO numerical_error VALUES(3298534883329,3298534883331,'angle',0.0,0.0046597907412987606828);
INSERT INTO numerical_error VALUES(6597069766657,3298534883329,'angle',0.0,0.007200759186889470198);
INSERT INTO numerical_error VALUES(6597069766657,3298534883330,'angle',0.0,0.0098317772017465360212);
INSERT INTO numerical_error VALUES(7696581394433,3298534883329,'angle',0.0,0.0076953002427516282307);
INSERT INTO numerical_error VALUES(7696581394433,3298534883330,'angle',0.0,0.011393306215845815793);
INSERT INTO numerical_error VALUES(9895604649985,3298534883329,'angle',0.0,0.007200759186889470198);
INSERT INTO numerical_error VALUES(9895604649985,3298534883330,'angle',0.0,0.0098317772017465360212);
CREATE TABLE work_time (
  kind TEXT NOT NULL CHECK (kind IN ('fit', 'comparison')),
  id INTEGER NOT NULL,
  seconds REAL NOT NULL,
  PRIMARY KEY (kind, id)
) STRICT, WITHOUT ROWID;
INSERT INTO work_time VALUES('comparison',3298534883329,0.0066868140000000001257);
INSERT INTO work_time VALUES('comparison',6597069766657,0.0063412499999999996647);
INSERT INTO work_time VALUES('comparison',7696581394433,0.0075620540000000003449);
INSERT INTO work_time VALUES('comparison',9895604649985,0.010173731000000000093);
INSERT INTO work_time VALUES('fit',3298534883329,0.0076337050000000001778);
INSERT INTO work_time VALUES('fit',7696581394433,0.012070816999999999311);
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
INSERT INTO eea_run VALUES(1,1099511627777,1,2,1,2,'["joint.hinge.damping","effect.coulomb_friction.torque"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
INSERT INTO eea_run VALUES(2,2199023255553,1,1,1,2,'["joint.hinge.damping"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
INSERT INTO eea_run VALUES(10,1099511627777,1,2,1,2,'["joint.hinge.damping","effect.coulomb_friction.torque"]','["motor.shape","motor.amplitude","motor.centre","motor.low_frequency","motor.high_frequency","motor.seed"]','1');
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
INSERT INTO free_value VALUES(10,0,'joint.hinge.damping','N*m*s/rad',0.0,0.2000000000000000111,0.010000000000000000208,0.048908311008618268744);
INSERT INTO free_value VALUES(10,1,'effect.coulomb_friction.torque','N*m',0.0,0.10000000000000000555,0.0,0.029999999999999998889);
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
INSERT INTO pass VALUES(1099511627778,1,1,1,1099511627777,0.0010872996778533068097,1099511627781,45260.425488638124078,6,1,0,0,87,6,0,180);
INSERT INTO pass VALUES(1099511627779,1,2,1,1099511627788,0.0053711845281788289999,1099511627787,98781.80823029017483,6,0,0,0,180,6,0,180);
INSERT INTO pass VALUES(2199023255554,2,1,1,2199023255554,0.0073801089276935355129,2199023255557,211098.33705170993926,4,0,0,0,60,4,0,120);
INSERT INTO pass VALUES(10995116277762,10,1,0,NULL,NULL,NULL,NULL,0,0,0,0,0,0,0,0);
CREATE TABLE best_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;
INSERT INTO best_value VALUES(1099511627778,0,0.033924456635926018843);
INSERT INTO best_value VALUES(1099511627778,1,0.036878912835683806681);
INSERT INTO best_value VALUES(1099511627779,0,0.023212454188080457878);
INSERT INTO best_value VALUES(1099511627779,1,0.064590830374449223483);
INSERT INTO best_value VALUES(2199023255554,0,0.089389021853670855288);
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
INSERT INTO objective_score VALUES(1099511627779,0,'joint.hinge.damping','N*m*s/rad',0.025695856820537810866);
INSERT INTO objective_score VALUES(1099511627779,1,'effect.coulomb_friction.torque','N*m',0.034590830374449224593);
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
INSERT INTO test VALUES(10995116277761,10995116277762,0,NULL,NULL,X'0000000000000000e6e9bc8b6d92ce3fc18d084abd5cc13f0ad449cdaf55f63f678505b0dcfa0b400000000000807540',1);
CREATE TABLE test_score (
  test INTEGER NOT NULL REFERENCES test (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (test, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO test_score VALUES(1099511627777,2,NULL);
INSERT INTO test_score VALUES(1099511627778,2,37.665914400697552365);
INSERT INTO test_score VALUES(1099511627779,2,151.35262973400753594);
INSERT INTO test_score VALUES(1099511627780,2,20552.327017300223814);
INSERT INTO test_score VALUES(1099511627781,2,45260.425488638124078);
INSERT INTO test_score VALUES(1099511627782,2,20552.327017300223814);
INSERT INTO test_score VALUES(1099511627783,2,45260.425488638124078);
INSERT INTO test_score VALUES(1099511627784,2,6251.5014847481879768);
INSERT INTO test_score VALUES(1099511627785,2,1968.004602920335401);
INSERT INTO test_score VALUES(1099511627786,2,15315.324641071769292);
INSERT INTO test_score VALUES(1099511627787,2,98781.80823029017483);
INSERT INTO test_score VALUES(1099511627788,2,7174.1360722803055979);
INSERT INTO test_score VALUES(1099511627789,2,10569.273347840507994);
INSERT INTO test_score VALUES(2199023255553,2,NULL);
INSERT INTO test_score VALUES(2199023255554,2,9766.1584919115248335);
INSERT INTO test_score VALUES(2199023255555,2,1854.6463946638518791);
INSERT INTO test_score VALUES(2199023255556,2,116862.37046430628105);
INSERT INTO test_score VALUES(2199023255557,2,211098.33705170993926);
INSERT INTO test_score VALUES(10995116277761,2,NULL);
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
INSERT INTO trial_condition VALUES(1099511627779,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(2199023255553,'zero_order','[[0.0,0.0,0.0]]','[null]','[]');
INSERT INTO trial_condition VALUES(2199023255554,'zero_order','[[0.0,0.0,0.0]]','[null]','[]');
INSERT INTO trial_condition VALUES(10995116277761,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
INSERT INTO trial_condition VALUES(12094627905537,'zero_order','[[0.0,0.0,0.0]]','[0.0003]','[0.0]');
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
INSERT INTO target_trial VALUES(1,1,1099511627778,1099511627781,0,45260.425488638124078,NULL);
INSERT INTO target_trial VALUES(1,2,1099511627779,1099511627787,1,98781.80823029017483,NULL);
INSERT INTO target_trial VALUES(2,0,2199023255553,2199023255553,0,NULL,NULL);
INSERT INTO target_trial VALUES(2,1,2199023255554,2199023255557,1,211098.33705170993926,NULL);
INSERT INTO target_trial VALUES(10,0,10995116277761,10995116277761,0,NULL,NULL);
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
INSERT INTO model VALUES(1099511627777,1099511627778,0,NULL,NULL,X'df5d92df8b5ea13fd32415f9cae1a23f','full',0,0.0010872996778533068097);
INSERT INTO model VALUES(1099511627778,1099511627778,0,NULL,NULL,X'53a27bed32e2b63f9226462049c49b3f','full',0,0.0055879766674469758674);
INSERT INTO model VALUES(1099511627779,1099511627778,0,NULL,NULL,X'1ce8aaab2f2dae3f0d662290c040b83f','full',0,0.022292890305181493892);
INSERT INTO model VALUES(1099511627780,1099511627778,0,NULL,NULL,X'8ab1b73be931c73f283f43e7c09f9d3f','full',0,0.017713776536285644885);
INSERT INTO model VALUES(1099511627781,1099511627778,1,1099511627777,NULL,X'8064129a3865623f51889923a25fa63f','full',0,0.0043544716156057820116);
INSERT INTO model VALUES(1099511627782,1099511627778,1,1099511627777,1099511627778,X'ec04fe586d94ae3f9d756eb5595dac3f','abandoned',0,0.0056433931169331454785);
INSERT INTO model VALUES(1099511627783,1099511627779,0,NULL,NULL,X'5211b83e14b8c83f2d24c8ee0aee793f','full',0,0.031080385154831559335);
INSERT INTO model VALUES(1099511627784,1099511627779,0,NULL,NULL,X'efe8f344ba0ac53f806f20c32fe9af3f','full',0,0.04149197445787445454);
INSERT INTO model VALUES(1099511627785,1099511627779,0,NULL,NULL,X'17654ecd00c89d3fd0e940674dd2b63f','full',0,0.016159247127507526953);
INSERT INTO model VALUES(1099511627786,1099511627779,0,NULL,NULL,X'0061b9e1c6adbd3fa8db5d373b71a73f','full',0,0.025489846520826496545);
INSERT INTO model VALUES(1099511627787,1099511627779,1,1099511627786,NULL,X'712951fb4a71b53facf702f17a04a23f','full',0,0.013103985803177757227);
INSERT INTO model VALUES(1099511627788,1099511627779,1,1099511627786,1099511627785,X'770c646e01c5973f076a14500689b03f','full',0,0.0053711845281788289999);
INSERT INTO model VALUES(2199023255553,2199023255554,0,NULL,NULL,X'df5d92df8b5ea13f','full',0,0.017235207494323338123);
INSERT INTO model VALUES(2199023255554,2199023255554,0,NULL,NULL,X'53a27bed32e2b63f','full',0,0.0073801089276935355129);
INSERT INTO model VALUES(2199023255555,2199023255554,0,NULL,NULL,X'1ce8aaab2f2dae3f','full',0,0.01230972333671031399);
INSERT INTO model VALUES(2199023255556,2199023255554,0,NULL,NULL,X'8ab1b73be931c73f','full',0,0.010429028518805172343);
INSERT INTO model VALUES(10995116277761,10995116277762,0,NULL,NULL,X'3bd92ba26db9b33f17d4612ddd6fad3f','full',0,0.0091139759050395431627);
INSERT INTO model VALUES(10995116277762,10995116277762,0,NULL,NULL,X'4408070477d4c83fd269eadd12b0b03f','full',0,0.018802886408620000241);
INSERT INTO model VALUES(10995116277763,10995116277762,0,NULL,NULL,X'32b23b3c1e12af3f62db43f2a898b03f','full',0,0.0095693893534834397612);
INSERT INTO model VALUES(10995116277764,10995116277762,0,NULL,NULL,X'c86002b1e7b6a63f24538d822ee9ae3f','full',0,0.0070108017561798675193);
CREATE TABLE model_score (
  model INTEGER NOT NULL REFERENCES model (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (model, trial, metric)
) STRICT, WITHOUT ROWID;
INSERT INTO model_score VALUES(1099511627777,1099511627777,1,0.0010872996778533068097);
INSERT INTO model_score VALUES(1099511627778,1099511627777,1,0.0055879766674469758674);
INSERT INTO model_score VALUES(1099511627779,1099511627777,1,0.022292890305181493892);
INSERT INTO model_score VALUES(1099511627780,1099511627777,1,0.017713776536285644885);
INSERT INTO model_score VALUES(1099511627781,1099511627777,1,0.0043544716156057820116);
INSERT INTO model_score VALUES(1099511627782,1099511627777,1,0.0056433931169331454785);
INSERT INTO model_score VALUES(1099511627783,1099511627777,1,0.01308730227422227367);
INSERT INTO model_score VALUES(1099511627783,1099511627778,1,0.049073468035440839796);
INSERT INTO model_score VALUES(1099511627784,1099511627777,1,0.024959782567463336538);
INSERT INTO model_score VALUES(1099511627784,1099511627778,1,0.058024166348285569072);
INSERT INTO model_score VALUES(1099511627785,1099511627777,1,0.016912213185916055713);
INSERT INTO model_score VALUES(1099511627785,1099511627778,1,0.015406281069098994723);
INSERT INTO model_score VALUES(1099511627786,1099511627777,1,0.015021057271204334149);
INSERT INTO model_score VALUES(1099511627786,1099511627778,1,0.03595863577044866588);
INSERT INTO model_score VALUES(1099511627787,1099511627777,1,0.0073869145950796787428);
INSERT INTO model_score VALUES(1099511627787,1099511627778,1,0.018821057011275833109);
INSERT INTO model_score VALUES(1099511627788,1099511627777,1,0.0083762618513091649519);
INSERT INTO model_score VALUES(1099511627788,1099511627778,1,0.0023661072050484930479);
INSERT INTO model_score VALUES(2199023255553,2199023255553,1,0.017235207494323338123);
INSERT INTO model_score VALUES(2199023255554,2199023255553,1,0.0073801089276935355129);
INSERT INTO model_score VALUES(2199023255555,2199023255553,1,0.01230972333671031399);
INSERT INTO model_score VALUES(2199023255556,2199023255553,1,0.010429028518805172343);
INSERT INTO model_score VALUES(10995116277761,10995116277761,1,0.0091139759050395431627);
INSERT INTO model_score VALUES(10995116277762,10995116277761,1,0.018802886408620000241);
INSERT INTO model_score VALUES(10995116277763,10995116277761,1,0.0095693893534834397612);
INSERT INTO model_score VALUES(10995116277764,10995116277761,1,0.0070108017561798675193);
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
INSERT INTO checkpoint VALUES(1,1,0.0012842969999999999993,X'000000000000f03f0000000000001040000000000000084000000000000028400000000000002a400000000000001c400000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000004000000000000026400000000000000040770c646e01c5973f076a14500689b03f0000000000000040770c646e01c5973f076a14500689b03f599c3a5e1800763f00000000000024400000000000000040712951fb4a71b53facf702f17a04a23f0000000000000040712951fb4a71b53facf702f17a04a23fcf71c63343d68a3f','5f9ae2558ff9230c405fcb5578bfddaaaab83be309e62081bb5e65817fe54b59');
INSERT INTO checkpoint VALUES(2,3,0.032006487000000000131,X'000000000000f03f0000000000001040000000000000004000000000000010400000000000001440000000000000f03f00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000040000000000000f03f000000000000f03f53a27bed32e2b63f000000000000f03f53a27bed32e2b63f470ac4e79a3a7e3f0000000000000840000000000000f03f8ab1b73be931c73f000000000000f03f8ab1b73be931c73fa0ab5683d05b853f','fc941e9203cdbc0fe7ae8d876dcc76bf7a2d507a229a32d60cd2bb8e6175935f');
INSERT INTO checkpoint VALUES(10,1,0.43443473900000001419,X'000000000000f03f000000000000f03f000000000000f03f0000000000001040000000000000f03f00000000000000000000000000002a40000000000000f03f00000000000010400000000000000040123c2fc45bb77c3f00000000000008400000000000000000c86002b1e7b6a63f24538d822ee9ae3fe2e3962359aa823f000000000000000000000000000000003bd92ba26db9b33f17d4612ddd6fad3f000000000000104000000000000000000000000000000000000000000000000000000000804f324100000000000000000000000000000000000000000000000000000000000000000000000000000000','a51772f62123cf1493643fb663d1fb8215fb323abd145ccba833fc9456a4c863');
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
INSERT INTO trace VALUES(1099511627779,1099511627777,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf000000000000000000000000000000003cfe9e999999c9bfe04eb2568f4114bf0000000000000000be4ea3999999c9bf6f17d600001c39bf0000000000000000600977959899c9bfd0594be1386351bf0000000000000000ac512d468d99c9bf367fcc6c346662bf0000000000000000d6a87c475699c9bf3c80cda749a270bf000000000000000067e51298a398c9bfe129b5a9411b7bbf0000000000000000085f620bdc96c9bfbd295baf4f8284bf00000000000000003b9397710193c9bffb4f4091835a8dbf000000000000000068387548968bc9bf4f77192c4b1c94bf00000000000000009a0183b9877ec9bfb45a25703b669abf00000000000000005aae0610c369c9bf3fd1370effa1a0bf000000000000000063e049afda4bc9bf712700dd4e37a4bf00000000000000003772d6964824c9bf677b95317cd0a7bf00000000000000006d663b56a1f3c8bfe45f1f78bc4cabbf0000000000000000aab0cfa3a0bbc8bf','8612ca379da688cdc81e95a8cab29b3ce76ce7f46897e3157188be5d2de6e847');
INSERT INTO trace VALUES(1099511627780,1099511627778,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000182d4454fb2179bfd221337f7cd992bfd221337f7cd9a2bf5e3855297a6aafbfdec85dc4cbc6b6bff516b34e6aa1bebfef5326471407c4bf182d4454fb21c9bff516b34e6aa1cebf690091a46c10d2bfb2fd70186802d5bffbfa508c63f4d7bf44f830005fe6dabf8cf510745ad8ddbf6b79f8f32a65e0bf','bc1bc5d559fe0888bb7954bede8024b5f65ca8a3a1ff9d79bcb1edd3390d1a08');
INSERT INTO trace VALUES(1099511627781,1099511627778,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'b7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bf','11a4d3e6d7bf498b02a294423254e4aa25d9a57f566b8692a4898376dfb5d740');
INSERT INTO trace VALUES(1099511627782,1099511627778,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf7e0175dbf3bc543f00000000000000003cfe9e999999c9bfa9883219d7a56e3f00000000000000007e1492750f99c9bf9a9457dc65217e3f0000000000000000716e9312b996c9bf65acbad839a1883f00000000000000007edac1a6c790c9bfce04df85e113923f0000000000000000cfe537091185c9bf5657a7e90fb5983f0000000000000000d172c5454471c9bf6cdbe0bdf209a03f00000000000000003c1a68671e53c9bf27c60ee8b706a43f0000000000000000a62c0c429c28c9bfbe4a53d35f3ea83f00000000000000004021c61126f0c8bfdfc0fc5fe79dac3f000000000000000068efae1eb2a8c8bf189169d72289b03f000000000000000041602d3edc51c8bfbfe1e8717dc4b23f00000000000000009f6fb4f8f0ebc7bffa46bc2d4ef8b43f0000000000000000aa41d031ec77c7bf014dd45ea91cb73f000000000000000042e27d496cf7c6bfe596c7f99f2ab93f000000000000000042ed5ca19b6cc6bf','6d62006e517c10df46142dfa0a6b3e1679515826ced6d9289afe6271c1ef4ddc');
INSERT INTO trace VALUES(1099511627783,1099511627779,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000080182d4454fb2179bf75a7bbe9bbfd95bf75a7bbe9bbfda5bf690091a46c10b2bfea6f88091bb4babf690091a46c10c2bf92d9aeb1532bc7bf24d46e994a0fcdbf0f78e8ad28ded1bfb2fd70186802d5bfaf0ba279eb58d8bf07a27bd1b2e1dbbf5e3855297a6adfbf2e2343c57e60e1bf2caadb75c00be3bf','8cd61271d8dc0a69df52bd1953fd1321279425c8d90f2ea9416d69c48fc3528d');
INSERT INTO trace VALUES(1099511627784,1099511627779,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf333333333333e3bf','5913bee0b9cb490d4f46148aa619d98d3f874e5790d69bfee9b08ab350af338f');
INSERT INTO trace VALUES(1099511627785,1099511627779,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf1347ecca081e583f00000000000000003cfe9e999999c9bfd1e4def81ed2713f0000000000000000cc66e1c5de98c9bf842d2cb7f284813f0000000000000000cb03b884b595c9bf96738a8f9ea38c3f000000000000000023f89026ac8dc9bfe7abf6ef2904953f00000000000000002ddc66fed57dc9bf33f084a3bcb69c3f0000000000000000212419311363c9bf5683044e4aa1a23f0000000000000000df126f03593ac9bfceefbcb4973ea73f0000000000000000bc573a0df600c9bf1ca786fab31cac3f0000000000000000e0aab8aecdb4c8bf632e5fa02c92b03f00000000000000000a6c569a8654c8bfa84c739b241fb33f0000000000000000c1559b44a9dfc7bfad1202960aaab53f00000000000000007578df81ac56c7bfbcb0408e7028b83f0000000000000000ed8d0453f0bac6bf3be198f50791ba3f00000000000000009ea03e9ba80ec6bf04cea6fde4dbbc3f0000000000000000fb4c25ebba54c5bf','47b9c3dd8f6ec16a7f2ee28c3846f4d513a0c16633e43d42f85df259f364ab9b');
INSERT INTO trace VALUES(1099511627786,1099511627777,NULL,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000000000001a849d39a52adb3a24179f3bebd82c3cbbff9e3c9532033d8780483da5aa903d7fa8c73db4e8033ea742273e958f4c3e437f723e22e48b3e','358253ae13223b0f9508568eb2218eb3976ebc31ed965ce04889c46fa7ab2044');
INSERT INTO trace VALUES(1099511627787,1099511627777,NULL,1099511627777,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe0000000000000000cdcc4cbe91067cb800000000cdcc4cbe5255afb900000000c7cc4cbe678b7eba000000007dcc4cbef2460abb00000000faca4cbe3a647ebb00000000dcc54cbeb7e5d1bb000000006eb84cbe095d20bc00000000b79a4cbe3e5767bc0000000088604cbec98c9fbc00000000abf84bbe7b9fd2bc000000006c514bbe8b5805bd00000000e15d4abe17c422bd000000004d1849be607940bd00000000fd8347be826a5dbd00000000fcad45be','fb6a10d57022722b84b154e39412b68d3eb08a957beee4896ac83020edb37cc5');
INSERT INTO trace VALUES(1099511627788,1099511627778,NULL,1099511627777,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'000000009277cebbfd0b99bc41f116bd2e9577bd8e5ab6bd792dfabdf41723be6d9d4cbe6f0c79bedae293be1014acbeafc9c4be2eb5ddbeca8af6be418107bf','b4e271ca1d8111df0665b99060cce8ff0501bc2eac371716b001659eca2c4ba9');
INSERT INTO trace VALUES(1099511627789,1099511627778,NULL,1099511627777,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe982ca53a00000000cdcc4cbeb7df743b0000000080c84cbe0e7df13b00000000bcb54cbe0b01463c00000000a7854cbe83c3913c000000002a264cbe53ccc73c000000008b834bbe7e10023d000000001f8a4abe66d6223d00000000ee2749bed3a2453d00000000394e47bea0d9693d00000000bcf244be006e873d000000009c1042beae069a3d00000000f3a83ebe296cac3d00000000e4c23abeae59be3d00000000576b36be6192cf3d0000000048b431be','815fb0d6c7c9575f39062e27b9725dfd0ce51856c6a642f2a0892726c2d47e1d');
INSERT INTO trace VALUES(1099511627790,1099511627778,NULL,1099511627788,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000003ffc3bb289e91bcb5f00fbdb59f6cbd1baaaebd0625f0bd19e21cbe993a45be288a70be661c8fbe81d5a6be2a22bfbeebb4d7be3d42f0bec84004bf','8673d1f19edba24396fa5e84b7743c70c0309d6a6e9ad30b0070617ac2df8155');
INSERT INTO trace VALUES(1099511627791,1099511627778,NULL,1099511627788,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe21cc9c3a00000000cdcc4cbed3fc683b00000000eac84cbea849e63b00000000dab74cbebc3e3d3c00000000e28b4cbe88a08b3c0000000013344cbef1cfbf3c00000000b59d4bbec448fa3c00000000ceb54abe01051d3d00000000b36a49be92fd3e3d000000007ead47be4a79623d00000000507345be786f833d0000000056b642bec2ca953d0000000065763fbe8c04a83d0000000037b93bbec6d7b93d00000000488a37be5006cb3d0000000048fa32be','3314f9f8e99d6189a23d011e17318544b39fbb7bb9b6927a42b46f8500a650df');
INSERT INTO trace VALUES(1099511627792,1099511627779,NULL,1099511627788,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000ac5be6bb9425abbc702c29bddb0c8bbd8e46cdbd8b1c0dbebb5d38bea2c567bea9548dbea52ba8be5d0dc4be5d9fe0beae88fdbea1390dbf92861bbf','8926e9638173bdd16d55ae64d7404b795b6269cbb3549538e1549271be84d1f7');
INSERT INTO trace VALUES(1099511627793,1099511627779,NULL,1099511627788,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe8849b83a00000000cdcc4cbeaeea883b000000006fc74cbe4853073c00000000ddaf4cbe83645e3c0000000022734cbe040da43c00000000e1f94bbe3549e13c000000004c2a4bbecfe6123d0000000054ea49bed82d383d00000000ce2148bed3ca5f3d0000000086bc45bee881843d00000000fdab42beda8c993d00000000c2e83ebe6fa7ae3d0000000039733abe1e77c33d00000000d15335bee9a8d73d00000000a59a2fbe3af4ea3d000000009a5e29be','c6acabfee5cdcc857cf29c4485a103a6672474aff42f8c29ff8311a456375f15');
INSERT INTO trace VALUES(2199023255553,2199023255553,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000000000000000000000182d4454fb21693f182d4454fb21693fd221337f7cd9823f5e3855297a6a8f3fbbb2ccbe3a469c3f75a7bbe9bbfda53f98bd4cef4c7eb03fdec85dc4cbc6b63ff516b34e6aa1be3fef5326471407c43f641cf36673bdc83f8cf510745ad8cd3f5b6797c0a079d13f','44d93e69444bc1d3561f175e21393a8f978b3e619f4bb0634a38d0f23d08b8c9');
INSERT INTO trace VALUES(2199023255554,2199023255553,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',15,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000004651419103aeae3f3d51419103aebe3ff0fcf0ac8202c73f4251419103aece3fc7d2c83ac22cd33ff0fcf0ac8202d73f1927191f43d8da3f4251419103aede3fb4bdb401e241e13fc9e1626cbab2e03f68999d66b48fdd3f406f75f4f3b9d93f17454d8233e4d53fee1a2510730ed23f','fa8b46880d7beeb9daf180eb74107cc0358d1c8d70f8a752c9335355a2570856');
INSERT INTO trace VALUES(2199023255555,2199023255554,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000182d4454fb2169bf182d4454fb2189bfbbb2ccbe3a469cbf182d4454fb21a9bf3b43d5598ca2b3bfbbb2ccbe3a46bcbfd221337f7cd9c2bffbfa508c63f4c7bf8cf510745ad8cdbf0f78e8ad28ded1bf0c86190fac34d5bfaf0ba279eb58d8bfac19d3da6eafdbbfaa27043cf205dfbfd39a9ace3a2ee1bf','1e717076ed3a502edfe9883bef003df855447947b19708bbe510a1c1cf8bb5a0');
INSERT INTO trace VALUES(2199023255556,2199023255554,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',15,'float64',X'00000000000000007b14ae47e17a943f',X'b7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bfb7d7bba7efa4e0bf','64747528a824da3b3032dd94c3cc38f66e3922cfde287fee1e76d5bfd3c5acf6');
INSERT INTO trace VALUES(2199023255557,2199023255553,NULL,2199023255554,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'000000000000000044a9453aa045423b186aee3b0bd1693c1a6ec83c45eb1c3da21c663d0e86a03d1558d73d48ee0a3ef4a92c3e058c4f3ef051723e65e6893e','be497d0696b4bbc4b5d593d855657bc0d7d535527a12d575b373337e748bd1a2');
INSERT INTO trace VALUES(2199023255558,2199023255553,NULL,2199023255554,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe0000000000000000cdcc4cbe04211eb900000000cdcc4cbee76a1bba00000000b6cc4cbe30bbbeba0000000003cc4cbe080d3bbb0000000039c94cbe1656a0bb000000003ec14cbe0909fbbb00000000a9ae4cbe220738bc000000001c894cbe265480bc00000000bf444cbe750bacbc00000000ded14bbee0c4ddbc0000000028224bbefb9b09bd000000007e2d4abea61825bd0000000049f348be2f4f40bd00000000537b47be2f4c5abd000000007dd545be','7445cdb6936552167b09f13a68c05681251fc2101f270b07c337090f243c3d13');
INSERT INTO trace VALUES(2199023255559,2199023255554,NULL,2199023255554,'predicted','[{"name":"angle","unit":"rad"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'00000000e777d6bb112c9dbc324919bdd4b078bda339b5bd640ff6bde4cc1ebe6a4b45bea3e36dbec4fc8bbe5e7ba1be3226b7be55baccbe05fae1be1badf6be','8846cb27b56eb5d1fafc1cdb896ae77c89ac1d0bf69cb4bafe7b2c27f7c72471');
INSERT INTO trace VALUES(2199023255560,2199023255554,NULL,2199023255554,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float32',X'00000000000000007b14ae47e17a943f',X'0000000000000000cdcc4cbe4793ab3a00000000cdcc4cbe64797b3b000000003dc84cbe9b3cf53b00000000e0b44cbe7ae3463c00000000a0844cbe82dc903c0000000061274cbe4384c43c00000000bf8c4bbe5f50fd3c00000000a1a54abeb30f1d3d00000000926549be74e63c3d00000000c2c347be0c9c5d3d00000000b8bb45be70a57e3d00000000a14d43be2bc08f3d00000000507e40be24db9f3d00000000df563dbe876faf3d0000000022e439be2c51be3d00000000dc3536be','b55a7688be78ae92c1ec9925e81307d8110e3e3d9c244cc9f883bcf74b789c7b');
INSERT INTO trace VALUES(3298534883329,3298534883329,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fa8305cb673d9823fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f3435fe473946ac3fd221337f7cd9b23f182d4454fb21b93f5e3855297a6abf3fd562aa3d043ec33f806a2125532bc73fb530de412b7dcb3f6179cce701cfcf3f4d4080e1b042d23fa46477349c6bd43ffa886e878794d63f15eccc9573bdd83f68cf4c2ad781da3fbbb2ccbe3a46dc3f89b499b5d273dd3f12d7c311266fde3fd956a28baed3de3f5bf7dd6af205df3f9377fff069a1de3f0b55d59416a6dd3fbbb2ccbe3a46dc3f68cf4c2ad781da3fcccbb23ca726d83ff0c5084cf066d53fcc9f44026d10d23fc234bb3b4a0fcd3f6f25cd6cac34c53f182d4454fb21b93f503db83b776a9f3fee20ad669e6ba4bf3435fe473946bcbf806a2125532bc7bf6179cce701cfcfbf22c43b555839d4bf4a2b775d63f4d7bf36d119216fafdbbfd956a28baed3debf5a2e26beb2c9e0bf2830f3b44af7e1bfd221337f7cd9e2bffa72376a6a89e3bfa02300761407e4bf22c43b555839e4bf22c43b555839e4bf','4dc4de9d3675c04cae360a1e78f8918d71f463db13dc449d11b1bace9d0bb135');
INSERT INTO trace VALUES(3298534883330,3298534883329,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(3298534883331,3298534883330,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',62,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'000000000000000000000000000000000000000000000000df40d09def21693f89292cf2826a8f3f503db83b776a9f3f2631214e1ab4aa3fd9a321fc8ba2b33f2631214e1ab4ba3fc85ecd43e5abc13f75a7bbe9bbfdc53f23f0a98f924fca3f58b666ac6aa1ce3f827f2aa9a079d13f5703e61c4870d33f28462ad26702d53ffa886e878794d63fc88a3b7e1fc2d73f15eccc9573bdd83f9acd7f333f54d93f1b6ebb128386d93f1b6ebb128386d93f182d4454fb21d93f934b91b62f8bd83f4a2b775d63f4d73fc2084d0110f9d63f7266442b3499d53f5703e61c4870d33ffa5c004d4d7ed03f1faf32d10aebc93fc85ecd43e5abc13fc41d56855d47b13fa8305cb673d982bffc248a60bdfdb5bf6ae455ae24d0c4bf5375efede23ccebf5703e61c4870d3bf47eaff9edb8fd7bf6b10c4e85ee6dabf0b55d59416a6ddbf6179cce701cfdfbfd98deade6e97e0bffd9d770bd5e2e0bffd9d770bd5e2e0bf98bd4cef4c7ee0bfe0d89008be9cdfbf0b55d59416a6ddbf6f513ba7e64adbbf12ab55d7eb58d8bf28462ad26702d5bf7bfd3b2c91b0d0bf7c29aa66cbc6c6bfe02510799b6bb4bf182d4454fb21993fc85ecd43e5abc13fb57d5db2084cd03f47eaff9edb8fd73f9377fff069a1de3f5081f79f38a7e23fb236e21a56b2e53faf0ba279eb58e83fea6f88091bb4ea3f','dbeaec820e7395155e17a615b3f207c5f182be74a2c0f1c659b1d5c4ef58e26c');
INSERT INTO trace VALUES(3298534883332,3298534883330,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(3298534883333,3298534883331,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',31,'float64',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000df40d09def21693fdf40d09def21793fdf40d09def21893fe01cd06c7fd9923f3435fe4739469c3fee20ad669e6ba43f4239db4158d8ad3fd9a321fc8ba2b33f1faf32d10aebb93f32dd21d3c419c03fd9a321fc8ba2c33f83ab98e3da8fc73fb530de412b7dcb3f6179cce701cfcf3fcc9f44026d10d23f22c43b555839d43f78e832a84362d63f12ab55d7eb58d83fe62e114b934fda3f3a1291dff613dc3f','f6d97370b1a91e9b8be4be92322cc4dd59ee3408a3267f809f0ba669f3e105e6');
INSERT INTO trace VALUES(3298534883334,3298534883331,3298534883329,NULL,'predicted','[{"name":"angle","unit":"rad"}]',31,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3f',X'0000000000000000000000000000000077346037ab90a638f32d97393a37483abad8dc3ab7d5573bed5fc03baed91f3cce9a7a3c033dbb3c2f33063d0f93393db485783d8bada13d69e8cc3d577efd3dbc67193ec60b363e2a3e543e938a733e32b9893ef8bb993e638fa93e29f4b83e3aafc73e7689d53eee50e23e','d67fe685148f8d12ff6a7a250b3edb562df299aa27fbaaf64a3dffb94b717e66');
INSERT INTO trace VALUES(6597069766657,3298534883329,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(6597069766658,3298534883330,6597069766657,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(7696581394433,3298534883329,7696581394433,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'00000000000000000000000000000000482cd826ad1b0728bd26bd28e46a51297ca9ca2955accb382a69153a57a7e13a9b25803b9bbff53bc6de523c0b02a73c10e5f83c66b4303d8522713db31c9f3d3a0acc3d9d29ff3d4c041c3e81f83a3e91f45b3e125b7e3eddb9903e0e37a23e6b32b33e4132c33e49b9d13edd49de3e4067e83eb49def3e5d81f33ed6b5f33e7070f03e3f77e93e3fa5de3e19efcf3e5260bd3ede20a73efb708d3e9856613e8384223e86f1be3d10f8ca3cae183abd5fd3edbd1c7d3ebe7afe81bed51da3be5d15c2befb6edebe63c6f7befce606bff42410bfc88917bf820b1dbf11a920bfd36822bfd36822bf','36c4f6153894c48b53ce2d168f2cc17584f99f11e9bf09e83c2f82588caa3f34');
INSERT INTO trace VALUES(7696581394434,3298534883330,7696581394433,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'03453bb903453bb903453bb9ef17753bb4de603c30a5f03cb5554d3d93309a3d6f0dd53de3b20a3e879f2c3e22484f3e22a9713ed863893e67dc983ec8d3a63e26edb23e5ddbbc3e7a62c43ec058c93e35a7cb3e35a7cb3ead87c93edc60c53ec758bf3e13a2b73ed592ac3ed2ea9a3eb147833e90e44c3e08b20a3e8b21843db0c92bbca9bdb2bdc77f27be6bdf72be2ab39cbe539abcbe8156d8bed93defbea16600bf935406bfc14e09bfc14e09bf6aa206bfa16601bfe291f3be700de0bed3d7c8bedefaadbe5baf8abe2bf33ebed317b7bdbdf78c3c1219053e255a7b3e9477b83e704ff13e8361133f45ca2b3fdc5e413f9fb7533f','27d81229783712f556e41adf13e24e00051325859acf9aa24c10dec049de6c0f');
INSERT INTO trace VALUES(9895604649985,3298534883329,9895604649985,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'0000000000000000000000000000000077346037ab90a638ab2a893957962c3a8325b93a4e7a303b03ee9a3be83efe3b51c4453c63fe923ca14cd23c7983113dfa94433df312803dd9dda33d4043cd3d4631fc3d0f30183e93a7343ef121533e6725733e750e8a3ecfae9a3e8d14ab3e01d8ba3e1c8cc93e72c1d63e0109e23e0af5ea3ebb20f13eaa2ef43ef5cff33e0dc4ef3e18e1e73e1413dc3efb5fcc3e43e4b83ebfd7a13ebe88873ee1ba543e60a1153e22b7a53d556d593ce3c163bd05f6febdc2ce44be08e183be93a2a3bed634c1be4a32dcbe0247f4be809a04bf73670dbf7c7d14bf2dd819bff27a1dbf856f1fbf29c61fbf','fc9eb1bf8c9a37795f7e88ce3edb43019c9512f58d90713ed951552b7ff8b085');
INSERT INTO trace VALUES(9895604649986,3298534883330,9895604649985,NULL,'predicted','[{"name":"angle","unit":"rad"}]',62,'float32',X'0000000000000000b81e85eb51b89e3fb81e85eb51b8ae3f0ad7a3703d0ab73fb81e85eb51b8be3f333333333333c33f0ad7a3703d0ac73fe17a14ae47e1ca3fb81e85eb51b8ce3f48e17a14ae47d13f333333333333d33f1f85eb51b81ed53f0ad7a3703d0ad73ff6285c8fc2f5d83fe17a14ae47e1da3fcdccccccccccdc3fb81e85eb51b8de3f52b81e85eb51e03f48e17a14ae47e13f3d0ad7a3703de23f333333333333e33f295c8fc2f528e43f1f85eb51b81ee53f14ae47e17a14e63f0ad7a3703d0ae73f000000000000e83ff6285c8fc2f5e83fec51b81e85ebe93fe17a14ae47e1ea3fd7a3703d0ad7eb3fcdccccccccccec3fc3f5285c8fc2ed3fb81e85eb51b8ee3fae47e17a14aeef3f52b81e85eb51f03fcdccccccccccf03f48e17a14ae47f13fc3f5285c8fc2f13f3d0ad7a3703df23fb81e85eb51b8f23f333333333333f33fae47e17a14aef33f295c8fc2f528f43fa4703d0ad7a3f43f1f85eb51b81ef53f9a9999999999f53f14ae47e17a14f63f8fc2f5285c8ff63f0ad7a3703d0af73f85eb51b81e85f73f000000000000f83f7b14ae47e17af83ff6285c8fc2f5f83f713d0ad7a370f93fec51b81e85ebf93f666666666666fa3fe17a14ae47e1fa3f5c8fc2f5285cfb3fd7a3703d0ad7fb3f52b81e85eb51fc3fcdccccccccccfc3f48e17a14ae47fd3f',X'bef08b39004e0fb95ca909ba4737643bb0b6643c2e39f93c6aeb553d58f2a03d9e6fde3d97b7103efcec333ec4c8573e63407b3ee6aa8e3e2a8f9e3e46e4ac3e7650b93ea28ac33e905bcb3e839ed03e7241d33ece44d33ee8bad03e01c7cb3e0b9cc43e0a7bbb3ececdae3ed4709b3e2a1e823eca70473ebf87023e30f15e3d5ec1b4bc8627ccbdde6134be434f7fbe856da2bed1a1c1bed087dcbe5f89f2bef69b01bf2e2607bf20d309bf5da509bf92b106bfc41d01bfc740f2be3afeddbe8f1ac6be6badaabe450787be4a8437be4f66a9bdb9f1b83c217d083e3af27b3eff13b73efa05ee3ecdb9103f401b283ff2af3c3fb21b4e3f','a54356cefe4acb85a0e9678fa57cfec8eb88e3059ea8920dda6bd7dc937ad0ba');
INSERT INTO trace VALUES(10995116277761,10995116277761,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'00000000000000000000000000000000000000000000008000000000000000800000000000000000182d4454fb21693f182d4454fb21893f75a7bbe9bbfd953fd221337f7cd9a23fbbb2ccbe3a46ac3fd221337f7cd9b23faf0ba279eb58b83f8cf510745ad8bd3f4cce9ddcd4e2c03fd221337f7cd9c23fef5326471407c43f','2bc473e180dae2dd4c30840875118384fd914750896ee7054586913dcb213bff');
INSERT INTO trace VALUES(10995116277762,10995116277761,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'8afe5dce2a18b4bfb048716da62991bf9fa2f4dc5642b23f72ede6a9f6d3c53fde3d67b28ae0d03fd536e70c4f6cd53feab8aa900ec4d73f6ebe408e1580d73fb80092d024acd43fb289ffbad28acf3fd33a7a2baf49c33f0482c9293ecdaa3f889388b37a2ca0bf4a8be2d9102cb6bf4ab86883606bbabf4ab86883606bbabf','00138b9a0bc7786d23a1699327d8207a7de244f67ea6e8a5bb208c9fbc60b38e');
INSERT INTO trace VALUES(10995116277763,10995116277761,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bffb57f9cae9bf103f00000000000000001a94ae839999c9bfbcbaf4e6cc5e263f00000000000000003d1e37fd9899c9bfe706e5b55bbc243f000000000000000015cf3b139999c9bffc54686eafea1abf0000000000000000fa62ff609999c9bf0d0a9928d9af4bbf0000000000000000f73fc2a08a99c9bff09eb3a88c8062bf000000000000000021a85f9e2e99c9bf6f60e0834e3472bf00000000000000000f26584dfb97c9bf8e4f6bf927467ebf0000000000000000f1eaa68f1f95c9bf09e557dd167886bf0000000000000000bdb86565bb8fc9bf45cfdedb26a28ebf0000000000000000ec9830fe3e87c9bf1fa8c1ab058493bf00000000000000008a8411f8c67bc9bf4d25de5e4d8397bf0000000000000000b083f6ca436ec9bf6b3aeeb457059bbf00000000000000009aebb4f14e60c9bfffe0720202d49dbf0000000000000000d7b99bd7b753c9bfb15db8a481d49fbf0000000000000000d60da29ff649c9bf','d163c782442029ba5c4b2ae262c21c39b566d8a0e97ac77c8788de2f883455cd');
INSERT INTO trace VALUES(12094627905537,12094627905537,NULL,NULL,'measured','[{"name":"angle","unit":"rad"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000008000000000000000800000000000000000182d4454fb21693fd221337f7cd9823fd221337f7cd9923fbbb2ccbe3a469c3f00dfeec95c47a13fa46477349c6ba43f75a7bbe9bbfda53f75a7bbe9bbfda53fa46477349c6ba43f00dfeec95c47a13fbbb2ccbe3a469c3f75a7bbe9bbfd953fd221337f7cd9923f','06ce5587e16d161c219c735c66a359e70ade2fcab9cafcf4794da79b3cac5436');
INSERT INTO trace VALUES(12094627905538,12094627905537,NULL,NULL,'commands','[{"name":"motor","unit":"N*m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'0000000000000000fb7e6abc7493b83ffb7e6abc7493c83f3bdf4f8d976ed23fd6cef753e3a5cb3fb61e85eb51b8be3f007f6abc7493983f40df4f8d976eb2bf1b2fdd240681c5bf4b37894160e5d0bfb61e85eb51b8cebf40df4f8d976ec2bf007f6abc7493a8bf007f6abc7493a83f40df4f8d976ec23f40df4f8d976ec23f','918dd5350a1f18fbddf009cb1aeb7a7f9d3b855209d768e631f4cceb3388ddf2');
INSERT INTO trace VALUES(12094627905539,12094627905537,NULL,NULL,'centre_of_mass','[{"name":"x","unit":"m"},{"name":"y","unit":"m"},{"name":"z","unit":"m"}]',16,'float64',X'00000000000000007b14ae47e17a943f',X'000000000000000000000000000000009a9999999999c9bf000000000000000000000000000000003cfe9e999999c9bfa1ad08021b5726bf0000000000000000be4ea3999999c9bf8087b57dbea148bf00000000000000000e66af529599c9bf2ba77e513a2660bf000000000000000009d7b05a6d99c9bf3e09da60098e6dbf0000000000000000a4969797de98c9bf8428047e410876bf00000000000000007a8a9057c197c9bfc9f405f6c0b67cbf00000000000000000d7d02463696c9bf980726bcd5de80bf000000000000000036dda07dac94c9bf523626314e0b82bf00000000000000004da704d0c593c9bf2a1b7e6a4ab781bf0000000000000000ade958b1e593c9bfa18ab0e17a1080bf0000000000000000aa192b88f494c9bfc3b2c79758517bbf000000000000000095ad12e46296c9bf27d64ecd1f1f76bf0000000000000000f8c4bbdcaf97c9bf0dfb582f1aa271bf000000000000000073b9c6bd8f98c9bfa3b7fbf941ce6dbf0000000000000000a1e2e68cef98c9bf','c8e8442f43be46cd6d4d72ea350c0670adc09d8939f084563d658305adc6b635');
CREATE TABLE robot_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
INSERT INTO robot_file VALUES(1,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
INSERT INTO robot_file VALUES(2,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
INSERT INTO robot_file VALUES(10,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
INSERT INTO robot_file VALUES(11,'robot.toml','5a1586e69134f90045f874fba346d4c609c75fe38aae563eb276c686a9fdc507');
CREATE TABLE carried_out (
  trial INTEGER PRIMARY KEY REFERENCES trial (id),
  run INTEGER NOT NULL REFERENCES run (number),
  test TEXT NOT NULL,
  target TEXT NOT NULL CHECK (length(target) = 64)
) STRICT;
INSERT INTO carried_out VALUES(12094627905537,11,'triangle motor 0.3 N*m 4 Hz 0.3 s','f8115daa0c03f33109d03b0a8bea08381f5d83115673d6960f369f1f132a2973');
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
INSERT INTO diagnosis VALUES(4398046511105,3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 92d30f8105f5e72aa89268185a40abbbc02f7ab1 dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964 af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18 diagnosis segments 0 among [coulomb_friction,joint_offset_torque] process joint.hinge 0.0005 0.02 d77c95d40bffff86993d23c5998485bd7a6c83bb246a33cb6276ba75be58b840 9c84e5118b3bfb94f803db6d3d58ce60da8b300ed1acd0b3a0e086e9f2e12c86 fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3 db595805fcd4cf72457458f1265c66079946ec3e8949cb0026c9af38fc572568 481dce5f636acc299ffb8a72723f856220e1d1f24649bf1ea042999f19975b87 900ad9deb42ab1bfa2dd609b73a707755dfe0a270356a04ffdd4873e3b92c70e 39d0011ae29f62e9cf1a7defccefc191171ab39723081a72c2cd51d4ce9f205c 2b57144dd30600988a1a38f01bb720049cb0d4d7991a42efda864548b55a0a9e eb5d5162e2a2b105c827b0165024318b7a4bfb4ea89490947d466cd768f0c9f1 cf99d1ce492c5c79622bf209b291b67590596e04490350bc8e183e95c51e5ae1','effect_found',0.91858771853104614901,1,0.0005000000000000000104,2,2.1771807558280666938,replace('{\n  "verdict": "effect_found",\n  "probability": 0.9185877185310461,\n  "calibrated": true,\n  "evidence": {\n    "further_effects": 0.0,\n    "log_base_error": 0.33789448691886675,\n    "log_error": -0.144209587039004,\n    "log_gain": 1.2643948800386284,\n    "log_lead": 1.2121879572167236,\n    "look_alikes": 0.0,\n    "structure": 0.39040559077478,\n    "sureness": 3.094772954546103,\n    "surprise": 3.3010299956639813,\n    "unsteady": 0.0\n  },\n  "noise_floor": {\n    "angle": 0.0058317511707871245\n  },\n  "units": {\n    "angle": "rad"\n  },\n  "random_forces": [\n    {\n      "joint": "joint.hinge",\n      "deviation": 0.017944317956411104,\n      "unit": "N*m",\n      "duration_s": 0.025\n    },\n    {\n      "joint": "joint.hinge",\n      "deviation": 0.006052525795157136,\n      "unit": "N*m",\n      "duration_s": 0.25\n    }\n  ],\n  "base": {\n    "fit_rmse": {\n      "angle": 0.009339468811709226\n    },\n    "cv_rmse": {\n      "angle": 0.012696776421815523\n    },\n    "ratio_to_floor": 2.1771807558280667\n  },\n  "ranking": [\n    {\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.022226442646691307,\n              "ci95": [\n                0.014009405946348804,\n                0.03044347934703381\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "class": [],\n      "fit_rmse": {\n        "angle": 0.003300003355619166\n      },\n      "cv_rmse": {\n        "angle": 0.004183978056910151\n      },\n      "ratio_to_floor": 0.7174479730666269,\n      "gain": 15.300013241822448,\n      "gain_ci95": [\n        7.424023131712452,\n        24.392516424075744\n      ],\n      "gain_standard_error": 4.610703606488695,\n      "probability": 0.9999997424313587\n    },\n    {\n      "effects": [\n        {\n          "effect": "joint_offset_torque",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.0028394421980790035,\n              "ci95": [\n                -0.002943041800983546,\n                0.008621926197141553\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "class": [],\n      "fit_rmse": {\n        "angle": 0.00864179509882325\n      },\n      "cv_rmse": {\n        "angle": 0.0132824139447086\n      },\n      "ratio_to_floor": 2.2776029970626888,\n      "gain": -1.990760188236492,\n      "gain_ci95": [\n        -5.936159654988189,\n        1.5589613500162027\n      ],\n      "gain_standard_error": 2.0100713032149207,\n      "probability": 3.0953687918028195e-08\n    }\n  ],\n  "segment_lengths": [\n    {\n      "segment_s": 0.1,\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.00139116464363727,\n              "ci95": [\n                0.0,\n                0.025786572733837453\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "against": 2.7794124256371946\n    },\n    {\n      "segment_s": 1.83,\n      "effects": [\n        {\n          "effect": "coulomb_friction",\n          "where": "joint.hinge",\n          "parameters": {\n            "torque": {\n              "value": 0.013462062826734978,\n              "ci95": [\n                0.006678157869050813,\n                0.020245967784419144\n              ],\n              "unit": "N*m"\n            }\n          }\n        }\n      ],\n      "against": 6.394096095768383\n    }\n  ],\n  "p_by_chance": 0.0005,\n  "chance_95": 2.382278515189669,\n  "free_force": {\n    "p": 0.407,\n    "gain": {\n      "value": 0.07106356866224006,\n      "standard_error": 0.17200303553995283,\n      "ci95": [\n        -0.2558134688042726,\n        0.3464147468971879\n      ]\n    }\n  },\n  "answer_gain": {\n    "value": 18.382089658405693,\n    "standard_error": 5.939721565487739,\n    "ci95": [\n      8.215705595113038,\n      29.85936986251773\n    ]\n  },\n  "formulas": [],\n  "formulas_of_rest": true,\n  "residual_force": [],\n  "hypotheses": 2,\n  "findings": [\n    "what is left depends on no joint''s position, velocity or command",\n    "joint.hinge.damping (28.9 mN*m*s/rad → 20.7 mN*m*s/rad) had soaked it up",\n    "over segments of other lengths, coulomb_friction @ joint.hinge: torque 0.00139 at 0.1 s, 0.0222 at 0.5 s, 0.0135 at 1.83 s (N*m): they agree within what is uncertain of them"\n  ],\n  "next_test": "",\n  "next_test_worth": "",\n  "not_testable": [],\n  "seconds": 0.117069151\n}\n','\n',char(10)));
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
INSERT INTO candidate_model VALUES(4398046511105,1,'["coulomb_friction @ joint.hinge"]','[]',15.300013241822448151,7.4240231317124516507,24.392516424075743942,0.71744797306662688729,0.99999974243135869578);
INSERT INTO candidate_model VALUES(4398046511105,2,'["joint_offset_torque @ joint.hinge"]','[]',-1.9907601882364920342,-5.9361596549881889828,1.5589613500162027293,2.277602997062688761,3.0953687918028194865e-08);
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
INSERT INTO candidate_value VALUES(4398046511105,1,0,'coulomb_friction','joint.hinge','torque','N*m',0.022226442646691307175,0.014009405946348803956,0.030443479347033810394);
INSERT INTO candidate_value VALUES(4398046511105,2,0,'joint_offset_torque','joint.hinge','torque','N*m',0.0028394421980790034674,-0.0029430418009835459559,0.0086219261971415533246);
CREATE TABLE unfinished_diagnosis (
  revision INTEGER NOT NULL REFERENCES revision (id),
  settings TEXT NOT NULL,
  document TEXT NOT NULL CHECK (json_valid(document)),
  PRIMARY KEY (revision, settings)
) STRICT, WITHOUT ROWID;
INSERT INTO unfinished_diagnosis VALUES(3298534883329,'free_run segments 0.1,0.5 horizon whole starts 1 loss huber 3 iterations 50 seed 1 lacuna 92d30f8105f5e72aa89268185a40abbbc02f7ab1 dddb06b2fd24273c3379450091a92b3c66a1766d4b257569721e35ec00385964 af607e1d7ae276d39716455ddee729924f94e7e0bde0f3883355b17fef150f18 diagnosis segments 0 among [coulomb_friction,joint_offset_torque,sensor_delay] process joint.hinge 0.0005 0.02 d77c95d40bffff86993d23c5998485bd7a6c83bb246a33cb6276ba75be58b840 9c84e5118b3bfb94f803db6d3d58ce60da8b300ed1acd0b3a0e086e9f2e12c86 fce0fe8ed513e9cb543c1357fd17aae139e388fd118fbfd879118e7a3dce03e3 db595805fcd4cf72457458f1265c66079946ec3e8949cb0026c9af38fc572568 481dce5f636acc299ffb8a72723f856220e1d1f24649bf1ea042999f19975b87 900ad9deb42ab1bfa2dd609b73a707755dfe0a270356a04ffdd4873e3b92c70e 39d0011ae29f62e9cf1a7defccefc191171ab39723081a72c2cd51d4ce9f205c 2b57144dd30600988a1a38f01bb720049cb0d4d7991a42efda864548b55a0a9e eb5d5162e2a2b105c827b0165024318b7a4bfb4ea89490947d466cd768f0c9f1 cf99d1ce492c5c79622bf209b291b67590596e04490350bc8e183e95c51e5ae1','{"format":2,"added":[{"id":"coulomb_friction","effect":"coulomb_friction","where":["joint.hinge"],"start":{},"fixed":[],"range":{}}],"values":[0.5504575604868243,0.020403864688482008,0.02076962249388681],"states":[[-0.005787812302564955,0.08922817226087319],[0.005944356354813348,0.13400261973755254],[0.356099244771237,1.1072339787968057],[0.22509896208477673,-1.9366704169148445],[0.002002189868624199,-0.03693622303198182],[0.2715501097511099,1.0577564485516306],[0.26007360232740717,-1.7283952921885681],[-0.5251085347756674,0.1929645857864924]],"last":{"added":[],"rivals":[{"entry":[{"id":"coulomb_friction","effect":"coulomb_friction","where":["joint.hinge"],"start":{},"fixed":[],"range":{}}],"values":[0.5504575604868243,0.020403864688482008,0.02076962249388681],"states":[[-0.005787812302564955,0.08922817226087319],[0.005944356354813348,0.13400261973755254],[0.356099244771237,1.1072339787968057],[0.22509896208477673,-1.9366704169148445],[0.002002189868624199,-0.03693622303198182],[0.2715501097511099,1.0577564485516306],[0.26007360232740717,-1.7283952921885681],[-0.5251085347756674,0.1929645857864924]],"timed":true,"gain":[11.876401422394954,3.7939975976877705,5.364817782214774,19.571185772288818]},{"entry":[{"id":"sensor_delay","effect":"sensor_delay","where":["sensor.angle"],"start":{},"fixed":[],"range":{}}],"values":[0.5542626857415206,0.029035885341872632,0.010689211739086572],"states":[[-0.0014568846658399416,0.026889278322992684],[0.009967945618103359,0.10602345063454487],[0.3710087193023121,1.0303984393724623],[0.20456558477594744,-2.0261738759475154],[0.004127052796809508,-0.014562846668790983],[0.28668059523630274,0.968331892058357],[0.24093279576669133,-1.8606005991000412],[-0.5192296098727476,0.24695848956505467]],"timed":true,"gain":[-0.13547423558440475,0.13465800972881561,-0.4308604777612013,0.0635406852020095]},{"entry":[{"id":"joint_offset_torque","effect":"joint_offset_torque","where":["joint.hinge"],"start":{},"fixed":[],"range":{}}],"values":[0.5568235572530474,0.028641270727989533,0.00278809713555583],"states":[[-0.0010464809179776356,0.017236391482824544],[0.00926654088777654,0.07770535020978289],[0.36025699002000716,1.0427647879097879],[0.2263786702179577,-1.9580538724853997],[0.004713712443944501,-0.020238873806515862],[0.27665877993979077,0.9816344995865157],[0.26103415519838713,-1.7273211849598054],[-0.5209445459460649,0.10529947288490461]],"timed":true,"gain":[-1.9081323106068622,1.6036218044528776,-5.003639833988623,0.9308715810161354]}],"chosen":0,"timing":[[0.014297210289708318,0.07075419245838788,0.19538838989338903,0.4259475619689619,0.8105472465713586,1.3774398894452666,2.1918106036674807,3.267274425788787,4.652386340314878,6.34266507219826,8.353365266088,10.661407420405062],[3.303255023080891,5.4859774539488155,8.131833180150188,11.153093491089333,14.45319847605906,17.901491160968277,21.352526339104823,24.651168761479884,27.637852870252846,30.153714493095165,32.059585148855405,33.22496912289957,33.530812727467136,32.88565800800206,31.225944526451826],[-0.6169351348015759,-1.3954186899981695,-2.5917120981811896,-4.280165486626725,-6.477998889494419,-9.202836049600695,-12.399901036690036,-16.015369122735002,-19.953627225689818,-24.136859833740353,-28.434669681119022,-32.74044779036824,-36.9176166746404,-40.834659039267144,-44.37129307818836],[-5.174180870824339,-8.364269625398968,-12.094420676252302,-16.215899636623664,-20.577795593954008,-25.03306792664926,-29.44345604412679,-33.66866037708631,-37.569042798326066,-41.05010766806064,-43.98975911318825,-46.3106558032282,-47.9354569099986,-48.80072826357767,-48.84225805364337,-48.02440665604891],[11.584182464744035,18.001591464571383,23.74945916286588,28.67406413528993,32.65062492178714,35.586937980254326,37.4256474881846,38.1449737594023,37.75787743431013,36.3097989475044,33.87525141713504,30.553631692668127],[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,-3.945515426517069,-15.181935634937641,-25.729797945006887,-35.29028047863558,-43.59479889456924],[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0],[0.0,0.0,0.0,1.3570081672399796,14.205342233002249,27.640750852515573,39.86820640529195,50.542786943127446,59.39918072314451,66.26831729478728,71.08224335491647,73.86676511604166,74.72443149820553,73.81225104314242,71.3187702031661,67.44415606921332]]},"first":{"added":[],"rivals":[{"entry":[{"id":"coulomb_friction","effect":"coulomb_friction","where":["joint.hinge"],"start":{},"fixed":[],"range":{}}],"values":[0.5504575604868243,0.020403864688482008,0.02076962249388681],"states":[[-0.005787812302564955,0.08922817226087319],[0.005944356354813348,0.13400261973755254],[0.356099244771237,1.1072339787968057],[0.22509896208477673,-1.9366704169148445],[0.002002189868624199,-0.03693622303198182],[0.2715501097511099,1.0577564485516306],[0.26007360232740717,-1.7283952921885681],[-0.5251085347756674,0.1929645857864924]],"timed":true,"gain":[11.876401422394954,3.7939975976877705,5.364817782214774,19.571185772288818]},{"entry":[{"id":"sensor_delay","effect":"sensor_delay","where":["sensor.angle"],"start":{},"fixed":[],"range":{}}],"values":[0.5542626857415206,0.029035885341872632,0.010689211739086572],"states":[[-0.0014568846658399416,0.026889278322992684],[0.009967945618103359,0.10602345063454487],[0.3710087193023121,1.0303984393724623],[0.20456558477594744,-2.0261738759475154],[0.004127052796809508,-0.014562846668790983],[0.28668059523630274,0.968331892058357],[0.24093279576669133,-1.8606005991000412],[-0.5192296098727476,0.24695848956505467]],"timed":true,"gain":[-0.13547423558440475,0.13465800972881561,-0.4308604777612013,0.0635406852020095]},{"entry":[{"id":"joint_offset_torque","effect":"joint_offset_torque","where":["joint.hinge"],"start":{},"fixed":[],"range":{}}],"values":[0.5568235572530474,0.028641270727989533,0.00278809713555583],"states":[[-0.0010464809179776356,0.017236391482824544],[0.00926654088777654,0.07770535020978289],[0.36025699002000716,1.0427647879097879],[0.2263786702179577,-1.9580538724853997],[0.004713712443944501,-0.020238873806515862],[0.27665877993979077,0.9816344995865157],[0.26103415519838713,-1.7273211849598054],[-0.5209445459460649,0.10529947288490461]],"timed":true,"gain":[-1.9081323106068622,1.6036218044528776,-5.003639833988623,0.9308715810161354]}],"chosen":0,"timing":[[0.014297210289708318,0.07075419245838788,0.19538838989338903,0.4259475619689619,0.8105472465713586,1.3774398894452666,2.1918106036674807,3.267274425788787,4.652386340314878,6.34266507219826,8.353365266088,10.661407420405062],[3.303255023080891,5.4859774539488155,8.131833180150188,11.153093491089333,14.45319847605906,17.901491160968277,21.352526339104823,24.651168761479884,27.637852870252846,30.153714493095165,32.059585148855405,33.22496912289957,33.530812727467136,32.88565800800206,31.225944526451826],[-0.6169351348015759,-1.3954186899981695,-2.5917120981811896,-4.280165486626725,-6.477998889494419,-9.202836049600695,-12.399901036690036,-16.015369122735002,-19.953627225689818,-24.136859833740353,-28.434669681119022,-32.74044779036824,-36.9176166746404,-40.834659039267144,-44.37129307818836],[-5.174180870824339,-8.364269625398968,-12.094420676252302,-16.215899636623664,-20.577795593954008,-25.03306792664926,-29.44345604412679,-33.66866037708631,-37.569042798326066,-41.05010766806064,-43.98975911318825,-46.3106558032282,-47.9354569099986,-48.80072826357767,-48.84225805364337,-48.02440665604891],[11.584182464744035,18.001591464571383,23.74945916286588,28.67406413528993,32.65062492178714,35.586937980254326,37.4256474881846,38.1449737594023,37.75787743431013,36.3097989475044,33.87525141713504,30.553631692668127],[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,-3.945515426517069,-15.181935634937641,-25.729797945006887,-35.29028047863558,-43.59479889456924],[0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0],[0.0,0.0,0.0,1.3570081672399796,14.205342233002249,27.640750852515573,39.86820640529195,50.542786943127446,59.39918072314451,66.26831729478728,71.08224335491647,73.86676511604166,74.72443149820553,73.81225104314242,71.3187702031661,67.44415606921332]]},"first_answer":{"verdict":"cannot_tell","probability":0.0,"calibrated":false,"evidence":{},"noise_floor":{"angle":0.007556291747520396},"units":{"angle":"rad"},"random_forces":[],"base":{"fit_rmse":{"angle":0.008596994216715817},"cv_rmse":{"angle":0.01232597353278467},"ratio_to_floor":1.6312199084728893},"ranking":[{"effects":[{"effect":"coulomb_friction","where":"joint.hinge","parameters":{"torque":{"value":0.02076962249388681,"ci95":[0.011246912172603572,0.03029233281517005],"unit":"N*m"}}}],"class":[],"fit_rmse":{"angle":0.003971297021960124},"cv_rmse":{"angle":0.0049834622946382185},"ratio_to_floor":0.6595116309893072,"gain":11.876401422394954,"gain_ci95":[5.364817782214774,19.571185772288818],"gain_standard_error":3.7939975976877705,"probability":0.0},{"effects":[{"effect":"sensor_delay","where":"sensor.angle","parameters":{"delay":{"value":0.010689211739086572,"ci95":[0.0,0.04181192093861919],"unit":"s"}}}],"class":[],"fit_rmse":{"angle":0.008572441103835456},"cv_rmse":{"angle":0.012343359671936477},"ratio_to_floor":1.6335207909338547,"gain":-0.13547423558440475,"gain_ci95":[-0.4308604777612013,0.0635406852020095],"gain_standard_error":0.13465800972881561,"probability":0.0},{"effects":[{"effect":"joint_offset_torque","where":"joint.hinge","parameters":{"torque":{"value":0.00278809713555583,"ci95":[-0.0036668865040080357,0.009243080775119695],"unit":"N*m"}}}],"class":[],"fit_rmse":{"angle":0.00787629181193872},"cv_rmse":{"angle":0.013091318834489751},"ratio_to_floor":1.7325057411640676,"gain":-1.9081323106068622,"gain_ci95":[-5.003639833988623,0.9308715810161354],"gain_standard_error":1.6036218044528776,"probability":0.0}],"segment_lengths":[],"p_by_chance":0.001,"chance_95":2.679621825345811,"free_force":{"p":1.0,"gain":{"value":0.0,"standard_error":0.0,"ci95":[0.0,0.0]}},"answer_gain":{"value":0.0,"standard_error":0.0,"ci95":[0.0,0.0]},"formulas":[],"formulas_of_rest":false,"residual_force":[{"joint":"hinge","of":"position","unit":"rad","force_unit":"N*m","at":[-0.6590273827531674,-0.527830151081864,-0.4106279105754509,-0.19767550013105795,-0.00027822423141888296,0.0003631782494486168,0.038918395261223114,0.119354705291406,0.1868092254540851,0.2693799278701358,0.35693219362740364,0.3944188290485066,0.45800602041252864,0.8555808008434618],"force":[0.0008931921081090047,0.0007690193259568776,0.0007979438827969914,0.0005146124115187975,0.004233674326341444,-0.0016492709759037495,-0.0005918930245552028,-0.0003170318152767151,0.00031812310177624413,-0.0007633775970359926,0.0005570097607531114,0.0005264562784225864,0.00045758772156041306,0.002546703498644907],"standard_error":[0.004479516148781781,0.0030428953469821968,0.0047072697697758455,0.003990294763831286,0.01235417375474809,0.0030893881852049397,0.008177064101862438,0.003905203300709444,0.003777606912189456,0.003822333518318136,0.004875390713366385,0.003364532438182895,0.003578146220094286,0.00625845008929972]},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-2.526777642839037,-2.347519744457014,-1.987476725640519,-1.404913744700911,-0.8434985540789056,-0.32918634800776747,0.00040170248095153954,0.06924396361437243,0.22305983195499657,0.5207117752540122,0.9343005949785791,1.014346292421948,1.127544670205027,2.672921567629595,3.7036545138316956],"force":[0.0013967829401415111,-0.0008339280574932117,0.00022740904727059982,0.0016938733261678896,0.002315641296948069,0.002002206923222284,-0.0005759221703845005,-0.0025003303907650412,-0.0014756832349423585,-0.0003433201307060165,-0.0027547915685407474,-0.0012381399759740614,-7.982532860155084e-05,0.002203751236976819,0.0015197753736221704],"standard_error":[0.00880062812204035,0.004809394126187235,0.004609538048793276,0.0039422004783186025,0.004064032068749057,0.003816112060876257,0.00402763835875445,0.005160191187880397,0.004506153382781076,0.008158931339908408,0.004811688910017503,0.004611224104103212,0.0034407823201814346,0.004604304567348058,0.004534072961256631]},{"joint":"hinge","of":"command","unit":"N*m","force_unit":"N*m","at":[-0.4055,-0.15,-0.042,0.095,0.25,0.3025,0.35],"force":[0.0008764587344828281,0.0005108613565546102,-0.0014828517910591202,-0.00035265773675983905,-3.954819125976679e-05,2.6942707550722697e-05,0.0011963919674418705],"standard_error":[0.004165796437057669,0.001966636054694827,0.00441117575939824,0.003051150928568364,0.001922272333864382,0.004904440789380117,0.0030766872982073853]},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-1.5675888752187406,-1.2448469792636545,-0.9221050833085684,-0.5993631873534824,-0.2766212913983963,0.04612060455668976,0.3688625005117759,0.6916043964668619,1.014346292421948],"force":[0.002692461878664292,0.004029005149473666,0.004894417316709592,0.005123900055709819,0.004647540731577707,0.0001319880402302211,0.0008560181550756939,0.00011174082518772732,-0.00020383976605581816],"standard_error":[0.008321685719909553,0.007964371836836827,0.008129181154813663,0.007681403663138952,0.007678546561915006,0.007734293257822314,0.007985689560432064,0.00842019297321129,0.008696997909693338],"position":-0.6387348957112085},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-2.507659120819491,-1.7689423220145226,-1.0302255232095534,-0.29150872440458464,0.4472080744003841,1.185924873205353,1.9246416720103219,2.663358470815291,3.4020752696202594],"force":[0.0016599356423842554,5.877626744232958e-05,0.0008117042513621068,0.0003231676836307196,-0.0012212998270134236,-0.00014723262183904932,0.0014296632732833422,0.0028969979584384685,0.0025432656817656273],"standard_error":[0.010164121828530569,0.005782800208875726,0.005714496481046504,0.0059108953074809905,0.007472807267922647,0.005695511278399584,0.00560337983140139,0.006731254785679571,0.006485053432081215],"position":0.08170152317439754},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-1.122955164634043,-0.5961801150191054,-0.06940506540416769,0.4573699842107699,0.9841450338257076,1.5109200834406453,2.037695133055583,2.5644701826705205,3.0912452322854582],"force":[0.004519541984534745,0.004596134823029846,0.00204334788569119,-0.00023905238507480179,-0.0020374284942745475,-0.0002511624562617195,0.00019040086330089273,0.0009183487241400081,0.0011493782485831824],"standard_error":[0.005453750405344618,0.0054496759970944775,0.005640290764816188,0.007719852430040703,0.005545511316599045,0.005585414352559979,0.005873409701020109,0.0065401207812930545,0.006445874194091697],"position":0.5199293865618433}],"hypotheses":3,"findings":[],"next_test":"","next_test_worth":"","not_testable":[],"seconds":0.054218343},"most_effects":3,"tried":[[]],"gains":[{"effects":["coulomb_friction @ joint.hinge"],"gain":[11.876401422394954,3.7939975976877705,5.364817782214774,19.571185772288818]},{"effects":["joint_offset_torque @ joint.hinge"],"gain":[-1.9081323106068622,1.6036218044528776,-5.003639833988623,0.9308715810161354]},{"effects":["sensor_delay @ sensor.angle"],"gain":[-0.13547423558440475,0.13465800972881561,-0.4308604777612013,0.0635406852020095]}],"base_values":[0.5542126597099684,0.028864801301120575],"law_leads":false,"so_far":{"verdict":"cannot_tell","probability":0.0,"calibrated":false,"evidence":{},"noise_floor":{"angle":0.007556291747520396},"units":{"angle":"rad"},"random_forces":[],"base":{"fit_rmse":{"angle":0.008596994216715817},"cv_rmse":{"angle":0.01232597353278467},"ratio_to_floor":1.6312199084728893},"ranking":[{"effects":[{"effect":"coulomb_friction","where":"joint.hinge","parameters":{"torque":{"value":0.02076962249388681,"ci95":[0.011246912172603572,0.03029233281517005],"unit":"N*m"}}}],"class":[],"fit_rmse":{"angle":0.003971297021960124},"cv_rmse":{"angle":0.0049834622946382185},"ratio_to_floor":0.6595116309893072,"gain":11.876401422394954,"gain_ci95":[5.364817782214774,19.571185772288818],"gain_standard_error":3.7939975976877705,"probability":0.0},{"effects":[{"effect":"sensor_delay","where":"sensor.angle","parameters":{"delay":{"value":0.010689211739086572,"ci95":[0.0,0.04181192093861919],"unit":"s"}}}],"class":[],"fit_rmse":{"angle":0.008572441103835456},"cv_rmse":{"angle":0.012343359671936477},"ratio_to_floor":1.6335207909338547,"gain":-0.13547423558440475,"gain_ci95":[-0.4308604777612013,0.0635406852020095],"gain_standard_error":0.13465800972881561,"probability":0.0},{"effects":[{"effect":"joint_offset_torque","where":"joint.hinge","parameters":{"torque":{"value":0.00278809713555583,"ci95":[-0.0036668865040080357,0.009243080775119695],"unit":"N*m"}}}],"class":[],"fit_rmse":{"angle":0.00787629181193872},"cv_rmse":{"angle":0.013091318834489751},"ratio_to_floor":1.7325057411640676,"gain":-1.9081323106068622,"gain_ci95":[-5.003639833988623,0.9308715810161354],"gain_standard_error":1.6036218044528776,"probability":0.0}],"segment_lengths":[],"p_by_chance":0.001,"chance_95":2.679621825345811,"free_force":{"p":1.0,"gain":{"value":0.0,"standard_error":0.0,"ci95":[0.0,0.0]}},"answer_gain":{"value":0.0,"standard_error":0.0,"ci95":[0.0,0.0]},"formulas":[],"formulas_of_rest":false,"residual_force":[{"joint":"hinge","of":"position","unit":"rad","force_unit":"N*m","at":[-0.6590273827531674,-0.527830151081864,-0.4106279105754509,-0.19767550013105795,-0.00027822423141888296,0.0003631782494486168,0.038918395261223114,0.119354705291406,0.1868092254540851,0.2693799278701358,0.35693219362740364,0.3944188290485066,0.45800602041252864,0.8555808008434618],"force":[0.0008931921081090047,0.0007690193259568776,0.0007979438827969914,0.0005146124115187975,0.004233674326341444,-0.0016492709759037495,-0.0005918930245552028,-0.0003170318152767151,0.00031812310177624413,-0.0007633775970359926,0.0005570097607531114,0.0005264562784225864,0.00045758772156041306,0.002546703498644907],"standard_error":[0.004479516148781781,0.0030428953469821968,0.0047072697697758455,0.003990294763831286,0.01235417375474809,0.0030893881852049397,0.008177064101862438,0.003905203300709444,0.003777606912189456,0.003822333518318136,0.004875390713366385,0.003364532438182895,0.003578146220094286,0.00625845008929972]},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-2.526777642839037,-2.347519744457014,-1.987476725640519,-1.404913744700911,-0.8434985540789056,-0.32918634800776747,0.00040170248095153954,0.06924396361437243,0.22305983195499657,0.5207117752540122,0.9343005949785791,1.014346292421948,1.127544670205027,2.672921567629595,3.7036545138316956],"force":[0.0013967829401415111,-0.0008339280574932117,0.00022740904727059982,0.0016938733261678896,0.002315641296948069,0.002002206923222284,-0.0005759221703845005,-0.0025003303907650412,-0.0014756832349423585,-0.0003433201307060165,-0.0027547915685407474,-0.0012381399759740614,-7.982532860155084e-05,0.002203751236976819,0.0015197753736221704],"standard_error":[0.00880062812204035,0.004809394126187235,0.004609538048793276,0.0039422004783186025,0.004064032068749057,0.003816112060876257,0.00402763835875445,0.005160191187880397,0.004506153382781076,0.008158931339908408,0.004811688910017503,0.004611224104103212,0.0034407823201814346,0.004604304567348058,0.004534072961256631]},{"joint":"hinge","of":"command","unit":"N*m","force_unit":"N*m","at":[-0.4055,-0.15,-0.042,0.095,0.25,0.3025,0.35],"force":[0.0008764587344828281,0.0005108613565546102,-0.0014828517910591202,-0.00035265773675983905,-3.954819125976679e-05,2.6942707550722697e-05,0.0011963919674418705],"standard_error":[0.004165796437057669,0.001966636054694827,0.00441117575939824,0.003051150928568364,0.001922272333864382,0.004904440789380117,0.0030766872982073853]},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-1.5675888752187406,-1.2448469792636545,-0.9221050833085684,-0.5993631873534824,-0.2766212913983963,0.04612060455668976,0.3688625005117759,0.6916043964668619,1.014346292421948],"force":[0.002692461878664292,0.004029005149473666,0.004894417316709592,0.005123900055709819,0.004647540731577707,0.0001319880402302211,0.0008560181550756939,0.00011174082518772732,-0.00020383976605581816],"standard_error":[0.008321685719909553,0.007964371836836827,0.008129181154813663,0.007681403663138952,0.007678546561915006,0.007734293257822314,0.007985689560432064,0.00842019297321129,0.008696997909693338],"position":-0.6387348957112085},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-2.507659120819491,-1.7689423220145226,-1.0302255232095534,-0.29150872440458464,0.4472080744003841,1.185924873205353,1.9246416720103219,2.663358470815291,3.4020752696202594],"force":[0.0016599356423842554,5.877626744232958e-05,0.0008117042513621068,0.0003231676836307196,-0.0012212998270134236,-0.00014723262183904932,0.0014296632732833422,0.0028969979584384685,0.0025432656817656273],"standard_error":[0.010164121828530569,0.005782800208875726,0.005714496481046504,0.0059108953074809905,0.007472807267922647,0.005695511278399584,0.00560337983140139,0.006731254785679571,0.006485053432081215],"position":0.08170152317439754},{"joint":"hinge","of":"velocity","unit":"rad/s","force_unit":"N*m","at":[-1.122955164634043,-0.5961801150191054,-0.06940506540416769,0.4573699842107699,0.9841450338257076,1.5109200834406453,2.037695133055583,2.5644701826705205,3.0912452322854582],"force":[0.004519541984534745,0.004596134823029846,0.00204334788569119,-0.00023905238507480179,-0.0020374284942745475,-0.0002511624562617195,0.00019040086330089273,0.0009183487241400081,0.0011493782485831824],"standard_error":[0.005453750405344618,0.0054496759970944775,0.005640290764816188,0.007719852430040703,0.005545511316599045,0.005585414352559979,0.005873409701020109,0.0065401207812930545,0.006445874194091697],"position":0.5199293865618433}],"hypotheses":3,"findings":[],"next_test":"","next_test_worth":"","not_testable":[],"seconds":0.054218343}}');
CREATE TABLE failed_trial (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES run (number),
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  trial TEXT NOT NULL,
  test TEXT NOT NULL,
  failed TEXT NOT NULL,
  reason TEXT NOT NULL
) STRICT;
INSERT INTO failed_trial VALUES(2199023255553,2,2199023255553,'1','4','2026-11-28T12:57:37Z','target "process" (/srv/lacuna/lib/lacuna/plugins/process.so): "python3 pendulum.py" says: the motor is hot');
CREATE TABLE where_it_fails (
  comparison INTEGER PRIMARY KEY REFERENCES comparison (id),
  document TEXT NOT NULL CHECK (json_valid(document))
) STRICT;
INSERT INTO where_it_fails VALUES(3298534883329,'{"findings":[{"kind":"trial","share":0.9644748856469311,"sentence":"96 % of squared error in steps.csv, 50 % of samples","view":"free_run","trial":"steps.csv","share_of_samples":0.5,"stretches":[{"trial":"steps.csv","spans":[[0.0,1.83]]}]},{"kind":"dependence","share":0.7777235429662439,"sentence":"78 % of squared unexplained acceleration: angle depends on direction of motion, velocity, p < 0.001; not on command, position, load","view":"acceleration","channel":"angle","depends_on":["direction of motion","velocity"],"not_on":["position","|velocity|","time since the last reversal","command","time","load","accumulated work"],"p":0.0005835642717996174}],"where":{"samples":116,"features":[{"name":"position","of":"","unit":"rad"},{"name":"velocity","of":"","unit":"rad/s"},{"name":"|velocity|","of":"","unit":"rad/s"},{"name":"direction of motion","of":"","unit":"1"},{"name":"time since the last reversal","of":"","unit":"s"},{"name":"command","of":"","unit":"N*m"},{"name":"time","of":"","unit":"s"},{"name":"load","of":"","unit":"N*m"},{"name":"accumulated work","of":"","unit":"J"}],"whiteness":[{"channel":"angle","lags_s":[0.03,0.06,0.09,0.12,0.15,0.18,0.21,0.24,0.27,0.3,0.32999999999999996,0.36,0.39,0.42],"autocorrelation":[0.958280498386177,0.9061973597668661,0.8359883556859499,0.7535329099186454,0.6636283068107017,0.5678950023520005,0.4695044913073755,0.37548050214603934,0.2870742476035608,0.2016584086863692,0.1238824035489279,0.05055939768968149,-0.01860681306073986,-0.08256368851618014],"band99":0.2391570260382251,"share_outside":0.6428571428571429,"ljung_box":521.0359865212321,"degrees_of_freedom":14,"p":3.208087973597928e-102}],"views":[{"view":"free_run","horizon_s":null,"times_floor":7.87382979939753,"channels":[{"channel":"angle","unit":"rad","share_of_error":1.0,"mean":{"testable":true,"share":3.409759504102356e-05,"statistic":0.0002711622768912139,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":0.9873957390764362,"bins":[]},"independence":[{"name":"position","of":"","unit":"rad","testable":true,"share":0.06938647519474635,"statistic":0.21668524788611765,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.6241174076954225,"to":-0.5152714939155502,"feature":-0.563827686843676,"mean":-0.0019309347418196715,"band99":0.021760781545930072,"samples":11},{"from":-0.4962792947275735,"to":-0.36669444046444294,"feature":-0.43620219455136566,"mean":0.006371448344633006,"band99":0.010248319521297868,"samples":11},{"from":-0.32724924306002845,"to":-0.08604906220208375,"feature":-0.2223865706532235,"mean":0.009195458943597381,"band99":0.0074236802982868685,"samples":11},{"from":-0.08093572122596601,"to":0.00775896384988438,"feature":-0.011595892977165002,"mean":0.001265890528710191,"band99":0.012762574075305526,"samples":11},{"from":0.012070730970858309,"to":0.06253614117245791,"feature":0.03072040542157118,"mean":-0.006931275599832455,"band99":0.021750331603516384,"samples":11},{"from":0.06691081220008167,"to":0.14612340298737952,"feature":0.10847679487765968,"mean":-0.0018708239472593937,"band99":0.03366483707992279,"samples":11},{"from":0.14862083033373213,"to":0.25785486888981723,"feature":0.2097438012266945,"mean":-0.0068926430516919185,"band99":0.03245116022720332,"samples":11},{"from":0.2647151366348798,"to":0.352377255277583,"feature":0.3075192771716952,"mean":-0.004641267674844904,"band99":0.0226254508035593,"samples":11},{"from":0.3592437046875041,"to":0.3953287526605206,"feature":0.37750835913811315,"mean":-0.006527024563079853,"band99":0.01506485154643849,"samples":11},{"from":0.39795842362231715,"to":0.4761959694236142,"feature":0.4376846853879997,"mean":0.002684192861332,"band99":0.01589244129577013,"samples":11},{"from":0.4769185044510441,"to":0.836092581296292,"feature":0.6349335622647982,"mean":0.018427612335380823,"band99":0.014682806367540156,"samples":6}],"depends":false},{"name":"velocity","of":"","unit":"rad/s","testable":true,"share":0.3864799390175897,"statistic":5.989450217263102,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":0.8470784083952968,"bins":[{"from":-2.483588357845621,"to":-2.180151830692809,"feature":-2.321044469782242,"mean":0.013124939337472495,"band99":0.0010499730778170012,"samples":11},{"from":-2.174360358458664,"to":-1.6362461737446832,"feature":-1.924044226481746,"mean":0.010238082329301517,"band99":0.008149005749828426,"samples":11},{"from":-1.58146091185646,"to":-0.9227238130823929,"feature":-1.2657045985533908,"mean":0.0033923329178189698,"band99":0.017003446179856375,"samples":11},{"from":-0.8911703105006026,"to":-0.2546056706958166,"feature":-0.5403364101531422,"mean":-0.0008699128783987757,"band99":0.01712449269574295,"samples":11},{"from":-0.20818266540059235,"to":0.04267603543724584,"feature":-0.039207216545543655,"mean":-0.0020497122377354637,"band99":0.010945034729658963,"samples":11},{"from":0.062089880362406945,"to":0.3907999972507205,"feature":0.19659527553652087,"mean":-0.008020653343057982,"band99":0.0103974772613704,"samples":11},{"from":0.40174178118821546,"to":0.6866393310052249,"feature":0.5374057321485887,"mean":-0.008704906632766416,"band99":0.017253446255195065,"samples":11},{"from":0.7343737946422787,"to":0.9573280874882073,"feature":0.844710084471315,"mean":-0.008718804047405163,"band99":0.014229290652442512,"samples":11},{"from":0.9824782492051449,"to":1.1030052851382843,"feature":1.046753259124498,"mean":-0.012373985799599816,"band99":0.01756940530591713,"samples":11},{"from":1.113962005072262,"to":3.2432740813699352,"feature":2.195717547679464,"mean":0.010886451204077899,"band99":0.01877172649548722,"samples":11},{"from":3.2724921397120768,"to":3.7217292925335315,"feature":3.5604179636384763,"mean":0.007096127793782201,"band99":0.0029554686783970457,"samples":6}],"depends":false},{"name":"|velocity|","of":"","unit":"rad/s","testable":true,"share":0.2898750994757962,"statistic":11.507618797837743,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":0.2422209710319746,"bins":[{"from":0.00044545520768669356,"to":0.0803514265478565,"feature":0.03347230716390306,"mean":-0.0033418231085681855,"band99":0.009937525679621528,"samples":11},{"from":0.10102952566628128,"to":0.2634459275471936,"feature":0.20035647137670448,"mean":-0.0041065198511555075,"band99":0.017541175522444094,"samples":11},{"from":0.3284849170276992,"to":0.5222843764497147,"feature":0.43617369066304146,"mean":-0.007126395186064445,"band99":0.014842301086766395,"samples":11},{"from":0.5295889949238931,"to":0.7487287958130472,"feature":0.6438042428490243,"mean":-0.006978567591473733,"band99":0.010754815675229852,"samples":11},{"from":0.7638645943311215,"to":0.9276929873169185,"feature":0.8576223879545796,"mean":-0.006985684388858325,"band99":0.020218746799807275,"samples":11},{"from":0.9573280874882073,"to":1.073232723335414,"feature":1.0203867764736103,"mean":-0.0095792434084064,"band99":0.01769854603402923,"samples":11},{"from":1.0737859801323963,"to":1.4024965125752946,"feature":1.2024960796612292,"mean":-0.00034626955159586714,"band99":0.013751672900578936,"samples":11},{"from":1.5008320799127826,"to":1.9430420196558755,"feature":1.7388081832697049,"mean":0.00812271712495642,"band99":0.009951023779072534,"samples":11},{"from":2.054674487522479,"to":2.2971703280372275,"feature":2.1813068944164846,"mean":0.012456529139785979,"band99":0.005109782117787315,"samples":11},{"from":2.308275644469672,"to":3.2432740813699352,"feature":2.613412010928114,"mean":0.014789087671087331,"band99":0.012615483326313608,"samples":11},{"from":3.2724921397120768,"to":3.7217292925335315,"feature":3.5604179636384763,"mean":0.007096127793782201,"band99":0.0029554686783970457,"samples":6}],"depends":false},{"name":"direction of motion","of":"","unit":"1","testable":true,"share":0.13676203686474128,"statistic":1.8391223835403698,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":1.0,"bins":[{"from":-1.0,"to":-1.0,"feature":-1.0000000000000007,"mean":0.005455330566548865,"band99":0.013090623081439181,"samples":49},{"from":0.0,"to":0.0,"feature":0.0,"mean":-0.00025319522910589344,"band99":4.172465174325979e-05,"samples":4},{"from":1.0,"to":1.0,"feature":0.9999999999999982,"mean":-0.004091738265634883,"band99":0.02204606868179955,"samples":63}],"depends":false},{"name":"time since the last reversal","of":"","unit":"s","testable":true,"share":0.03761757045455419,"statistic":1.5404893022696167,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.0,"to":0.05999999999999994,"feature":0.019090909090909092,"mean":-0.00019714100903649276,"band99":0.01852130869382529,"samples":11},{"from":0.06,"to":0.11999999999999988,"feature":0.0845454545454545,"mean":0.004743715673995616,"band99":0.012343489112963816,"samples":11},{"from":0.12,"to":0.18,"feature":0.15249999999999997,"mean":0.0012220322912853368,"band99":0.0138861840299869,"samples":12},{"from":0.18000000000000005,"to":0.24,"feature":0.22090909090909092,"mean":0.0022249548096462727,"band99":0.016309958441735536,"samples":11},{"from":0.27,"to":0.32999999999999985,"feature":0.2890909090909091,"mean":0.003904633618099111,"band99":0.02310805827398678,"samples":11},{"from":0.32999999999999996,"to":0.3899999999999999,"feature":0.3545454545454545,"mean":0.002233603772766241,"band99":0.021388951257268703,"samples":11},{"from":0.39,"to":0.44999999999999996,"feature":0.42249999999999993,"mean":-0.0024042359741037467,"band99":0.029012517019670486,"samples":12},{"from":0.45000000000000007,"to":0.5399999999999999,"feature":0.49363636363636365,"mean":0.0028701816241369915,"band99":0.02816591465040659,"samples":11},{"from":0.54,"to":0.63,"feature":0.585,"mean":-0.004925333035876116,"band99":0.03180453518441235,"samples":12},{"from":0.6599999999999999,"to":0.9,"feature":0.7585714285714286,"mean":-0.006555006189419835,"band99":0.007462308441723633,"samples":14}],"depends":false},{"name":"command","of":"","unit":"N*m","testable":true,"share":0.10169860396187655,"statistic":0.20133539757680505,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.4125,"to":-0.247,"feature":-0.3446363636363636,"mean":-0.005681959424924211,"band99":0.005170907026045685,"samples":11},{"from":-0.2205,"to":-0.15,"feature":-0.15512000000000006,"mean":0.009627890456804329,"band99":0.0035918182670394224,"samples":25},{"from":-0.135,"to":0.021,"feature":-0.03795454545454547,"mean":0.010203585599288977,"band99":0.02416929628953998,"samples":11},{"from":0.022,"to":0.1155,"feature":0.07345454545454545,"mean":-0.0010486741716992667,"band99":0.02539127831146679,"samples":11},{"from":0.1375,"to":0.25,"feature":0.23071666666666663,"mean":-0.00743362675041477,"band99":0.011081539850532793,"samples":30},{"from":0.2535,"to":0.329,"feature":0.29409090909090907,"mean":-0.010370261485778425,"band99":0.01938120914948903,"samples":11},{"from":0.334,"to":0.35,"feature":0.34705882352941175,"mean":0.003923579500944129,"band99":0.037225124317617854,"samples":17}],"depends":false},{"name":"time","of":"","unit":"s","testable":true,"share":0.2601319869186303,"statistic":1.495481247272368,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.12,"to":0.27,"feature":0.19499999999999998,"mean":-0.001084008466473913,"band99":0.0010813530266789572,"samples":12},{"from":0.3,"to":0.45,"feature":0.37499999999999994,"mean":-0.008582100749587113,"band99":0.0062112442440259985,"samples":12},{"from":0.48,"to":0.63,"feature":0.5549999999999999,"mean":-0.017895733324856857,"band99":0.01683676205002344,"samples":12},{"from":0.66,"to":0.81,"feature":0.7349999999999999,"mean":-0.014765157823572309,"band99":0.019084351140392506,"samples":12},{"from":0.84,"to":0.99,"feature":0.9149999999999999,"mean":0.0036088921038277613,"band99":0.0182179920238373,"samples":12},{"from":1.02,"to":1.17,"feature":1.095,"mean":0.010998382902230878,"band99":0.002461424547951689,"samples":12},{"from":1.2,"to":1.35,"feature":1.2750000000000001,"mean":0.01406025354028763,"band99":0.011741002749715032,"samples":12},{"from":1.38,"to":1.53,"feature":1.4549999999999998,"mean":0.00865461869599309,"band99":0.00865338300262024,"samples":12},{"from":1.56,"to":1.71,"feature":1.635,"mean":0.0011532937766325613,"band99":0.018383064720619218,"samples":12},{"from":1.74,"to":1.83,"feature":1.7850000000000001,"mean":0.006842202281961557,"band99":0.056852128109599755,"samples":8}],"depends":false},{"name":"load","of":"","unit":"N*m","testable":true,"share":0.07253578456112106,"statistic":0.2430028876633522,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":-0.43922531908892254,"to":-0.23730744393887676,"feature":-0.3332058578875869,"mean":-0.005048952829902662,"band99":0.01019291429417915,"samples":11},{"from":-0.23457678745203075,"to":-0.15874703716986419,"feature":-0.2003616291711719,"mean":0.008420093735073842,"band99":0.004921812771764249,"samples":11},{"from":-0.14252296589239652,"to":-0.042613557247911285,"feature":-0.09173558161920342,"mean":0.012237797220859072,"band99":0.0012962252379512844,"samples":11},{"from":-0.03839037119985726,"to":0.011735777934928816,"feature":-0.012269490290801809,"mean":0.004792441391088203,"band99":0.013950500430089803,"samples":11},{"from":0.017755842111447005,"to":0.11172042656045608,"feature":0.06418929253294064,"mean":-0.003056641934105445,"band99":0.03352628026467676,"samples":11},{"from":0.13099887397785762,"to":0.19233494024797837,"feature":0.1662731667626209,"mean":-0.005268689456171127,"band99":0.03379831650895384,"samples":11},{"from":0.19484825482614276,"to":0.21294762897367725,"feature":0.20245213137146648,"mean":-0.001987034714291496,"band99":0.011488034654238559,"samples":11},{"from":0.21637078240799845,"to":0.2518643189201164,"feature":0.23285403830210483,"mean":-0.0037525758813803257,"band99":0.023833859433933336,"samples":11},{"from":0.25320651274288836,"to":0.28450472103522667,"feature":0.26993620426622916,"mean":-0.004206660981732916,"band99":0.025618889052619206,"samples":11},{"from":0.2850949972877227,"to":0.3191006066127798,"feature":0.30002732379232583,"mean":-0.005211838808662522,"band99":0.018238732038477215,"samples":11},{"from":0.323097028052875,"to":0.34840612184345116,"feature":0.3298343770639818,"mean":0.007070265160158712,"band99":0.04334609414630336,"samples":6}],"depends":false},{"name":"accumulated work","of":"","unit":"J","testable":true,"share":0.33169004750755093,"statistic":0.9646770795623305,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":1.0,"bins":[{"from":0.0,"to":0.0005836429710367483,"feature":0.00010208020462815411,"mean":-0.0033668540869846615,"band99":0.0026934818672506946,"samples":11},{"from":0.0010599782953352635,"to":0.017423407772681823,"feature":0.007334811247355403,"mean":-0.01442997914096376,"band99":0.022086660752351203,"samples":11},{"from":0.018805950598703398,"to":0.057518909612519195,"feature":0.036969391534107596,"mean":-0.013723265823508357,"band99":0.02336732546636461,"samples":11},{"from":0.05794754254943335,"to":0.08263618168639997,"feature":0.07378422082520886,"mean":-0.012551890953398497,"band99":0.0031566874417476524,"samples":11},{"from":0.08496171508734601,"to":0.1085290902468854,"feature":0.09787424138336791,"mean":-0.002309894693046822,"band99":0.0057124173997694875,"samples":11},{"from":0.11037480675628138,"to":0.12801205479979644,"feature":0.11842736266741472,"mean":0.009551384617925877,"band99":0.0073148925093336065,"samples":11},{"from":0.13018672997561312,"to":0.16293148556532427,"feature":0.14767679242403503,"mean":0.013922631717626194,"band99":0.008957869202199573,"samples":11},{"from":0.16627072963073228,"to":0.18310246261363458,"feature":0.17312669853789783,"mean":0.013194309910216346,"band99":0.009358038215746236,"samples":11},{"from":0.18423436535180002,"to":0.2401682163811751,"feature":0.2123298434074471,"mean":0.0038889652728652906,"band99":0.002332262801099456,"samples":11},{"from":0.25212116491062453,"to":0.3215385320385212,"feature":0.28292920465263927,"mean":-0.003982333115404971,"band99":0.01785632652127521,"samples":11},{"from":0.34719997309114825,"to":0.4817064949606926,"feature":0.4150227755800029,"mean":0.019399182558480006,"band99":0.00225262939351668,"samples":6}],"depends":false}],"selected":[],"not_on":["position","velocity","|velocity|","direction of motion","time since the last reversal","command","time","load","accumulated work"]}],"tree":[{"parent":-1,"share_of_error":1.0,"share_of_samples":1.0}],"regimes":[]},{"view":"acceleration","horizon_s":null,"times_floor":3.83604634050268,"channels":[{"channel":"angle","unit":"rad/s^2","share_of_error":1.0,"mean":{"testable":true,"share":0.01369801306416723,"statistic":0.2183926677962481,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":0.6567570870956767,"bins":[]},"independence":[{"name":"position","of":"","unit":"rad","testable":true,"share":0.02142962510769537,"statistic":2.1173271094624786,"band99":19.301613781072064,"degrees_of_freedom":[2,9],"p":1.0,"bins":[{"from":-0.5800397305544525,"to":-0.4771042400763445,"feature":-0.5206551066506601,"mean":0.15120479380482718,"band99":0.0565887875900473,"samples":10},{"from":-0.4639926483611306,"to":-0.31959971635223944,"feature":-0.3977601672110236,"mean":0.14106379207018052,"band99":0.2670936055920239,"samples":10},{"from":-0.30489693599611223,"to":-0.08093572122596601,"feature":-0.1880339038999157,"mean":0.06683490116444596,"band99":0.26954532495557626,"samples":10},{"from":-0.055604828025694435,"to":0.025566380748013894,"feature":0.0021219492119993926,"mean":-0.10870064969915151,"band99":0.184018983257415,"samples":10},{"from":0.025671305672482634,"to":0.12314085949636114,"feature":0.07283145421526759,"mean":-0.06371925556336307,"band99":0.14987210830300285,"samples":10},{"from":0.13747389208179517,"to":0.20618415729095235,"feature":0.16704919639978544,"mean":-0.08401170043687047,"band99":0.2604254358397901,"samples":10},{"from":0.20774413179431167,"to":0.30270550058730816,"feature":0.26081911722552586,"mean":-0.10723521967993402,"band99":0.20915143705764044,"samples":10},{"from":0.3027055587649498,"to":0.3683014482176707,"feature":0.34246615987626156,"mean":-0.057552000914713186,"band99":0.14782556491159965,"samples":10},{"from":0.3715155219017684,"to":0.3994193473171531,"feature":0.38955486209635753,"mean":0.08781332433075655,"band99":0.09507613213938687,"samples":10},{"from":0.41944461418767753,"to":0.4788941697815582,"feature":0.457379667240295,"mean":-0.025697985076177682,"band99":0.07801150645960622,"samples":10}],"depends":false},{"name":"velocity","of":"","unit":"rad/s","testable":true,"share":0.44120352505096516,"statistic":48.9639743200615,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":0.009361904844042222,"bins":[{"from":-2.483588357845621,"to":-2.187748816313826,"feature":-2.335133733691186,"mean":-0.8132995905167735,"band99":0.08919364284068555,"samples":10},{"from":-2.180151830692809,"to":-1.7575722272789438,"feature":-1.9995214911966983,"mean":-0.5941397295594788,"band99":0.14838609455649032,"samples":10},{"from":-1.713177236280347,"to":-1.1460220321031231,"feature":-1.4337477195183912,"mean":-0.388318081331196,"band99":0.33490375979034537,"samples":10},{"from":-1.022189910389409,"to":-0.3360143198079106,"feature":-0.7189727720200528,"mean":-0.1957681084971427,"band99":0.1344632272090621,"samples":10},{"from":-0.2634459275471936,"to":0.10102952566628128,"feature":-0.04416431724324475,"mean":-0.14575428191908965,"band99":0.3234864181188783,"samples":10},{"from":0.14372579337040614,"to":0.40746252894909957,"feature":0.2740791457916797,"mean":0.11767566745671637,"band99":0.44012522670303306,"samples":10},{"from":0.4928971167031686,"to":0.8181230868723416,"feature":0.6395966776307058,"mean":0.20165037805571154,"band99":0.11256006320580536,"samples":10},{"from":0.829080430138198,"to":1.026349482940791,"feature":0.9366532262088622,"mean":0.28164275741322914,"band99":0.10899940299832575,"samples":10},{"from":1.0421916755106722,"to":1.4024965125752946,"feature":1.1128334941637863,"mean":0.3473820283892861,"band99":0.14837166550355113,"samples":10},{"from":1.72755452800381,"to":3.7217292925335315,"feature":3.0606568949639152,"mean":1.1889289605087363,"band99":0.2547795288630012,"samples":10}],"depends":true},{"name":"|velocity|","of":"","unit":"rad/s","testable":true,"share":0.00023967223352864382,"statistic":0.057762118192019526,"band99":23.01617786624236,"degrees_of_freedom":[1,11],"p":1.0,"bins":[{"from":0.024084501962121328,"to":0.19357363622952373,"feature":0.09048670318008302,"mean":-0.04273639544720201,"band99":0.22579627296018812,"samples":10},{"from":0.1957617586948204,"to":0.40174178118821546,"feature":0.28036724121234646,"mean":0.056673245731717684,"band99":0.2340843778468824,"samples":10},{"from":0.40746252894909957,"to":0.6737876998671215,"feature":0.5343845299567683,"mean":0.023117598732649236,"band99":0.10690813896008373,"samples":10},{"from":0.6866393310052249,"to":0.8911703105006026,"feature":0.7917024741724722,"mean":-0.026156330352894847,"band99":0.09815908873686571,"samples":10},{"from":0.9227238130823929,"to":1.026349482940791,"feature":0.9762804926444991,"mean":-0.011874650467328931,"band99":0.12712047761956966,"samples":10},{"from":1.0421916755106722,"to":1.1460220321031231,"feature":1.087186046116569,"mean":-0.022620371194908423,"band99":0.07190297959349476,"samples":10},{"from":1.2490991090629309,"to":1.713177236280347,"feature":1.4593951675656085,"mean":0.0642471231563589,"band99":0.1007958454845475,"samples":10},{"from":1.72755452800381,"to":2.1183539019226543,"feature":1.9472002539125488,"mean":0.02637146076351184,"band99":0.10961491564163932,"samples":10},{"from":2.174360358458664,"to":2.4361077144315733,"feature":2.275693435655754,"mean":-0.0817870147178209,"band99":0.12334668458115303,"samples":10},{"from":2.465326811660171,"to":3.7217292925335315,"feature":3.1724184302834963,"mean":0.014765333795917455,"band99":0.20377249623975074,"samples":10}],"depends":false},{"name":"direction of motion","of":"","unit":"1","testable":true,"share":0.28563955578951805,"statistic":104.03963868477986,"band99":44.3124058709519,"degrees_of_freedom":[1,6],"p":0.0009311404101538894,"bins":[{"from":-1.0,"to":-1.0,"feature":-1.0000000000000004,"mean":0.5710011605507682,"band99":0.06155404666241614,"samples":45},{"from":1.0,"to":1.0,"feature":1.0000000000000002,"mean":-0.4671827677233559,"band99":0.09289522061224266,"samples":55}],"depends":true},{"name":"time since the last reversal","of":"","unit":"s","testable":true,"share":0.004213367415917985,"statistic":10.740025297978256,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":0.2788691606235586,"bins":[{"from":0.0,"to":0.08999999999999986,"feature":0.040909090909090895,"mean":0.039767385357310996,"band99":0.17883301227894463,"samples":11},{"from":0.08999999999999997,"to":0.15000000000000002,"feature":0.13090909090909086,"mean":0.08141308503261929,"band99":0.1522480315486615,"samples":11},{"from":0.17999999999999994,"to":0.21000000000000002,"feature":0.19499999999999995,"mean":-0.06763752212710084,"band99":0.12350688238927432,"samples":10},{"from":0.24,"to":0.27,"feature":0.255,"mean":-0.07706873853102317,"band99":0.229235216392956,"samples":10},{"from":0.3,"to":0.33000000000000007,"feature":0.31500000000000006,"mean":-0.0853897625258569,"band99":0.16441723245482404,"samples":10},{"from":0.3599999999999999,"to":0.39,"feature":0.3749999999999999,"mean":-0.039444444626012744,"band99":0.10787029611455294,"samples":10},{"from":0.41999999999999993,"to":0.48,"feature":0.4449999999999999,"mean":0.029233707591616493,"band99":0.2718227503881117,"samples":12},{"from":0.4800000000000001,"to":0.5700000000000001,"feature":0.534,"mean":0.08120960339755029,"band99":0.19159684240745303,"samples":10},{"from":0.5999999999999999,"to":0.72,"feature":0.642,"mean":-0.04400157850192349,"band99":0.20013901606414097,"samples":10},{"from":0.75,"to":0.9,"feature":0.8250000000000001,"mean":0.10658912729250611,"band99":0.13378604038267627,"samples":6}],"depends":false},{"name":"command","of":"","unit":"N*m","testable":true,"share":0.008678175920242562,"statistic":2.3380077140459083,"band99":17.388474634702153,"degrees_of_freedom":[2,10],"p":1.0,"bins":[{"from":-0.3705,"to":-0.1645,"feature":-0.27705,"mean":-0.01578953123978154,"band99":0.1232250055558711,"samples":10},{"from":-0.15,"to":-0.15,"feature":-0.15,"mean":-0.008707350185765815,"band99":0.23016917844620688,"samples":22},{"from":-0.135,"to":0.0445,"feature":-0.0348,"mean":-0.0935147690228404,"band99":0.18739576413898706,"samples":10},{"from":0.0525,"to":0.145,"feature":0.09915,"mean":-0.08581803722895527,"band99":0.23720215378916878,"samples":10},{"from":0.1605,"to":0.25,"feature":0.23495833333333327,"mean":-0.021489938442096648,"band99":0.133000238920044,"samples":24},{"from":0.2535,"to":0.3235,"feature":0.2906,"mean":0.1038118381056404,"band99":0.04335761771553169,"samples":10},{"from":0.329,"to":0.35,"feature":0.3449285714285715,"mean":0.1157446586111812,"band99":0.11945257761290017,"samples":14}],"depends":false},{"name":"time","of":"","unit":"s","testable":true,"share":0.009272525176781458,"statistic":6.641158412017961,"band99":47.62437964687017,"degrees_of_freedom":[2,5],"p":0.704075835103021,"bins":[{"from":0.24,"to":0.36,"feature":0.3,"mean":-0.11438877207071917,"band99":0.15231098422610242,"samples":10},{"from":0.39,"to":0.51,"feature":0.4499999999999999,"mean":-0.11531586702211231,"band99":0.02806201103309921,"samples":10},{"from":0.54,"to":0.66,"feature":0.6000000000000001,"mean":-0.028245964663398827,"band99":0.2556927673473968,"samples":10},{"from":0.69,"to":0.81,"feature":0.7499999999999999,"mean":-0.012808507861152209,"band99":0.3164623217804812,"samples":10},{"from":0.84,"to":0.96,"feature":0.8999999999999998,"mean":-0.1604385808877734,"band99":0.04147272950791118,"samples":10},{"from":0.99,"to":1.11,"feature":1.05,"mean":0.03888959817379605,"band99":0.14638782936330996,"samples":10},{"from":1.14,"to":1.26,"feature":1.1999999999999997,"mean":0.05519948202793354,"band99":0.05451527013720371,"samples":10},{"from":1.29,"to":1.41,"feature":1.35,"mean":0.08774876068924241,"band99":0.057725734801687044,"samples":10},{"from":1.44,"to":1.56,"feature":1.4999999999999998,"mean":0.060435311247484746,"band99":0.15190281721326332,"samples":10},{"from":1.59,"to":1.71,"feature":1.65,"mean":0.18892454036669917,"band99":0.01920788612681841,"samples":10}],"depends":false},{"name":"load","of":"","unit":"N*m","testable":true,"share":0.015366559590789725,"statistic":13.811539386976131,"band99":33.4932119734404,"degrees_of_freedom":[2,6],"p":0.102285441008379,"bins":[{"from":-0.3631452213099378,"to":-0.2220940837478893,"feature":-0.26939462080753185,"mean":-0.30512478788600234,"band99":0.037586000177027366,"samples":10},{"from":-0.21266406079036365,"to":-0.1384028729307898,"feature":-0.1798774160445897,"mean":-0.2788784244214563,"band99":0.11540148967327946,"samples":10},{"from":-0.12583971177697995,"to":-0.03839037119985726,"feature":-0.07665559301879085,"mean":-0.2514290275544348,"band99":0.10857550551252904,"samples":10},{"from":-0.03644400022788152,"to":0.045274370522412434,"feature":0.001588535279564189,"mean":-0.19314048614948143,"band99":0.08598546070958088,"samples":10},{"from":0.04793364107265995,"to":0.14129960411720421,"feature":0.09942425200128338,"mean":-0.022280179817106546,"band99":0.10667394128979173,"samples":10},{"from":0.1510146462740179,"to":0.1986530206727438,"feature":0.18092700854299698,"mean":0.14534998628833495,"band99":0.08859989026328363,"samples":10},{"from":0.20128423692892544,"to":0.23044491760222033,"feature":0.21462209856657583,"mean":0.10396816953682798,"band99":0.16693271956142652,"samples":10},{"from":0.23291582160675162,"to":0.2626359702294378,"feature":0.24866778453707122,"mean":0.21323361879615194,"band99":0.06046213759297153,"samples":10},{"from":0.2671136391229748,"to":0.28968405527862945,"feature":0.2797919580473719,"mean":0.33354520185017406,"band99":0.19910065103576277,"samples":10},{"from":0.2934024915765188,"to":0.3275992148050156,"feature":0.3147181709920605,"mean":0.2547559293569925,"band99":0.0547241593471821,"samples":10}],"depends":false},{"name":"accumulated work","of":"","unit":"J","testable":true,"share":0.017975011583155166,"statistic":2.626100231351413,"band99":26.295172419241286,"degrees_of_freedom":[2,7],"p":1.0,"bins":[{"from":7.941573879385044e-06,"to":0.004612134803721023,"feature":0.0011570295182107013,"mean":-0.19811158022515601,"band99":0.03097624938857031,"samples":10},{"from":0.006900332344039637,"to":0.03703037546223694,"feature":0.021415975919150523,"mean":-0.13409749640967736,"band99":0.176559108313111,"samples":10},{"from":0.03970285299034399,"to":0.07368163672423131,"feature":0.05728159535172604,"mean":-0.1738991284281881,"band99":0.04931532359326687,"samples":10},{"from":0.07726119296272967,"to":0.09384519359511813,"feature":0.08340902479978483,"mean":0.0012303460299704205,"band99":0.20824168689043168,"samples":10},{"from":0.09612530833100848,"to":0.11466166481774914,"feature":0.10582779073829475,"mean":-0.09628471140942098,"band99":0.13870244341309418,"samples":10},{"from":0.11509675277668052,"to":0.1341392457807967,"feature":0.1230754971635015,"mean":0.035416171784401936,"band99":0.026286837209166386,"samples":10},{"from":0.1368665867628616,"to":0.16627072963073228,"feature":0.1526389470538708,"mean":0.13351267648264167,"band99":0.13314614217738396,"samples":10},{"from":0.16826429066156834,"to":0.18310246261363458,"feature":0.17381229542861437,"mean":0.07789201464320211,"band99":0.0197018026249789,"samples":10},{"from":0.18423436535180002,"to":0.23926477752729053,"feature":0.2095460061100743,"mean":0.07478562809722114,"band99":0.09667247050946534,"samples":10},{"from":0.2401682163811751,"to":0.37420093034341956,"feature":0.2905558613551536,"mean":0.2795560794350053,"band99":0.25383601745735324,"samples":10}],"depends":false}],"selected":[{"feature":"direction of motion","share":0.3365200179152787,"p":0.0005835642717996174},{"feature":"velocity","share":0.44120352505096516,"p":0.009361904844042222}],"not_on":["position","|velocity|","time since the last reversal","command","time","load","accumulated work"]}],"tree":[{"parent":-1,"share_of_error":1.0,"share_of_samples":1.0}],"regimes":[]}]}}');
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
CREATE VIEW failed_trials AS
SELECT experiment.name AS experiment, failed_trial.run, failed_trial.trial, failed_trial.test, failed_trial.failed,
       failed_trial.reason
FROM failed_trial
JOIN experiment ON experiment.id = failed_trial.experiment;
COMMIT;
PRAGMA application_id = 1281450862;
PRAGMA user_version = 9;
