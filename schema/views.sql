-- Views for reading with any sqlite3 of version 3.37 or later (no jsonb, no extension).
-- Above each view: the meaning of a row, then an example. `lacuna sql FILE --views` prints them and
-- database.md explains the columns. Run numbers are id >> 40, counters id & 1099511627775 (2^40 - 1).

-- One row per run: time, command, how it ended, and the build.
-- example: SELECT run, started, ending, command FROM runs ORDER BY run;
CREATE VIEW runs AS
SELECT run.number AS run, experiment.name AS experiment, run.command, run.started, run.ended,
       coalesce(run.ending, 'not ended') AS ending, run.seed, run.threads,
       provenance.program, provenance.source_revision, provenance.processor, run.identity
FROM run
LEFT JOIN experiment_text ON experiment_text.id = run.experiment_text
LEFT JOIN experiment ON experiment.id = experiment_text.experiment
LEFT JOIN provenance ON provenance.run = run.number;

-- One row per revision of an experiment's model: its parent and the change from it.
-- example: SELECT number, parent, change, effects FROM revisions ORDER BY number;
CREATE VIEW revisions AS
SELECT experiment.name AS experiment, revision.number, parent.number AS parent, revision.change,
       (SELECT group_concat(json_extract(value, '$.effect'), ', ') FROM json_each(revision.effects)) AS effects,
       json_array_length(revision.free) AS free_values, revision.robot,
       revision.id >> 40 AS first_run, revision.digest, revision.id
FROM revision
JOIN experiment ON experiment.id = revision.experiment
LEFT JOIN revision AS parent ON parent.id = revision.parent;

-- One row per trial and channel of the latest refitted comparison of each revision: the error of the free run.
-- example: SELECT revision, trial, channel, rmse, times_floor, max_error_time FROM latest_comparison ORDER BY revision, held_out;
CREATE VIEW latest_comparison AS
SELECT experiment.name AS experiment, revision.number AS revision, trial.name AS trial, trial.held_out,
       score.channel, score.unit, score.rmse, score.floor, score.rmse / score.floor AS times_floor,
       score.normalised_rmse, score.max_error, score.max_error_time, numerical_error.error AS numerical_error,
       score.as_written_rmse, score.samples, comparison.id AS comparison
FROM comparison
JOIN revision ON revision.id = comparison.revision
JOIN experiment ON experiment.id = revision.experiment
JOIN comparison_score AS score ON score.comparison = comparison.id AND score.horizon = 0
JOIN trial ON trial.id = score.trial
LEFT JOIN numerical_error ON numerical_error.comparison = score.comparison
  AND numerical_error.trial = score.trial AND numerical_error.channel = score.channel
  AND numerical_error.horizon = score.horizon
WHERE comparison.id = (
  SELECT max(newer.id) FROM comparison AS newer
  JOIN comparison_score AS newer_score ON newer_score.comparison = newer.id AND newer_score.horizon = 0
  JOIN trial AS newer_trial ON newer_trial.id = newer_score.trial
  WHERE newer.revision = comparison.revision AND newer.kind = 'refitted'
    AND newer_trial.held_out = trial.held_out);

-- One row per trial with a setup: the values that its recording sets, and the values that are fitted to this trial only.
-- example: SELECT trial, setup, settings, own FROM trial_setups ORDER BY trial;
CREATE VIEW trial_setups AS
SELECT experiment.name AS experiment, trial.name AS trial, trial.held_out, trial.setup,
       (SELECT group_concat(said, ', ') FROM (
          SELECT address || ' = ' || printf('%.6g', value) || iif(unit IN ('', '1'), '', ' ' || unit) AS said
          FROM trial_setting WHERE trial_setting.trial = trial.id ORDER BY position)) AS settings,
       (SELECT group_concat(substr(json_extract(free.value, '$.address'), 1,
                                   length(json_extract(free.value, '$.address')) - length(trial.setup) - 1), ', ')
        FROM json_each((SELECT revision.free FROM revision WHERE revision.experiment = trial.experiment
                        ORDER BY revision.number DESC LIMIT 1)) AS free
        WHERE substr(json_extract(free.value, '$.address'), -length(trial.setup) - 1) = '@' || trial.setup) AS own,
       trial.id
