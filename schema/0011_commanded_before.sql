-- What was commanded before a trial's first sample: JSON, a number a command channel, null where it is not known; empty
-- where the test itself is the beginning. Delays and lags hold it at the start.
ALTER TABLE trial_condition ADD COLUMN commanded_before TEXT NOT NULL DEFAULT '[]';
