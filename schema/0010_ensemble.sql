-- Version 10: the models that a pass hands on, trials that were too hard for them, how well they foretold the next trial,
-- and why a run stopped early. Every table and column is explained in database.md.

CREATE TABLE ensemble_model (
  pass INTEGER NOT NULL REFERENCES pass (id),
  rank INTEGER NOT NULL CHECK (rank >= 1),
  model INTEGER NOT NULL REFERENCES model (id),
  score REAL,
  structure TEXT NOT NULL,
  PRIMARY KEY (pass, rank)
) STRICT, WITHOUT ROWID;

CREATE TABLE ensemble_value (
  pass INTEGER NOT NULL REFERENCES pass (id),
  rank INTEGER NOT NULL CHECK (rank >= 1),
  position INTEGER NOT NULL CHECK (position >= 0),
  value REAL,
  PRIMARY KEY (pass, rank, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE set_aside (
  pass INTEGER NOT NULL REFERENCES pass (id),
  trial INTEGER NOT NULL REFERENCES trial (id),
  PRIMARY KEY (pass, trial)
) STRICT, WITHOUT ROWID;

ALTER TABLE pass ADD COLUMN stopped TEXT;
ALTER TABLE target_trial ADD COLUMN surprise REAL;
