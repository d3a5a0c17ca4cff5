#include "app/commands/commands.h"
#include "app/runs/open_stored_run.h"
#include "app/runs/stored_ensembles.h"
#include "app/terminal/output.h"
#include "app/workspace/one_model.h"
#include "app/workspace/test_reading.h"
#include "config/experiment_reader.h"
#include "evaluation/prediction/step_count.h"
#include "evaluation/prediction/target_simulator.h"
#include "evaluation/prediction/test_space.h"
#include "foundation/parallel.h"
#include "foundation/text/shell_word.h"
#include "report/figures/model_prediction_picture.h"
#include "report/figures/prediction_picture.h"
#include "report/json/model_prediction_data.h"
#include "report/json/prediction_data.h"
#include "report/text/prediction_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>
#include <regex>
#include <utility>

namespace lacuna {
namespace {

constexpr int kMostSupported = static_cast<int>(kFewestHeldOut);  // passes that may leave a band without support

struct PredictOptions : CommonOptions {
  AskedTest asked;
  bool fitted = false;
  std::optional<std::int64_t> run;
  std::optional<std::string> csv;
  std::optional<std::string> picture;
};

/// A test that the models are to predict.
struct WantedTest {
  Test test;
  std::vector<double> times;  ///< when sensors are read, s
  std::optional<MeasuredTest> measured = {};
  std::optional<KnownSetup> setup = {};  ///< where recordings have some
};

/// The run that was asked for, or the newest one, of the experiment, with a pass that has ended.
EeaRunListing run_to_ask(const Database& database, const PredictOptions& options, const std::string& experiment) {
  const SourceLocation file{database.file().string()};
  const std::string again = command_to_type("run", options);
  if (options.run) {
    EeaRunListing run = choose_run(database, options.run);
    if (run.experiment != experiment)
      throw_problem(file, fmt::format("run {} is of {}, not of {}; lacuna runs lists them", run.run.value,
                                      run.experiment, experiment));
    if (run.passes_done > 0) return run;
    throw_problem(file, fmt::format("run {} has no finished pass; to continue it: {} --resume", run.run.value, again));
  }
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::erase_if(runs, [&](const EeaRunListing& run) { return run.experiment != experiment || run.passes_done == 0; });
  if (runs.empty())
    throw_problem(file, fmt::format("has no run of {} with a finished pass; make one: {}", experiment, again));
  return runs.back();
}

/// Whether some models of a run are to be asked: one that is named, or any that the database has of the experiment.
bool asks_a_run(const PredictOptions& options, const std::filesystem::path& database, const std::string& experiment) {
  if (options.run || options.fitted) return options.run.has_value();
  std::error_code ignored;
  if (!std::filesystem::exists(database, ignored)) return false;
  refuse_empty(database);
  const std::vector<EeaRunListing> runs = eea_runs(Database::open_read_only(database, options.stop));
  return std::any_of(runs.begin(), runs.end(),
                     [&](const EeaRunListing& run) { return run.experiment == experiment && run.passes_done > 0; });
}

/// "test 17" and "17" are numbers of tests.
std::optional<std::uint64_t> test_number(const std::string& test) {
  static const std::regex kNumber("(?:test +)?([0-9]{1,18})");
  std::smatch found;
  if (!std::regex_match(test, found, kNumber)) return std::nullopt;
  return std::stoull(found[1]);
}

/// What has to be known of a run to predict a test.
struct AskedRun {
  const OpenStoredRun& stored;
  const EeaStore& store;
  const std::vector<RunTrial>& trials;
  const StoredEnsembles& ensembles;

