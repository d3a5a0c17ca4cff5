-- Version 4: the robot files that a run was begun with. Runs of earlier versions did not keep them.

CREATE TABLE robot_file (
  run INTEGER NOT NULL REFERENCES run (number),
  file TEXT NOT NULL,
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (run, file)
) STRICT, WITHOUT ROWID;
