#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/open_experiment.h"
#include "app/workspace/run_inputs.h"
#include "app/workspace/test_reading.h"
#include "app/workspace/trial_target.h"
#include "app/workspace/used_plugins.h"
#include "documents/setup_json.h"
#include "evaluation/prediction/step_count.h"
#include "evaluation/prediction/test_space.h"
#include "foundation/files/allowed_files.h"
#include "foundation/text/counted.h"
#include "foundation/text/shell_word.h"
#include "measurement/command_file.h"
#include "storage/eea/failed_trials.h"
#include "storage/results/carried_out.h"
#include "storage/results/result_store.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

struct TrialOptions : CommonOptions {
  AskedTest asked;
  bool held_out = false;
  std::optional<std::string> csv;
};

/// Without what comes after the end, and with a last row at the end, which tells how long the last command is held.
CommandSeries until(CommandSeries commands, double end) {
  TimeSeries& series = commands.series;
  Eigen::Index rows = 0;
  while (rows < series.times.size() && series.times(rows) < end) ++rows;
  rows = std::max<Eigen::Index>(rows, 1);
  series.times.conservativeResize(rows + 1);
  series.samples.conservativeResize(rows + 1, Eigen::NoChange);
  series.times(rows) = end;
  series.samples.row(rows) = series.samples.row(rows - 1);
  return commands;
}

/// Each trial is stored in a separate run, begun in a transaction of the caller.
struct TrialRun {
  RunId run;
  ExperimentId experiment;
};

TrialRun begin_run(const OpenExperiment& opened, std::uint64_t seed, ResultStore& store) {
  const Experiment& experiment = opened.experiment;
  const RunId run = store.begin_run({command_line(), seed, 1}, provenance_of_this_program());
  store.record_plugins(plugins_of_model(experiment, *opened.catalog));
  store.record_robot_files(robot_files_of(experiment));
  return {run, store.record_experiment({experiment.name, experiment.file.string(), experiment.text,
                                        experiment.overrides, experiment.decided})};
}

std::int64_t next_number(const Database& database, const OpenExperiment& opened) {
  return count_carried_out(database, opened.experiment.name) + 1;
}

std::string name_of(std::int64_t number) { return fmt::format("trial-{}", number); }

/// Its name is that of the next number, which another process may have taken while the target worked.
void keep(const TrialOptions& options, const OpenExperiment& opened, const TrialTarget& target, std::uint64_t seed,
          Trial& trial, Database& database) {
  ResultStore store(database);
  Transaction transaction(database);
  const TrialRun entered = begin_run(opened, seed, store);
  trial.name = name_of(next_number(database, opened));
  record_carried_out(database, entered.run, entered.experiment, trial, {options.asked.test, target.digest()});
  store.end_run(RunEnding::done);
  transaction.commit();
}

void keep_failure(const TrialOptions& options, const OpenExperiment& opened, std::uint64_t seed,
                  const std::string& name, const std::string& reason, Database& database) {
  ResultStore store(database);
  Transaction transaction(database);
  const TrialRun entered = begin_run(opened, seed, store);
  record_failed_trial(database, entered.run, entered.experiment, {name, options.asked.test, reason});
  store.end_run(RunEnding::failed);
  transaction.commit();
}

/// The database is not held while the target works, which may take long.
Trial carry_out(const TrialOptions& options, const OpenExperiment& opened, TrialTarget& target, const Test& test) {
  Database database = Database::open(database_of(options, opened.experiment), opened.stop);
  const std::uint64_t seed = options.seed.value_or(opened.experiment.seed);
  const std::int64_t number = next_number(database, opened);
  Trial trial;
  try {
    trial = target.carry_out(test, seed, static_cast<std::uint64_t>(number));
  } catch (const BadInput&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& error) {
    keep_failure(options, opened, seed, name_of(number), error.what(), database);
    throw Error(std::string(error.what()) + "\n" + name_of(number) +
                " is stored as failed (view failed_trials); correct the cause, then repeat the command");
  }
  trial.held_out = options.held_out;
  keep(options, opened, target, seed, trial, database);
  return trial;
}

void report(const TrialOptions& options, const OpenExperiment& opened, const Trial& trial, double duration) {
  const Eigen::Index samples = trial.measured.times.size();
  if (!takes_standard_output(options.json)) {
    fmt::print("{}{} · {} · {:.4g} s, {} of {}\n", trial.name, options.held_out ? " (held out)" : "",
               options.asked.test, duration, counted(static_cast<std::size_t>(samples), "sample"),
               counted(trial.measured.channels.size(), "channel"));
    fmt::print("→ {}\n", command_to_type("fit", options));
  }
  if (options.json)
    write_output(*options.json, nlohmann::json{{"trial", trial.name},
                                               {"test", options.asked.test},
                                               {"duration", duration},
                                               {"samples", samples},
                                               {"held_out", options.held_out},
                                               {"seed", options.seed.value_or(opened.experiment.seed)},
                                               {"database", database_of(options, opened.experiment).string()}}
                                        .dump(2) +
                                    "\n");
}

