#include "app/workspace/controller_draft.h"

#include "app/workspace/draft_text.h"
#include "config/toml/toml_node.h"
#include "foundation/text/plain_text.h"
#include "foundation/unit.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace lacuna {
namespace {

constexpr double kMostLeft = 0.1;     ///< of the command's deviation, by a law that is proposed
constexpr double kAsGood = 1.2;       ///< of what the full law leaves
constexpr double kExact = 0.005;      ///< of the command's deviation: nothing is gained below it
constexpr Eigen::Index kFewest = 50;  ///< rows

/// A reference with the command that a controller made of it and the reading that it compared it with.
struct ControlledColumns {
  GuessedColumn reference;
  MatchedColumn command, reading;
};

bool same_unit(const std::string& unit, const std::string& of) {
  const std::optional<Unit> a = parse_unit(unit), b = parse_unit(of);
  return a && b && a->same_dimension(*b);
}

const MatchedColumn* matched(const std::vector<MatchedColumn>& all, const GuessedColumn& reference, bool by_unit) {
  const MatchedColumn* found = nullptr;
  for (const MatchedColumn& one : all) {
    const bool is_of_joint = all.size() == 1 || one.column.joint == reference.joint;
    const bool is_of_unit = !by_unit || reference.unit.empty() || same_unit(reference.unit, one.channel.unit);
    if (is_of_joint && is_of_unit && !found) found = &one;
  }
  return found;
}

std::vector<ControlledColumns> controlled_columns(const RigGuess& guess) {
  std::vector<ControlledColumns> all;
  for (const GuessedColumn& column : guess.unused) {
    if (column.role != ColumnRole::reference) continue;
    const MatchedColumn* command = matched(guess.commands, column, false);
    const MatchedColumn* reading = matched(guess.sensors, column, true);
    if (command && reading) all.push_back({column, *command, *reading});
  }
  return all;
}

/// Gains in SI; those that are not of the law are 0.
struct FittedLaw {
  double proportional = 0.0, integral = 0.0, derivative = 0.0;
  double left = 1.0;  ///< of the command's deviation
};

/// A column in SI; nothing where it is not there or its unit is not known.
std::optional<Eigen::VectorXd> values_of(const FileSample& sample, const GuessedColumn& column,
                                         const std::string& unit) {
  const int at = sample.find(column.name);
  if (at < 0 || !same_unit(column.unit, unit)) return std::nullopt;
  const std::vector<double>& values = sample.columns[static_cast<std::size_t>(at)];
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())) *
         parse_unit(column.unit)->to_si;
}

/// Columns P, I, D and a constant, and the command; rows where all are known.
struct Regression {
  Eigen::MatrixXd columns;
  Eigen::VectorXd command;
};

Regression regression_of(const Eigen::VectorXd& times, const Eigen::VectorXd& error, const Eigen::VectorXd& reading,
                         const Eigen::VectorXd& command) {
  Regression all{Eigen::MatrixXd(times.size(), 4), Eigen::VectorXd(times.size())};
  Eigen::Index rows = 0;
  double integral = 0.0;
  for (Eigen::Index i = 1; i < times.size(); ++i) {
    const double interval = times(i) - times(i - 1);
    const double rate = (reading(i) - reading(i - 1)) / interval;
    if (!std::isfinite(rate) || !std::isfinite(error(i)) || !std::isfinite(command(i))) continue;
    all.columns.row(rows) << error(i), integral, -rate, 1.0;
    all.command(rows++) = command(i);
    integral += error(i) * interval;
  }
  all.columns.conservativeResize(rows, Eigen::NoChange);
  all.command.conservativeResize(rows);
  return all;
}

FittedLaw law_with(const Regression& data, bool has_integral, bool has_derivative) {
  Eigen::MatrixXd columns = data.columns;
  if (!has_integral) columns.col(1).setZero();
  if (!has_derivative) columns.col(2).setZero();
  const Eigen::VectorXd gains = columns.completeOrthogonalDecomposition().solve(data.command);
  const double deviation = (data.command.array() - data.command.mean()).matrix().norm();
  return {gains(0), gains(1), gains(2), deviation > 0.0 ? (data.command - columns * gains).norm() / deviation : 1.0};
}

