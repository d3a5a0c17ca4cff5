-- Version 8: tests that a target was asked to carry out and did not. Every table and column is explained in database.md.

CREATE TABLE failed_trial (
  id INTEGER PRIMARY KEY,
  run INTEGER NOT NULL REFERENCES run (number),
  experiment INTEGER NOT NULL REFERENCES experiment (id),
  trial TEXT NOT NULL,
  test TEXT NOT NULL,
  failed TEXT NOT NULL,
  reason TEXT NOT NULL
) STRICT;
