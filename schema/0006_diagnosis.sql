-- Version 6: diagnoses of a revision: what effect, if any, its model lacks.

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
CREATE INDEX diagnosis_by_revision ON diagnosis (revision, settings);

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
