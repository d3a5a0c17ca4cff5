#include "data_checks/channel_scatter.h"
#include "data_checks/command_checks.h"
#include "data_checks/straight_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace lacuna {
namespace {

constexpr double kPartOfNoise = 0.5;  // of the noise that the readings hold
constexpr double kExact = 1e-5;       // of the command's own deviation
constexpr double kNearly = 0.02;      // of the same
constexpr double kFeedback = 0.2;     // of the scatter of a command: share that comes from the readings' noise
constexpr double kWhite = -0.7;       // correlation of neighbouring fourth differences; white noise has −4/5
constexpr Eigen::Index kLate = 3;     // samples of delay in a controller
constexpr Eigen::Index kApart = 5;    // samples apart: such fourth differences have no sample in common
constexpr Eigen::Index kFewest = 50;
constexpr Eigen::Index kFewestToShare = 200;  // with fewer, chance alone makes such a share

/// Samples of the trial at which everything was measured, and the commands of the same times.
struct Together {
  Eigen::MatrixXd readings;  ///< rows without a gap
  Eigen::MatrixXd commands;
};

Together together(const Trial& trial) {
  const TimeSeries &measured = trial.measured, &commands = trial.commands.series;
  if (measured.times.size() != commands.times.size() || measured.times.size() < kFewest ||
      !measured.times.isApprox(commands.times) || !measured.samples.allFinite())
    return {};
  return {measured.samples, commands.samples};
}

Eigen::VectorXd second_differences(const Eigen::VectorXd& values) {
  const Eigen::Index n = values.size() - 2;
  return values.tail(n) - 2.0 * values.segment(1, n) + values.head(n);
}

/// Fourth differences remove smooth parts, of the command and of the motion that follows it, but keep noise.
Eigen::VectorXd roughness(const Eigen::VectorXd& values) {
  return second_differences(second_differences(second_differences(values)));
}

double spread(const Eigen::VectorXd& values) { return std::sqrt((values.array() - values.mean()).square().mean()); }

/// Whether the command is a reading of the same moment: they differ by less than the reading's noise, which a command
/// sent to the motor could not contain; or by little with the sign of one reading, where a controller would have the
/// opposite sign.
bool is_reading(const Trial& trial, const Together& data, Eigen::Index u, double& left) {
  const Eigen::VectorXd command = data.commands.col(u);
  Eigen::MatrixXd columns(data.readings.rows(), data.readings.cols() + 1);
  columns << data.readings, Eigen::VectorXd::Ones(data.readings.rows());
  const double size = spread(command);
  const StraightFit fit = straight_fit(columns / size, command / size);
  left = std::sqrt(fit.squares / static_cast<double>(command.size()));
  double noise = 0.0;
  for (Eigen::Index c = 0; c < data.readings.cols(); ++c)
    noise = std::hypot(noise, fit.coefficients(c) * scatter_of(trial.measured, c) / size);
  return left < std::max(kPartOfNoise * noise, kExact) ||
         (left < kNearly && data.readings.cols() == 1 && fit.coefficients(0) > 0.0);
}

/// The share of `wanted`, from its row `first` on, that a few neighbouring samples of a reading explain.
double share_of(const Eigen::VectorXd& wanted, const Eigen::VectorXd& reading, Eigen::Index first) {
  Eigen::MatrixXd columns(wanted.size(), kLate + 1);
  for (Eigen::Index late = 0; late <= kLate; ++late) columns.col(late) = reading.segment(first + late, wanted.size());
  const double size = wanted.norm();
  return size > 0.0 ? 1.0 - straight_fit(columns / size, wanted / size).squares : 0.0;
}

/// The share of a command's scatter that the noise in the same or the last few samples of a reading explains: beyond
/// the share that older and later samples explain, which have other noise but contain the same motion. 0 where the
/// reading is so smooth that its scatter is motion.
double shared_scatter(const Together& data, Eigen::Index u, Eigen::Index c) {
  if (data.readings.rows() < kFewestToShare) return 0.0;
  const Eigen::VectorXd reading = roughness(data.readings.col(c)), command = roughness(data.commands.col(u));
  const Eigen::Index last = reading.size() - 1;
  const double power = reading.squaredNorm();
  if (!(power > 0.0) || reading.head(last).dot(reading.tail(last)) > kWhite * power) return 0.0;
  constexpr Eigen::Index kOlder = 0, kSame = kLate + kApart, kLater = 2 * kSame;
  const Eigen::VectorXd wanted = command.segment(kSame + kLate, command.size() - kLater - kLate);
  const double by_motion = std::max(share_of(wanted, reading, kOlder), share_of(wanted, reading, kLater));
  return share_of(wanted, reading, kSame) - by_motion;
}

/// Joins equal findings of several files into one sentence.
struct Alike {
  std::vector<std::string> files;
  double most = 0.0;
};
using ByName = std::map<std::pair<std::string, std::string>, Alike>;

void count_in(ByName& all, const std::string& command, const std::string& reading, const Trial& trial, double size) {
  Alike& one = all[{command, reading}];
  one.files.push_back(trial.name);
  one.most = std::max(one.most, size);
}

void look_at(const Trial& trial, ByName& readings, ByName& feedback) {
  const Together data = together(trial);
  for (Eigen::Index u = 0; u < data.commands.cols(); ++u) {
    const std::string& command = trial.commands.series.channels[static_cast<std::size_t>(u)].name;
    if (!(spread(data.commands.col(u)) > 0.0)) continue;
    double left = 0.0;
    if (is_reading(trial, data, u, left)) {
      count_in(readings, command, "", trial, left);
      continue;
    }
    for (Eigen::Index c = 0; c < data.readings.cols(); ++c)
      if (const double share = shared_scatter(data, u, c); share >= kFeedback)
        count_in(feedback, command, trial.measured.channels[static_cast<std::size_t>(c)].name, trial, share);
  }
}

}  // namespace

std::vector<DataWarning> feedback_checks(const DataCheckTask& task) {
  ByName readings, feedback;
  for (const Trial& trial : task.trials)
    if (!trial.held_out) look_at(trial, readings, feedback);
  std::vector<DataWarning> doubts;
  for (const auto& [names, one] : readings)
    doubts.push_back(
        {Severity::fault, fmt::format("{}: the command {} equals the sensor readings of the same moment, including "
                                      "their noise (all but {:.1g} % of it), so it is a measurement or computed from "
                                      "one; name the column of the commands sent to the actuator",
                                      fmt::join(one.files, ", "), names.first, 100.0 * one.most)});
  for (const auto& [names, one] : feedback)
    doubts.push_back(
        {Severity::note,
         fmt::format(
             "{}: up to {:.0f} % of the scatter of the command {} is the noise of {}, as if a controller with "
             "feedback made the command; this noise biases the identified parameters. Declare the controller in "
             "[target.controllers]",
             fmt::join(one.files, ", "), 100.0 * one.most, names.first, names.second)});
  return doubts;
}

}  // namespace lacuna
