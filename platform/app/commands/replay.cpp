#include "app/commands/commands.h"
#include "app/runs/open_stored_run.h"
#include "app/runs/stored_model.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "evaluation/prediction/test_predictor.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/csv_cell.h"
#include "foundation/unit.h"
#include "report/text/text_table.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>

namespace lacuna {
namespace {

struct ReplayOptions {
  std::filesystem::path database;
  std::optional<std::int64_t> run;
  std::optional<std::uint64_t> model;
  std::optional<int> trial;
  std::vector<std::filesystem::path> plugin_paths;
  std::optional<std::string> csv;
};

std::string values_text(const StoredModel& model) {
  std::vector<std::vector<std::string>> table;
  for (std::size_t i = 0; i < model.model.values.size(); ++i) {
    const FreeValue& free = model.definition.model.free[i];
    const double value = model.model.values[i];
    table.push_back({free.address, std::isnan(value) ? "-" : format_quantity(value, free.unit)});
  }
  return text_table(table);
}

std::string scores_text(const StoredModel& model, const ModelScore& score) {
  std::vector<std::vector<std::string>> table = {{"trial", "stored", "replayed"}};
  const std::vector<double>& stored = model.row.trial_scores;
  for (std::size_t i = 0; i < model.trials.size(); ++i) {
    const auto number = static_cast<std::size_t>(model.numbers[i]);
    table.push_back({std::to_string(number), number < stored.size() ? fmt::format("{:.17g}", stored[number]) : "-",
                     i < score.trials.size() ? fmt::format("{:.17g}", score.trials[i]) : "-"});
  }
  table.push_back({"all", fmt::format("{:.17g}", model.row.score), fmt::format("{:.17g}", score.total)});
  return text_table(table);
}

/// Time, measured and predicted channels of a trial.
std::string csv_of(const ScoredTrial& scored, const TimeSeries& predicted) {
  const TimeSeries& measured = scored.trial.measured;
  std::string text = "t_s";
  for (const Channel& channel : measured.channels)
    text += "," + csv_cell(channel.name + "_measured") + "," + csv_cell(channel.name + "_predicted");
  text += '\n';
  for (Eigen::Index row = 0; row < measured.times.size(); ++row) {
    text += fmt::format("{:.9g}", measured.times(row));
    for (std::size_t c = 0; c < measured.channels.size(); ++c) {
      const auto channel = std::find(predicted.channels.begin(), predicted.channels.end(), measured.channels[c]);
      text += fmt::format(",{:.17g},{:.17g}", measured.samples(row, static_cast<Eigen::Index>(c)),
                          predicted.samples(row, channel - predicted.channels.begin()));
    }
    text += '\n';
  }
  return text;
}

void write_series(const StoredModel& model, const ReplayOptions& options) {
  const int wanted = options.trial.value_or(model.numbers.back());
  const auto found = std::find(model.numbers.begin(), model.numbers.end(), wanted);
  if (found == model.numbers.end())
    throw_problem({}, fmt::format("--trial {}: model {} was scored only on trials {}", wanted, model.number,
                                  fmt::join(model.numbers, ", ")));
  const ScoredTrial& scored = model.trials[static_cast<std::size_t>(found - model.numbers.begin())];
  const Eigen::VectorXd& times = scored.trial.measured.times;
  const TestPredictor predictor(*model.definition.compiled, {times.begin(), times.end()}, {1, model.stop},
                                &model.definition.model);
  TestPrediction prediction;
  std::uint64_t steps = 0;
  std::string reason;
  if (!predictor.predict(model.model, scored.test, 0, prediction, steps, reason)) throw Error(reason);
  write_output(*options.csv, csv_of(scored, prediction.sensors));
}

void replay(const ReplayOptions& options) {
  check_output(options.csv);
  const LogLeft log(options.database);
  Database database = Database::open_read_only(options.database, when_interrupted());
  const EeaRunListing run = choose_run(database, options.run);
  const OpenStoredRun stored = open_stored(database, run, options.plugin_paths);
  for (const std::string& doubt : stored.doubts) std::fprintf(stderr, "%s\n", doubt.c_str());
  std::mutex unused;
  const EeaStore store(database, unused, run.run, {});
  const std::vector<PassRow> passes = store.passes();
  if (!options.model && (passes.empty() || !passes.back().best_model))
    throw Error("the run has no finished pass; name a model: --model N");
  const std::uint64_t number = options.model ? *options.model : *passes.back().best_model;
  const StoredModel model = stored_model(store, stored.opened->definition(), number, stored.opened->opened().stop);
  const ModelScore score = score_again(model);
  if (!takes_standard_output(options.csv)) {
    fmt::print("run {} · model {} · pass {}, generation {}\n", run.run.value, number, model.row.pass,
               model.row.generation);
    if (!model.model.structure.empty()) fmt::print("structure {}\n", model.model.structure);
    fmt::print("{}{}", values_text(model), scores_text(model, score));
  }
  if (options.csv) write_series(model, options);
  if (!agrees(model.row, score)) throw Error("the replayed scores differ from the stored ones");
}

}  // namespace

void add_replay_command(CLI::App& program) {
  auto options = std::make_shared<ReplayOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("replay", "Simulate a stored model again and compare its scores with the stored ones");
  add_database_argument(*command, options->database);
  command->add_option("--run", options->run, "Run (required if there are several)")->option_text("N");
  command
      ->add_option("--model", options->model,
                   "Number of the model in its run (default: the best one at the end of the run)")
      ->option_text("N");
  command->add_option("--trial", options->trial, "Trial that --csv writes (default: the newest)")->option_text("N");
  command->add_option("--plugin-path", options->plugin_paths, "Folder with plugins, searched before all others")
      ->allow_extra_args(false)
      ->option_text("FOLDER");
  add_result_option(*command, "csv", options->csv, "Measured and predicted series, to standard output or FILE");
  command->callback([options] { replay(*options); });
}

}  // namespace lacuna
