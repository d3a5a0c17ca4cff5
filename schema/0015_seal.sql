-- Version 15: what proves that the rows of a run are those that it ended with.

-- Of each table that has rows of an ended run: SHA-256 of these rows, written in the transaction that ends the run.
CREATE TABLE seal (
  run INTEGER NOT NULL REFERENCES run (number),
  part TEXT NOT NULL,
  columns TEXT NOT NULL CHECK (json_valid(columns)),
  rows INTEGER NOT NULL CHECK (rows >= 1),
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (run, part)
) STRICT, WITHOUT ROWID;