FROM trial
JOIN experiment ON experiment.id = trial.experiment
WHERE trial.setup <> '';

-- One row per revision and channel: the error on fit trials and on held-out trials, and in multiples of the noise floor.
-- example: SELECT revision, change, channel, fit_rmse, held_out_rmse, times_floor FROM error_by_revision ORDER BY revision;
CREATE VIEW error_by_revision AS
WITH pooled AS (
  SELECT experiment, revision, channel, unit, held_out,
         sum(rmse IS NULL) AS failed,
         iif(sum(rmse IS NULL) = 0, sqrt(sum(samples * rmse * rmse) / sum(samples)), NULL) AS rmse,
         iif(sum(rmse IS NOT NULL AND floor IS NULL) = 0,
             sqrt(sum(iif(rmse IS NULL, NULL, samples * floor * floor)) / sum(iif(rmse IS NULL, NULL, samples))),
             NULL) AS floor
  FROM latest_comparison
  WHERE samples > 0
  GROUP BY experiment, revision, channel, unit, held_out),
sides AS (
  SELECT experiment, revision, channel, unit, max(held_out) AS looked, sum(failed) AS failed_trials,
         max(iif(held_out = 0, rmse, NULL)) AS fit_rmse, max(iif(held_out = 1, rmse, NULL)) AS held_out_rmse,
         max(iif(held_out = 0, floor, NULL)) AS fit_floor, max(iif(held_out = 1, floor, NULL)) AS held_out_floor
  FROM pooled
  GROUP BY experiment, revision, channel, unit)
SELECT sides.experiment, sides.revision, revision.change, sides.channel, sides.unit, fit_rmse, held_out_rmse,
       coalesce(held_out_floor, fit_floor) AS floor,
       iif(looked, held_out_rmse / held_out_floor, fit_rmse / fit_floor) AS times_floor, failed_trials
FROM sides
JOIN experiment ON experiment.name = sides.experiment
JOIN revision ON revision.experiment = experiment.id AND revision.number = sides.revision;

-- One row per value of the latest fit of each revision, with its 95 % interval.
-- example: SELECT revision, address, value, unit, lower, upper FROM fitted_parameters ORDER BY revision, position;
CREATE VIEW fitted_parameters AS
SELECT experiment.name AS experiment, revision.number AS revision, fitted_value.position, fitted_value.address,
       fitted_value.value, fitted_value.unit, fitted_value.standard_error, fitted_value.lower, fitted_value.upper,
       fitted_value.start, fitted_value.at_bound, fitted_value.identifiable, fit.converged, fit.id AS fit
FROM fit
JOIN revision ON revision.id = fit.revision
JOIN experiment ON experiment.id = revision.experiment
JOIN fitted_value ON fitted_value.fit = fit.id
WHERE fit.id = (SELECT max(id) FROM fit AS newer WHERE newer.revision = fit.revision);

-- One row per comparison that read held-out trials; each one weakens them as evidence.
-- example: SELECT number, revision, time, command FROM holdout_looks ORDER BY number;
CREATE VIEW holdout_looks AS
SELECT experiment.name AS experiment, holdout_look.number, revision.number AS revision, holdout_look.time,
       holdout_look.command, holdout_look.id >> 40 AS run
FROM holdout_look
JOIN experiment ON experiment.id = holdout_look.experiment
JOIN revision ON revision.id = holdout_look.revision;

-- One row per trial and channel of the latest comparison of each revision: the noise floor, its parts and its origin.
-- example: SELECT revision, trial, channel, floor, unit, origin FROM noise_floors ORDER BY revision;
CREATE VIEW noise_floors AS
SELECT experiment.name AS experiment, revision.number AS revision, trial.name AS trial, noise_floor.channel,
       noise_floor.floor, noise_floor.unit, noise_floor.sensor, noise_floor.input, noise_floor.process,
       noise_floor.origin
FROM noise_floor
JOIN trial ON trial.id = noise_floor.trial
JOIN comparison ON comparison.id = noise_floor.comparison
JOIN revision ON revision.id = comparison.revision
JOIN experiment ON experiment.id = revision.experiment
WHERE comparison.id IN (SELECT max(id) FROM comparison GROUP BY revision);

