-- Version 9: where a compared model fails, for the pages of a report.

CREATE TABLE where_it_fails (
  comparison INTEGER PRIMARY KEY REFERENCES comparison (id),
  document TEXT NOT NULL CHECK (json_valid(document))
) STRICT;
