-- The SI unit of a value that a trial's recording sets, so that it can be read without the robot; empty: not known, as in
-- trials that an older version stored.
ALTER TABLE trial_setting ADD COLUMN unit TEXT NOT NULL DEFAULT '';