-- One row per diagnosis: its verdict and probability, its answer, and whether the time limit stopped it.
-- example: SELECT revision, verdict, method, chance, answer, base_fitted_times_floor, fitted_times_floor FROM diagnoses ORDER BY id;
CREATE VIEW diagnoses AS
SELECT experiment.name AS experiment, revision.number AS revision, diagnosis.verdict, diagnosis.method,
       diagnosis.probability, diagnosis.calibrated,
       iif(diagnosis.method <> 'horizon', diagnosis.chance, NULL) AS chance, diagnosis.hypotheses,
       iif(diagnosis.verdict = 'effect_found',
           (SELECT group_concat(value, ' + ') FROM json_each(best.effects)), NULL) AS answer,
       iif(diagnosis.method = 'likelihood', diagnosis.base_times_floor, NULL) AS base_times_floor,
       iif(diagnosis.method = 'likelihood', best.times_floor, NULL) AS times_floor,
       diagnosis.base_fitted_times_floor, best.fitted_times_floor, diagnosis.document ->> '$.stopped.during' AS stopped,
       nullif(diagnosis.document ->> '$.next_test', '') AS next_test,
       diagnosis.document ->> '$.next_test_setup.name' AS next_test_setup,
       diagnosis.id >> 40 AS run, diagnosis.id
FROM diagnosis
JOIN revision ON revision.id = diagnosis.revision
JOIN experiment ON experiment.id = revision.experiment
LEFT JOIN candidate_model AS best ON best.diagnosis = diagnosis.id AND best.rank = 1;

-- One row per candidate of the latest diagnosis of each revision, the best first, with its gain on data to which it was not fitted.
-- example: SELECT revision, rank, effects, method, gain, fitted_times_floor FROM effect_ranking ORDER BY revision, rank;
CREATE VIEW effect_ranking AS
SELECT experiment.name AS experiment, revision.number AS revision, candidate_model.rank,
       (SELECT group_concat(value, ' + ') FROM json_each(candidate_model.effects)) AS effects,
       diagnosis.method, candidate_model.gain, candidate_model.gain_lower, candidate_model.gain_upper,
       iif(diagnosis.method = 'likelihood', candidate_model.times_floor, NULL) AS times_floor,
       candidate_model.fitted_times_floor,
       iif(diagnosis.method = 'likelihood', candidate_model.probability, NULL) AS probability,
       (SELECT group_concat(value, ', ') FROM json_each(candidate_model.look_alikes)) AS look_alikes,
       diagnosis.id AS diagnosis
FROM diagnosis
JOIN candidate_model ON candidate_model.diagnosis = diagnosis.id
JOIN revision ON revision.id = diagnosis.revision
JOIN experiment ON experiment.id = revision.experiment
WHERE diagnosis.id = (SELECT max(id) FROM diagnosis AS newer WHERE newer.revision = diagnosis.revision);

-- One row per stored time series: its trial or model, its channels and its size.
-- example: SELECT trial, kind, revision, channels, sample_count, bytes FROM traces ORDER BY id;
CREATE VIEW traces AS
SELECT experiment.name AS experiment, trial.name AS trial, trial.held_out, trace.kind, revision.number AS revision,
       (SELECT group_concat(json_extract(value, '$.name'), ', ') FROM json_each(trace.channels)) AS channels,
       trace.sample_count, trial.duration, length(trace.times) + length(trace.samples) AS bytes, trace.id,
       trace.model >> 40 AS run, (trace.model & 1099511627775) - 1 AS model
FROM trace
JOIN trial ON trial.id = trace.trial
JOIN experiment ON experiment.id = trial.experiment
LEFT JOIN comparison ON comparison.id = trace.comparison
LEFT JOIN revision ON revision.id = comparison.revision;

-- One row per run of the algorithm (a replicate): passes done, best error, cost, and how it ended.
-- example: SELECT run, replicate, passes_done, best_score, ending FROM eea_runs ORDER BY run;
CREATE VIEW eea_runs AS
WITH last AS (
  SELECT run, max(number) AS number, count(*) AS passes, sum(evaluations) AS evaluations, sum(steps) AS steps
  FROM pass WHERE ended GROUP BY run)
