-- Version 2: runs of the Estimation-Exploration Algorithm. Every table and column is explained in database.md.
-- Models, tests and passes are numbered from 0 within their run; key = run number * 2^40 + 1 + that number.

CREATE TABLE metric (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE
) STRICT;

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

-- Passes ----------------------------------------------------------------------------------------

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

CREATE TABLE best_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE objective_score (
  pass INTEGER NOT NULL REFERENCES pass (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  value REAL,
  PRIMARY KEY (pass, position)
) STRICT, WITHOUT ROWID;

-- Tests and what the target did -----------------------------------------------------------------

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

CREATE TABLE test_score (
  test INTEGER NOT NULL REFERENCES test (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (test, metric)
) STRICT, WITHOUT ROWID;

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

-- Models ----------------------------------------------------------------------------------------

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

CREATE TABLE model_score (
  model INTEGER NOT NULL REFERENCES model (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  metric INTEGER NOT NULL REFERENCES metric (id),
  score REAL,
  PRIMARY KEY (model, trial, metric)
) STRICT, WITHOUT ROWID;

CREATE TABLE invalid_model (
  model INTEGER PRIMARY KEY REFERENCES model (id),
  reason TEXT NOT NULL
) STRICT;

-- Where a run can go on from: outside of what is compared between runs ------------------------------

CREATE TABLE checkpoint (
  run INTEGER PRIMARY KEY REFERENCES eea_run (run),
  commits INTEGER NOT NULL,
  seconds REAL NOT NULL,
  state BLOB NOT NULL CHECK (length(state) % 8 = 0),
  digest TEXT NOT NULL CHECK (length(digest) = 64)
) STRICT;

-- Samples: predictions of a model beside those of a comparison, and the centre of mass ----------------
-- SQLite cannot change a CHECK, so the table is made anew. The views come back from views.sql.

DROP VIEW IF EXISTS traces;
DELETE FROM schema_text WHERE name = 'views';

CREATE TABLE trace_of_version_2 (
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
INSERT INTO trace_of_version_2
  SELECT id, trial, comparison, NULL, kind, channels, sample_count, precision, times, samples, digest FROM trace;
DROP TABLE trace;
ALTER TABLE trace_of_version_2 RENAME TO trace;
CREATE INDEX trace_by_trial ON trace (trial, kind);
