-- Version 3: the unit of the fitness of tests. Runs of version 2 did not keep it.

ALTER TABLE eea_run ADD COLUMN fitness_unit TEXT;
