-- Version 17: which method decided a diagnosis, and with it what its figures are.

ALTER TABLE diagnosis ADD COLUMN method TEXT CHECK (method IN ('likelihood', 'horizon'));
ALTER TABLE diagnosis ADD COLUMN base_fitted_times_floor REAL;
ALTER TABLE candidate_model ADD COLUMN fitted_times_floor REAL;

-- Older programs wrote figures that only likelihoods tell where errors over horizons decided, too, and the fitted error
-- as that of what was left out. These columns stay as they are, for the seals of their runs cover them; the views leave
-- out what was never computed.
UPDATE diagnosis SET method = CASE
  WHEN json_array_length(document, '$.horizons') > 0 THEN 'horizon'
  WHEN json_extract(document, '$.base.fit_rmse') IS NOT '{}' THEN 'likelihood' END;
UPDATE diagnosis SET base_fitted_times_floor = base_times_floor WHERE method = 'horizon';
UPDATE candidate_model SET fitted_times_floor = times_floor
WHERE diagnosis IN (SELECT id FROM diagnosis WHERE method = 'horizon');
