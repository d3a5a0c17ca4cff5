-- What was different on the rig in some of an experiment's trials, such as a load or a gain: the setup's name, empty for
-- none, and the values that it sets, SI. Values that are unknown and of one setup alone are fitted values with the
-- address `body.load.mass@heavy`.
ALTER TABLE trial ADD COLUMN setup TEXT NOT NULL DEFAULT '';
CREATE TABLE trial_setting (
  trial INTEGER NOT NULL REFERENCES trial (id),
  position INTEGER NOT NULL,
  address TEXT NOT NULL,
  value REAL NOT NULL,
  PRIMARY KEY (trial, position)
) STRICT, WITHOUT ROWID;
