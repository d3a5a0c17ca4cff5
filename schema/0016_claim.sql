-- Version 16: which process carries a run out, for processes on other machines that see the file.

-- `machine`: processes with the same see each other without this table. `holder`: the process. `file`: the inode of the
-- database, so that claims mean nothing in a copy. `beat` grows every few seconds while the process lives.
CREATE TABLE claim (
  run INTEGER PRIMARY KEY REFERENCES run (number),
  machine TEXT NOT NULL,
  holder TEXT NOT NULL,
  file INTEGER NOT NULL,
  beat INTEGER NOT NULL CHECK (beat >= 0)
) STRICT;