SELECT eea_run.run, experiment.name AS experiment, eea_run.replicate, coalesce(run.ending, 'not ended') AS ending,
       coalesce(last.passes, 0) AS passes_done, eea_run.passes,
       (SELECT best_score FROM pass WHERE pass.id BETWEEN eea_run.run << 40 AND (eea_run.run << 40) + 1099511627775
          AND ended AND best_model IS NOT NULL ORDER BY id DESC LIMIT 1) AS best_score,
       metric.name AS metric, fitness.name AS fitness,
       (SELECT coalesce(max(id) & 1099511627775, 0) FROM model
        WHERE id BETWEEN eea_run.run << 40 AND (eea_run.run << 40) + 1099511627775) AS models,
       (SELECT coalesce(max(id) & 1099511627775, 0) FROM test
        WHERE id BETWEEN eea_run.run << 40 AND (eea_run.run << 40) + 1099511627775) AS tests,
       (SELECT count(*) FROM target_trial WHERE target_trial.run = eea_run.run) AS trials,
       coalesce(last.evaluations, 0) AS evaluations, coalesce(last.steps, 0) AS steps, checkpoint.seconds, run.seed,
       (SELECT stopped FROM pass WHERE pass.run = eea_run.run AND stopped IS NOT NULL) AS stopped
FROM eea_run
JOIN run ON run.number = eea_run.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN metric ON metric.id = eea_run.metric
LEFT JOIN metric AS fitness ON fitness.id = eea_run.fitness
LEFT JOIN last ON last.run = eea_run.run
LEFT JOIN checkpoint ON checkpoint.run = eea_run.run;

-- One row per finished pass: the error of the best model over all trials so far, and the cost to find it.
-- example: SELECT run, pass, trials, error, evaluations_so_far FROM error_by_pass ORDER BY run, pass;
CREATE VIEW error_by_pass AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass,
       (SELECT count(*) FROM model_score WHERE model_score.model = pass.best_model
          AND model_score.metric = eea_run.metric) AS trials,
       pass.best_score AS error, metric.name AS metric,
       (pass.best_model & 1099511627775) - 1 AS best_model,
       sum(pass.evaluations) OVER so_far AS evaluations_so_far, sum(pass.steps) OVER so_far AS steps_so_far
FROM pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN metric ON metric.id = eea_run.metric
WHERE pass.ended
WINDOW so_far AS (PARTITION BY pass.run ORDER BY pass.number);

-- One row per free value of the best model of a pass, beside the hidden value of a simulated target.
-- example: SELECT address, value, truth, unit FROM best_model WHERE pass = 2 ORDER BY run, position;
CREATE VIEW best_model AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass,
       (pass.best_model & 1099511627775) - 1 AS model, model.generation, free_value.position, free_value.address,
       best_value.value, free_value.unit, free_value.truth, best_value.value - free_value.truth AS error,
       free_value.lower, free_value.upper, pass.best_score
FROM pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN model ON model.id = pass.best_model
JOIN best_value ON best_value.pass = pass.id
JOIN free_value ON free_value.run = pass.run AND free_value.position = best_value.position;

-- One row per pass and parameter, or group of parameters, of the best model: the difference from the true (hidden) value.
-- example: SELECT pass, address, avg(error), unit FROM parameter_error_by_pass GROUP BY pass, address ORDER BY address, pass;
CREATE VIEW parameter_error_by_pass AS
SELECT experiment, run, replicate, pass, address, abs(error) AS error, unit
FROM best_model
WHERE truth IS NOT NULL AND value IS NOT NULL AND NOT EXISTS (
  SELECT * FROM objective_score
  WHERE objective_score.pass = (best_model.run << 40) + 1 + best_model.pass AND objective_score.name = best_model.address)
UNION ALL
SELECT experiment.name, pass.run, eea_run.replicate, pass.number, objective_score.name, objective_score.value,
       objective_score.unit
FROM objective_score
JOIN pass ON pass.id = objective_score.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment;