/// The shortest law that makes the commands as well as the full one.
std::optional<FittedLaw> law_of(const FileSample& sample, const GuessedColumn& time, const ControlledColumns& of) {
  const std::optional<Eigen::VectorXd> times = values_of(sample, time, "s"),
                                       reference = values_of(sample, of.reference, of.reading.channel.unit),
                                       reading = values_of(sample, of.reading.column, of.reading.channel.unit),
                                       command = values_of(sample, of.command.column, of.command.channel.unit);
  if (!times || !reference || !reading || !command) return std::nullopt;
  const Regression data = regression_of(*times, *reference - *reading, *reading, *command);
  if (data.command.size() < kFewest) return std::nullopt;
  const FittedLaw full = law_with(data, true, true);
  if (!(full.left < kMostLeft)) return std::nullopt;
  constexpr std::array<std::array<bool, 2>, 3> kShorter = {{{false, false}, {false, true}, {true, false}}};
  for (const auto& [has_integral, has_derivative] : kShorter) {
    const FittedLaw law = law_with(data, has_integral, has_derivative);
    if (law.left < std::max(kAsGood * full.left, kExact)) return law;
  }
  return full;
}

std::string gain_text(const char* key, const std::optional<FittedLaw>& law, double FittedLaw::*gain,
                      const std::string& unit) {
  if (!law) return fmt::format(", {} = {}", key, blank(unit));
  return (*law).*gain == 0.0 ? "" : fmt::format(", {} = \"{:.4g} {}\"", key, (*law).*gain, unit);
}

std::string text_of(const ControlledColumns& of, const std::optional<FittedLaw>& law) {
  const std::string force = of.command.channel.unit, way = of.reading.channel.unit;
  const std::string unit = of.reference.unit.empty() ? blank("") : toml_text(of.reference.unit);
  const std::string slope = way.ends_with("/s") ? fmt::format("{}*s/{}", force, way.substr(0, way.size() - 2))
                                                : fmt::format("{}/{}", force, way);
  const std::string integral = way.ends_with("/s") ? fmt::format("{}/{}", force, way.substr(0, way.size() - 2))
                                                   : fmt::format("{}/({}*s)", force, way);
  std::string line =
      fmt::format("# {} = {{ reads = {}, reference = {{ column = {}, unit = {} }}", toml_key(of.command.channel.name),
                  toml_text(of.reading.channel.name), toml_text(of.reference.name), unit);
  line += gain_text("proportional", law, &FittedLaw::proportional, slope);
  if (law) line += gain_text("integral", law, &FittedLaw::integral, integral);
  if (law && !way.ends_with("/s"))
    line += gain_text("derivative", law, &FittedLaw::derivative, fmt::format("{}*s/{}", force, way));
  return line + " }\n";
}

}  // namespace

bool is_drafted_set_point(const RigDraft& draft, const GuessedColumn& column) {
  return draft.first_file && std::ranges::any_of(controlled_columns(draft.guess), [&](const ControlledColumns& one) {
           return one.reference.name == column.name;
         });
}

std::string controllers_text(const RigDraft& draft) {
  const std::vector<ControlledColumns> all = controlled_columns(draft.guess);
  if (all.empty() || !draft.first_file) return "";
  std::string text =
      "\n# A set point is recorded, so a controller probably made these commands. Disturbances bias values fitted to "
      "them.\n"
      "# Check the law and remove the \"# \": diagnose then tests for this bias, and drive = \"controllers\" in "
      "[target]\n"
      "# simulates models with the controller.\n# [target.controllers]\n";
  for (const ControlledColumns& one : all) {
    const std::optional<FittedLaw> law = law_of(*draft.first_file, draft.guess.time, one);
    text += law ? fmt::format("# fitted to {}: explains all but {:.2g} % of the command's variation\n",
                              plain_text(draft.first_file->label()), 100.0 * law->left)
                : "# no proportional, integral and derivative gains explain these commands: fill in the law of the "
                  "controller\n";
    text += text_of(one, law);
  }
  return text;
}

}  // namespace lacuna
