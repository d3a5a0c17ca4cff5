-- What is kept of the benchmark of hidden effects. Numbers are SI; NULL: not known.
-- A place is that of the experiment's file, 'joint.hinge'; 'world' where an effect stands on nothing.

CREATE TABLE version (
  version TEXT PRIMARY KEY,  -- of the method
  program TEXT NOT NULL,     -- what `lacuna --version` printed, and a digest of its file
  begun TEXT NOT NULL        -- UTC
) STRICT;

-- A case: its plan, and how it came out.
CREATE TABLE bench_case (
  version TEXT NOT NULL REFERENCES version,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  group_name TEXT NOT NULL,
  rig TEXT NOT NULL,
  noise TEXT NOT NULL,
  planned_strength REAL NOT NULL,
  strength REAL,             -- measured: RMSE of the refitted base over that of the refitted truth
  absorbed INTEGER NOT NULL, -- 1: the refitted base explains the data, so nothing is missing
  seed TEXT NOT NULL,        -- 64 bits without sign
  failure TEXT,              -- the sentence with which the case ended early
  PRIMARY KEY (version, set_name, number)
) STRICT;

CREATE TABLE hidden_law (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  law INTEGER NOT NULL,          -- from 0
  name TEXT NOT NULL,            -- of the law
  effect TEXT NOT NULL,          -- of the library
  place TEXT NOT NULL,
  library_form INTEGER NOT NULL, -- 0: the law is not the library's form of the effect
  PRIMARY KEY (version, set_name, number, law),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;

CREATE TABLE hidden_value (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  law INTEGER NOT NULL,
  parameter TEXT NOT NULL,
  value REAL,
  PRIMARY KEY (version, set_name, number, law, parameter),
  FOREIGN KEY (version, set_name, number, law) REFERENCES hidden_law ON DELETE CASCADE
) STRICT;

-- Round 1 is the diagnosis of the base; each later one that of the model with what was found before.
CREATE TABLE diagnosis (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  round INTEGER NOT NULL,
  verdict TEXT NOT NULL,
  probability REAL,
  p_by_chance REAL,
  times_floor REAL,       -- of the model that was diagnosed
  seconds REAL,
  processor_seconds REAL,
  json TEXT NOT NULL,     -- as the program wrote it
  PRIMARY KEY (version, set_name, number, round),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;

CREATE TABLE ranked_model (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  round INTEGER NOT NULL,
  rank INTEGER NOT NULL,  -- from 1
  probability REAL,
  gain REAL,              -- nats
  times_floor REAL,
  PRIMARY KEY (version, set_name, number, round, rank),
  FOREIGN KEY (version, set_name, number, round) REFERENCES diagnosis ON DELETE CASCADE
) STRICT;

-- The effects of a ranked model in their order, then what the data do not tell from the last of them.
CREATE TABLE ranked_effect (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  round INTEGER NOT NULL,
  rank INTEGER NOT NULL,
  position INTEGER NOT NULL,    -- from 0
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  look_alike INTEGER NOT NULL,  -- 1: of the last effect
  PRIMARY KEY (version, set_name, number, round, rank, position),
  FOREIGN KEY (version, set_name, number, round, rank) REFERENCES ranked_model ON DELETE CASCADE
) STRICT;

-- What was added to the model after a round.
CREATE TABLE added_effect (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  round INTEGER NOT NULL,
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  PRIMARY KEY (version, set_name, number, round, effect, place),
  FOREIGN KEY (version, set_name, number, round) REFERENCES diagnosis ON DELETE CASCADE
) STRICT;

-- 95 % intervals: of parameters of the first ranked model (round ≥ 1, effect and place named), and of the free values
-- as the last diagnosis states them (round 0, effect and place empty).
CREATE TABLE interval (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  round INTEGER NOT NULL,
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  parameter TEXT NOT NULL,
  value REAL,
  lower REAL,  -- NULL, like upper: at a bound of its range, or not told by the data
  upper REAL,
  truth REAL,  -- NULL: there is no true value, for the law is another or of another form
  PRIMARY KEY (version, set_name, number, round, effect, place, parameter),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;

-- What these data can tell from a hidden law with the truth known. No effect: the law left
-- out; of two laws that do for each other, both.
CREATE TABLE oracle_rival (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  law INTEGER NOT NULL,
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  non_centrality REAL,
  told_apart INTEGER NOT NULL,
  PRIMARY KEY (version, set_name, number, law, effect, place),
  FOREIGN KEY (version, set_name, number, law) REFERENCES hidden_law ON DELETE CASCADE
) STRICT;

-- How sharp the refitted truth is.
CREATE TABLE oracle_width (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  parameter TEXT NOT NULL,  -- an address of the base, or 'coulomb_friction.torque'
  width REAL,               -- of the 95 % interval; NULL: the data say nothing
  PRIMARY KEY (version, set_name, number, parameter),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;

-- What other methods answer on the same data.
CREATE TABLE baseline (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  method TEXT NOT NULL,
  chosen INTEGER NOT NULL,  -- the first so many of its ranking are there, it says; 0: nothing is missing
  seconds REAL,             -- of processor time
  PRIMARY KEY (version, set_name, number, method),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;

CREATE TABLE baseline_rank (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  method TEXT NOT NULL,
  rank INTEGER NOT NULL,    -- from 1
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  score REAL,
  PRIMARY KEY (version, set_name, number, method, rank),
  FOREIGN KEY (version, set_name, number, method) REFERENCES baseline ON DELETE CASCADE
) STRICT;

-- How the first answer was told from its closest look-alike by further tests (`run --settle`).
CREATE TABLE settling (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  effect TEXT NOT NULL,
  place TEXT NOT NULL,
  rival_effect TEXT NOT NULL,  -- the look-alike
  rival_place TEXT NOT NULL,
  left_out TEXT,               -- why no test was carried out
  PRIMARY KEY (version, set_name, number),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;

CREATE TABLE settling_run (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  choice TEXT NOT NULL,  -- of the tests: 'chosen' by the program, or 'random'; 'none': the two were asked about alone
  tests INTEGER,         -- until one of the two was named alone; 7: six were not enough; 0 of 'none'; NULL: it ended early
  effect TEXT,           -- what was named alone; NULL: nothing
  place TEXT,
  failure TEXT,          -- the sentence with which it ended early
  PRIMARY KEY (version, set_name, number, choice),
  FOREIGN KEY (version, set_name, number) REFERENCES settling ON DELETE CASCADE
) STRICT;

CREATE TABLE settling_test (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  choice TEXT NOT NULL,
  test INTEGER NOT NULL,   -- from 1
  line TEXT NOT NULL,      -- as `lacuna trial --test` takes it
  verdict TEXT NOT NULL,   -- with its recording among the files
  processor_seconds REAL,  -- of that diagnosis
  PRIMARY KEY (version, set_name, number, choice, test),
  FOREIGN KEY (version, set_name, number, choice) REFERENCES settling_run ON DELETE CASCADE
) STRICT;

-- RMSE of free runs over the held-out trials.
CREATE TABLE held_out (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  stage TEXT NOT NULL,    -- 'base', 'found' (with all that was added) or 'truth' (the hidden laws, refitted)
  channel TEXT NOT NULL,
  rmse REAL,              -- NULL: a trial could not be simulated
  PRIMARY KEY (version, set_name, number, stage, channel),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT;
