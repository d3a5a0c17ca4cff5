-- Version 5: tests that a user had carried out on a target. Every table and column is explained in database.md.

CREATE TABLE carried_out (
  trial INTEGER PRIMARY KEY REFERENCES trial (id),
  run INTEGER NOT NULL REFERENCES run (number),
  test TEXT NOT NULL,
  target TEXT NOT NULL CHECK (length(target) = 64)
) STRICT;
