-- Version 18: diagnoses by whitened predictions, beside those that older programs decided otherwise.

-- The views read the column that is replaced; they are made anew once all migrations are done.
DROP VIEW IF EXISTS diagnoses;
DROP VIEW IF EXISTS effect_ranking;
DELETE FROM schema_text WHERE name = 'views';
ALTER TABLE diagnosis RENAME COLUMN method TO method_before;
ALTER TABLE diagnosis ADD COLUMN method TEXT CHECK (method IN ('likelihood', 'horizon', 'prediction'));
UPDATE diagnosis SET method = method_before;
ALTER TABLE diagnosis DROP COLUMN method_before;
CREATE INDEX diagnosis_by_method ON diagnosis (method);