/// The lines that add the new recording to the experiment, for a rig that is set up.
std::string recording_lines(const TrialOptions& options, const KnownSetup& setup) {
  std::string lines = "[[target.recording]]\nfile = \"new.csv\"\n";
  if (options.held_out) lines += "role = \"holdout\"\n";
  std::vector<std::string> set;
  for (const KnownSetup::Setting& one : setup.settings)
    set.push_back(one.unit == "1" ? fmt::format("\"{}\" = {}", one.address, one.value)
                                  : fmt::format("\"{}\" = \"{} {}\"", one.address, one.value, one.unit));
  if (!set.empty()) lines += fmt::format("set = {{ {} }}\n", fmt::join(set, ", "));
  if (!setup.own.empty()) lines += fmt::format("own = [\"{}\"]\n", fmt::join(setup.own, "\", \""));
  return lines;
}

/// The setup that the rig must have, if recordings have setups.
std::string setup_advice(const TrialOptions& options, const KnownSetup& setup) {
  return fmt::format(
      "{}{}\nset the rig up like this, apply these commands, record it, and add the measured file to {}:\n{}",
      setup_text(setup), options.asked.setup ? "" : ", the first recording's; choose another with --setup NAME",
      shell_word(options.experiment.string()), recording_lines(options, setup));
}

/// What a person does with the table of commands.
std::string advice(const TrialOptions& options, bool takes_tests, const std::optional<KnownSetup>& setup) {
  const std::string experiment = shell_word(options.experiment.string());
  if (takes_tests)
    return options.csv->empty() ? ""
                                : fmt::format("→ lacuna trial {} --test {}{}\n", experiment, shell_word(*options.csv),
                                              options_to_type(options));
  if (setup) return setup_advice(options, *setup);
  return fmt::format(
      "apply these commands to the rig, record it, and add the measured file to target.{0} in {1}, as in {0} = "
      "[\"...\", "
      "\"new.csv\"]\n",
      options.held_out ? "holdout" : "files", experiment);
}

void write_commands(const TrialOptions& options, const Test& test, bool takes_tests,
                    const std::optional<KnownSetup>& setup) {
  const CommandSeries& commands = std::get<CommandSeries>(test.drive);
  const std::string file = options.csv.value_or("");
  write_output(file, command_csv(until(commands, test.duration)));
  std::fputs(advice(options, takes_tests, setup).c_str(),
             file.empty() || takes_standard_output(options.json) ? stderr : stdout);
  if (options.json)
    write_output(*options.json, nlohmann::json{{"test", options.asked.test},
                                               {"duration", test.duration},
                                               {"samples", commands.series.times.size()},
                                               {"held_out", options.held_out},
                                               {"setup", setup ? nlohmann::json(setup_json(*setup)) : nullptr},
                                               {"csv", file}}
                                        .dump(2) +
                                    "\n");
}

void run_trial(const TrialOptions& options) {
  check_output(options.json, options.csv);
  const OpenExperiment opened = open_experiment(options);
  if (files_are_limited() && opened.experiment.target.kind == "process")
    throw_problem(opened.experiment.where("target.kind"),
                  "the target is a program, and an agent may not start programs; carry out the test yourself: " +
                      command_to_type("trial", options) + " --test " + shell_word(options.asked.test));
  const int replicate = last_replicate(database_of(options, opened.experiment), opened.experiment.name, opened.stop);
  TrialTarget target(opened.experiment, opened.definition, *opened.catalog, replicate, opened.stop);
  const RobotSpec& robot = target.robot() ? *target.robot() : opened.definition.structure.robot;
  const TestSpace space = test_space(robot, opened.experiment.engine, 0.0);
  if (const std::optional<double> asked = asked_duration(options.asked))
    check_step_count(opened.experiment, *asked, "of the test");
  const KnownSetup setup = asked_setup(options.asked, opened.experiment, opened.definition);
  if (options.held_out && !setup.own.empty())
    throw_problem({}, "setup " + setup.name() +
                          " has values that are fitted to its trials, and no fit reads a held-out trial: leave out "
                          "--holdout, or choose another setup");
  Test test = read_test(options.asked, space, *opened.catalog);
  test.setup = setup.name();
  check_step_count(opened.experiment, test.duration, "of the test");
  if (target.takes_tests() && !options.csv)
    report(options, opened, carry_out(options, opened, target, test), test.duration);
  else if (!target.takes_tests() && !options.csv && takes_standard_output(options.json))
    throw_problem({},
                  "Lacuna cannot carry out tests on a recorded target; name a file for the commands, because JSON goes "
                  "to standard output: --csv=FILE");
  else
    write_commands(options, test, target.takes_tests(),
                   any_is_set(known_setups(opened.definition, opened.experiment.target.recording))
                       ? std::optional(setup)
                       : std::nullopt);
}

}  // namespace

void add_trial_command(CLI::App& program) {
  auto options = std::make_shared<TrialOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("trial",
                                             "Send a test to the target (the simulation or program to be identified), "
                                             "or write its commands to a CSV file for a rig");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_test_options(
      *command, options->asked,
      "Test (required): a line such as \"triangle motor 0.3 N*m 0.1 Hz 20 s\" (shape, actuator, amplitude, "
      "frequency, duration; the shape is triangle, steps, chirp or multisine), or a CSV file of commands");
  command->add_flag("--holdout", options->held_out, "Hold the trial out: no fit reads it");
  add_result_option(*command, "csv", options->csv,
                    "Write the commands as CSV, to standard output or FILE; carry nothing out");
  command->callback([options] { run_trial(*options); });
}

}  // namespace lacuna