  const EeaDefinition& definition() const { return stored.opened->definition(); }
  const OpenExperiment& opened() const { return stored.opened->opened(); }
};

/// A test that was carried out is predicted as it was asked for, from its start on and when it was measured.
WantedTest carried_out_test(const AskedRun& run, const RunTrial& trial, const AskedTest& asked) {
  const ScoredTrial observed = as_new_trial(trial);
  const Eigen::VectorXd& times = observed.trial.measured.times;
  WantedTest wanted{as_carried_out(observed),
                    {times.begin(), times.end()},
                    MeasuredTest{trial.row.number, run.ensembles.fitted(trial), trial.trial.measured}};
  if (const std::optional<double> duration = asked_duration(asked)) {
    wanted.test.duration = *duration;
    wanted.times = sample_times(run.opened().experiment.engine, *duration);
  }
  return wanted;
}

WantedTest numbered_test(const AskedRun& run, std::uint64_t number, const AskedTest& asked) {
  for (const RunTrial& trial : run.trials)
    if (trial.row.test == number) return carried_out_test(run, trial, asked);
  const std::optional<TestRow> row = run.store.test(number);
  if (!row)
    throw_problem({}, fmt::format("--test {}: run {} has no such test; tests are numbered from 0, and the view "
                                  "transfer_gap lists those that were carried out",
                                  asked.test, run.stored.listing.run.value));
  WantedTest wanted{run.definition().decode_test(row->genome), {}};
  wanted.test.duration = asked_duration(asked).value_or(wanted.test.duration);
  wanted.times = sample_times(run.opened().experiment.engine, wanted.test.duration);
  return wanted;
}

WantedTest wanted_test(const AskedRun& run, const AskedTest& asked) {
  if (const std::optional<double> duration = asked_duration(asked))
    check_step_count(run.opened().experiment, *duration, "of the test");
  if (const std::optional<std::uint64_t> number = test_number(asked.test)) {
    if (asked.setup)
      throw_problem({}, "--setup is for new tests; test " + std::to_string(*number) +
                            " of the run has a setup already. Leave --setup out");
    return numbered_test(run, *number, asked);
  }
  const Experiment& experiment = run.opened().experiment;
  const KnownSetup setup = asked_setup(asked, experiment, run.opened().definition);
  const ModelDefinition* target = run.stored.opened->target();
  const RobotSpec& robot = (target ? *target : run.opened().definition).structure.robot;
  const TestSpace space = test_space(robot, run.opened().experiment.engine, 0.0);
  WantedTest wanted{read_test(asked, space, *run.opened().catalog), {}};
  wanted.test.setup = setup.name();
  if (any_is_set(known_setups(run.opened().definition, experiment.target.recording))) wanted.setup = setup;
  check_step_count(run.opened().experiment, wanted.test.duration, "of the test");
  wanted.times = sample_times(run.opened().experiment.engine, wanted.test.duration);
  return wanted;
}

/// Of an ensemble's models, each with the number of those that have it; the most frequent first.
std::vector<std::pair<std::string, std::size_t>> structures_of(const PassEnsemble& ensemble) {
  std::vector<std::pair<std::string, std::size_t>> structures;
  for (const ModelProposal& model : ensemble.models) {
    const auto known = std::find_if(structures.begin(), structures.end(),
                                    [&](const auto& structure) { return structure.first == model.structure; });
    if (known == structures.end())
      structures.emplace_back(model.structure, 1);
    else
      ++known->second;
  }
  std::stable_sort(structures.begin(), structures.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return structures;
}

/// Channels on which no model was scored.
std::vector<std::string> unscored_channels(const EeaDefinition& definition) {
  std::vector<std::string> unscored;
  const std::vector<std::string>& scored = definition.scored_channels;
  for (const Channel& channel : definition.compiled->channels())
    if (!scored.empty() && std::find(scored.begin(), scored.end(), channel.name) == scored.end())
      unscored.push_back(channel.name);
  return unscored;
}

PredictionReport report_of(const AskedRun& run, const PredictOptions& options) {
  const Work work = options.work();
  WantedTest wanted = wanted_test(run, options.asked);
  const PassEnsemble ensemble = run.ensembles.newest();
  EnsemblePrediction prediction = predict_test(run.definition(), ensemble, wanted.test, wanted.times, work,
                                               wanted.measured ? wanted.times.front() : 0.0);
  if (prediction.models == 0)
    throw Error(fmt::format("no model of the run can carry out the test: {}", prediction.lost.front().reason));
  BandSupport support = support_of(run.ensembles.held_out(work.threads), options.seed.value_or(1));
  widen(prediction.band, support);
  const std::optional<std::uint64_t> number = test_number(options.asked.test);
  return {.experiment = run.opened().experiment.name,
          .run = run.stored.listing.run.value,
          .pass = ensemble.pass,
          .test = number ? fmt::format("test {}", *number) : options.asked.test,
          .duration = wanted.times.back(),
          .setup = std::move(wanted.setup),
          .setup_is_asked = options.asked.setup.has_value(),
          .structures = structures_of(ensemble),
          .copies = ensemble.copies,
          .refuted = ensemble.refuted,
          .unscored = unscored_channels(run.definition()),
          .noise = ensemble.noise,
          .prediction = std::move(prediction),
          .support = std::move(support),
          .measured = std::move(wanted.measured)};
}

/// The words that name the same database and, where it was asked for, the same duration.
std::string same_words(const PredictOptions& options, bool with_duration) {
  std::string words;
  if (!options.database.empty()) words += " --db " + shell_word(options.database.string());
  if (with_duration && !options.asked.duration.empty()) words += " --duration " + shell_word(options.asked.duration);
  return words;
}

std::string setup_words(const PredictionReport& report) {
  return report.setup ? " --setup " + shell_word(setup_to_type(*report.setup)) : "";
}

/// What a reader may do next.
std::string next_step(const PredictOptions& options, const AskedRun& run, const PredictionReport& report) {
  const std::string experiment = shell_word(options.experiment.string());
  if (!report.support.enough() && run.definition().passes <= kMostSupported && run.stored.opened->takes_tests())
    return fmt::format("→ to calibrate the band, run more passes: lacuna run {} --set experiment.passes={}{}\n",
                       experiment, kFewestHeldOut + 1, same_words(options, false));
  if (!test_number(options.asked.test))
    return fmt::format("→ lacuna trial {} --test {}{}{}\n", experiment, shell_word(options.asked.test),
                       same_words(options, true) + setup_words(report),
                       run.stored.opened->takes_tests() ? "" : " --csv=commands.csv");
  if (!options.picture)
    return fmt::format("→ lacuna predict {} --test {}{} --out prediction.svg\n", experiment,
                       shell_word(options.asked.test), same_words(options, true) + setup_words(report));
  return {};
}

void write_report(const PredictOptions& options, const AskedRun& run, const PredictionReport& report) {
  if (!takes_standard_output(options.csv) && !takes_standard_output(options.json)) {
    fmt::print("{}", prediction_text(report));
    if (!options.quiet) fmt::print("{}", next_step(options, run, report));
  }
  if (options.json) write_output(*options.json, prediction_json(report));
  if (options.csv) write_output(*options.csv, prediction_csv(report.prediction));
  if (options.picture) write_output(*options.picture, svg_of(prediction_figure(report), options.stop));
}

/// A run's genomes mean what they meant when it was begun.
void check_overrides(const std::vector<std::string>& overrides) {
  std::vector<Problem> problems;
  for (const std::string& one : overrides)
    if (!one.starts_with("experiment."))
      problems.push_back({{},
                          fmt::format("--set {}: the run's models and trials belong to the settings that it was begun "
                                      "with; make a run with other settings: lacuna run --set",
                                      one)});
  if (!problems.empty()) throw BadInput(std::move(problems));
}

/// Those that say how the experiment is called and how long a run of it is.
std::vector<std::string> of_experiment(std::vector<std::string> overrides) {
  std::erase_if(overrides, [](const std::string& one) { return !one.starts_with("experiment."); });
  return overrides;
}

/// Without a run there is the experiment's own model, which a fit knows.
void predict_without_run(const PredictOptions& options, const std::filesystem::path& database) {
  if (test_number(options.asked.test))
    throw_problem({database.string()}, fmt::format("--test {}: a number names a test of a run, and the database has no "
                                                   "run of this experiment with a finished pass; make one: {}",
                                                   options.asked.test, command_to_type("run", options)));
  ExperimentWorkflow workflow(options);
  const ModelPrediction prediction = predict_by_one_model(workflow, options.asked);
  workflow.recorder().done();
  if (!takes_standard_output(options.csv) && !takes_standard_output(options.json)) {
    fmt::print("{}", model_prediction_text(prediction));
    if (!options.quiet)
      fmt::print("→ for several models and an uncertainty band: {}\n", command_to_type("run", options));
  }
  if (options.json) write_output(*options.json, model_prediction_json(prediction));
  if (options.csv) write_output(*options.csv, model_prediction_csv(prediction));
  if (options.picture) write_output(*options.picture, svg_of(model_prediction_figure(prediction), options.stop));
}

void predict(const PredictOptions& options) {
  check_output(options.json, options.csv);
  check_output(options.picture);
  if (options.run && options.fitted)
    throw_problem({}, "--run uses the models of a run and --fitted the fitted model; give only one of them");
  const Experiment experiment = read_experiment(options.experiment, of_experiment(options.overrides));
  const CommonOptions& given = options;
  CommonOptions common = given;
  common.database = database_of(options, experiment);
  note_database(common.database);
  if (!asks_a_run(options, common.database, experiment.name)) return predict_without_run(options, common.database);
  check_overrides(options.overrides);
  if (options.asked.test.empty())
    throw_problem({},
                  "say which test to predict: --test \"triangle ACTUATOR ...\"; to simulate the fitted model on the "
                  "trials instead: --fitted");
  Database database = Database::open_read_only(common.database, options.stop);
  const EeaRunListing listing = run_to_ask(database, options, experiment.name);
  const OpenStoredRun stored = open_stored(database, listing, common);
  if (!options.quiet)
    for (const std::string& doubt : stored.doubts) std::fprintf(stderr, "%s\n", doubt.c_str());
  if (!options.quiet && experiment.text != stored.run.experiment.text)
    std::fprintf(stderr, "%s has changed since run %s began; the run's own version is used\n",
                 options.experiment.c_str(), std::to_string(listing.run.value).c_str());
  std::mutex unused;
  const EeaStore store(database, unused, listing.run, {});
  const std::vector<RunTrial> trials = run_trials(store, stored.opened->definition());
  const StoredEnsembles ensembles(store, stored.opened->definition(), trials, options.stop);
  if (ensembles.empty())
    throw_problem(
        {database.file().string()},
        fmt::format(
            "run {} was made by an older version, which did not store the models of each pass; make a new run: {}",
            listing.run.value, command_to_type("run", options)));
  const AskedRun run{stored, store, trials, ensembles};
  write_report(options, run, report_of(run, options));
}

}  // namespace

void add_predict_command(CLI::App& program) {
  auto options = std::make_shared<PredictOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand(
      "predict", "Predict the outcome of a test with the models of a run, or with the fitted model");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_test_options(*command, options->asked,
                   "Test to predict: a line such as \"triangle motor 0.3 N*m 0.1 Hz 20 s\", a CSV file of commands, or "
                   "the number of a test of the run. With --fitted: also the "
                   "name of a fit trial; without --test, all fit trials are predicted");
  command->get_option("--test")->required(false);
  command->add_flag("--fitted", options->fitted, "Use the fitted model even if there are runs");
  command->add_option("--run", options->run, "Run (default: the experiment's newest)")->option_text("N");
  add_result_option(
      *command, "csv", options->csv,
      "Prediction as CSV (mean and 95 % band of the run's models, or the fitted model), to standard output or FILE");
  command->add_option("--out", options->picture, "Picture of the prediction (SVG)")->option_text("FILE");
  command->callback([options] { predict(*options); });
}

}  // namespace lacuna
