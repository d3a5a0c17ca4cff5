-- What a file and its --set leave open and the program decided, as --set would say it; JSON. Older programs had one
-- engine, and one integration step in a step.
ALTER TABLE experiment_text ADD COLUMN decided TEXT NOT NULL DEFAULT '["engine.engine=\"ode\"","engine.substeps=1"]'
  CHECK (json_valid(decided));
