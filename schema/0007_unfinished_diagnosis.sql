-- Version 7: where an interrupted diagnosis stands, for the next call to go on from.

CREATE TABLE unfinished_diagnosis (
  revision INTEGER NOT NULL REFERENCES revision (id),
  settings TEXT NOT NULL,
  document TEXT NOT NULL CHECK (json_valid(document)),
  PRIMARY KEY (revision, settings)
) STRICT, WITHOUT ROWID;