-- One row per free value of a model that a pass carried over to the next, beside the hidden value; the best of each structure and restart first.
-- example: SELECT pass, rank, structure, address, value, truth, unit FROM ensembles WHERE pass = 2 ORDER BY run, rank, position;
CREATE VIEW ensembles AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass, ensemble_model.rank,
       (ensemble_model.model & 1099511627775) - 1 AS model, ensemble_model.structure, ensemble_model.score,
       free_value.position, free_value.address, ensemble_value.value, free_value.unit, free_value.truth
FROM ensemble_model
JOIN pass ON pass.id = ensemble_model.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
LEFT JOIN ensemble_value ON ensemble_value.pass = ensemble_model.pass AND ensemble_value.rank = ensemble_model.rank
LEFT JOIN free_value ON free_value.run = pass.run AND free_value.position = ensemble_value.position;

-- Prediction error on new trials, one row per trial that a run carried out: error of the best model before the trial was fitted, and number of passes in which the trial was excluded.
-- example: SELECT run, trial, surprise, metric, passes_set_aside FROM foretold ORDER BY run, trial;
CREATE VIEW foretold AS
SELECT experiment.name AS experiment, target_trial.run, eea_run.replicate, target_trial.number AS trial,
       target_trial.surprise, metric.name AS metric, target_trial.for_transfer,
       (SELECT count(*) FROM set_aside WHERE set_aside.trial = target_trial.trial
          AND set_aside.pass >> 40 = target_trial.run) AS passes_set_aside
FROM target_trial
JOIN eea_run ON eea_run.run = target_trial.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN metric ON metric.id = eea_run.metric;

-- One row per test that was carried out on the target: the result that the models predicted when they chose it, and the target's result.
-- example: SELECT run, pass, predicted, measured, gap FROM transfer_gap ORDER BY run, trial;
CREATE VIEW transfer_gap AS
SELECT experiment.name AS experiment, target_trial.run, eea_run.replicate, pass.number AS pass,
       target_trial.number AS trial, (test.id & 1099511627775) - 1 AS test, fitness.name AS fitness,
       fitness_unit AS unit, predicted_fitness AS predicted, measured_fitness AS measured, measured_fitness - predicted_fitness AS gap,
       for_transfer
FROM target_trial
JOIN eea_run ON eea_run.run = target_trial.run
JOIN experiment ON experiment.id = eea_run.experiment
JOIN test ON test.id = target_trial.test
JOIN pass ON pass.id = test.pass
LEFT JOIN metric AS fitness ON fitness.id = eea_run.fitness
WHERE predicted_fitness IS NOT NULL;

-- One row per finished pass: number of evaluations, how many of them were cut short or reused, and their steps.
-- example: SELECT run, pass, evaluations, abandoned, reused, steps FROM evaluations ORDER BY run, pass;
CREATE VIEW evaluations AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass, evaluations, abandoned, reused,
       invalid, steps, test_evaluations, invalid_tests, test_steps
FROM pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment
WHERE ended;

-- One row per model or test that could not be scored, with the reason.
-- example: SELECT run, kind, reason, count(*) AS times FROM invalid_evaluations GROUP BY run, kind, reason ORDER BY times DESC;
CREATE VIEW invalid_evaluations AS
SELECT experiment.name AS experiment, pass.run, eea_run.replicate, pass.number AS pass, failed.generation, failed.kind,
       failed.number, failed.reason
FROM (SELECT 'model' AS kind, pass, generation, (id & 1099511627775) - 1 AS number, reason
      FROM invalid_model JOIN model ON model.id = invalid_model.model
      UNION ALL
      SELECT 'test', pass, generation, (id & 1099511627775) - 1, reason
      FROM invalid_test JOIN test ON test.id = invalid_test.test) AS failed
JOIN pass ON pass.id = failed.pass
JOIN eea_run ON eea_run.run = pass.run
JOIN experiment ON experiment.id = eea_run.experiment;

-- One row per test that a target failed to carry out, with the reason; nothing was measured.
-- example: SELECT trial, failed, reason FROM failed_trials ORDER BY failed;
CREATE VIEW failed_trials AS
SELECT experiment.name AS experiment, failed_trial.run, failed_trial.trial, failed_trial.test, failed_trial.failed,
       failed_trial.reason
FROM failed_trial
JOIN experiment ON experiment.id = failed_trial.experiment;
