#include "app/workspace/test_reading.h"

#include "config/toml/quantity.h"
#include "experiment_design/test_line.h"
#include "foundation/processes/guarded_call.h"
#include "foundation/text/problem.h"
#include "measurement/command_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

bool is_file(const std::string& test) {
  std::error_code ignored;
  return test.ends_with(".csv") || std::filesystem::is_regular_file(test, ignored);
}

void check_limits(const TestSpace& space, const CommandSeries& commands, const std::string& file) {
  ProblemList problems;
  const TimeSeries& series = commands.series;
  for (std::size_t c = 0; c < series.channels.size(); ++c)
    for (std::size_t a = 0; a < space.actuators.size(); ++a) {
      if (space.actuators[a].name != series.channels[c].name) continue;
      const auto column = series.samples.col(static_cast<Eigen::Index>(c));
      if (column.minCoeff() < space.lower[a] || column.maxCoeff() > space.upper[a])
        problems.add({file}, fmt::format("commands of {0} from {1:.4g} to {2:.4g} {5} exceed its limits, {3:.4g} to "
                                         "{4:.4g} {5}; scale them down",
                                         space.actuators[a].name, column.minCoeff(), column.maxCoeff(), space.lower[a],
                                         space.upper[a], space.actuators[a].unit));
    }
  problems.throw_if_any();
}

Test test_of_file(const AskedTest& asked, const TestSpace& space) {
  Test test;
  CommandSeries commands = read_command_file(asked.test, space.actuators);
  check_limits(space, commands, asked.test);
  test.duration = asked_duration(asked).value_or(commands.series.times(commands.series.times.size() - 1));
  if (test.duration < space.control_period)
    throw_problem({asked.test}, fmt::format("a test of {:.4g} s is shorter than a control period, {:.4g} s",
                                            test.duration, space.control_period));
  test.drive = std::move(commands);
  return test;
}

Test test_of_line(const AskedTest& asked, TestSpace space, const PluginCatalog& catalog) {
  TestLine line = parse_test_line(space, asked.test);
  space.duration = asked_duration(asked).value_or(line.duration);
  if (space.duration != line.duration) line = parse_test_line(space, test_line(space, line.genome));
  const TestEncoding& encoding = catalog.get<TestEncoding>("command_series");
  std::vector<double> parameters;
  for (const ParameterDeclaration& declaration : encoding.parameters()) parameters.push_back(declaration.default_value);
  return guarded_call(catalog.origin<TestEncoding>("command_series"), "decode",
                      [&] { return encoding.decode(space, parameters, line.genome); });
}

}  // namespace

void add_test_options(CLI::App& command, AskedTest& asked, const std::string& description) {
  command.add_option("--test", asked.test, description)->required()->option_text("TEST");
  command.add_option("--duration", asked.duration, "Duration of the test: 8, \"8 s\" (default: that in TEST)")
      ->option_text("DURATION");
  command
      .add_option("--setup", asked.setup,
                  "Setup (condition of the rig, such as a load): the name of a recording that was made in it, or "
                  "\"none\" for the values of the model (default: the setup of the first recording)")
      ->option_text("NAME");
}

std::optional<double> asked_duration(const AskedTest& asked) {
  if (asked.duration.empty()) return std::nullopt;
  try {
    const Quantity duration = parse_quantity(asked.duration);
    const bool is_time = duration.unit == "1" || duration.parsed.same_dimension(*parse_unit("s"));
    if (is_time && std::isfinite(duration.value_in_si) && duration.value_in_si > 0.0) return duration.value_in_si;
  } catch (const Error&) {
  }
  throw_problem({}, fmt::format("--duration {}: must be a duration above 0, such as \"20 s\"", asked.duration));
}

KnownSetup asked_setup(const AskedTest& asked, const Experiment& experiment, const ModelDefinition& definition) {
  const std::vector<KnownSetup> setups = known_setups(definition, experiment.target.recording);
  if (!asked.setup) return setups.front();
  if (experiment.target.kind != "recorded")
    throw_problem({}, fmt::format("--setup {}: only recordings have setups ([[target.recording]] with set or own), and "
                                  "this target has kind = \"{}\"; leave out --setup",
                                  *asked.setup, experiment.target.kind));
  try {
    return find_setup(setups, *asked.setup);
  } catch (const BadInput& error) {
    throw_problem({}, fmt::format("--setup {}: {}", *asked.setup, error.what()));
  }
}

Test read_test(const AskedTest& asked, const TestSpace& space, const PluginCatalog& catalog) {
  return is_file(asked.test) ? test_of_file(asked, space) : test_of_line(asked, space, catalog);
}

}  // namespace lacuna
