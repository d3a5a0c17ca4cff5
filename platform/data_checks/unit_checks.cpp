#include "data_checks/unit_checks.h"

#include "data_checks/stacked_accelerations.h"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <string_view>

namespace lacuna {
namespace {

constexpr double kPoor = 0.2;       // unexplained share of the squares, above which a model explains too little
constexpr double kBetter = 0.1;     // of that share, with the right unit
constexpr double kStandsOut = 3.0;  // noises, RMS
constexpr double kDegree = 180.0 / std::numbers::pi;

struct UnitGuess {
  double factor;  ///< factor by which the readings are too large
  bool angle;     ///< for angles alone
  std::string_view as_where;
};
constexpr std::array kCandidates = {UnitGuess{kDegree, true, "degrees were read as radians (57.3)"},
                                    UnitGuess{1.0 / kDegree, true, "an angle in radians were read as degrees (1/57.3)"},
                                    UnitGuess{1000.0, false, "thousandths (mrad, mm) were read as whole units"},
                                    UnitGuess{0.001, false, "whole units (rad, m) were read as thousandths"}};

/// Trials and noise with all joint readings of one unit divided by `factor`.
std::vector<Trial> divided(std::vector<Trial> trials, const std::string& unit, double factor) {
  for (Trial& trial : trials)
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c)
      if (trial.measured.channels[c].unit.starts_with(unit))
        trial.measured.samples.col(static_cast<Eigen::Index>(c)) /= factor;
  return trials;
}

/// Whether the unexplained part is more than noise.
bool clear(const AccelerationTable& table) { return clearness(table) > kStandsOut; }

}  // namespace

std::optional<DataWarning> unit_doubt(const DataCheckTask& task, const AccelerationTable& table,
                                      const std::vector<ChannelNoise>& noise) {
  if (table.empty()) return std::nullopt;
  const double before = unexplained_share(table);
  if (before < kPoor || !clear(table)) return std::nullopt;
  for (const std::string unit : {"rad", "m"}) {
    for (const UnitGuess& candidate : kCandidates) {
      if (candidate.angle && unit != "rad") continue;
      const std::vector<Trial> trials = divided(task.trials, unit, candidate.factor);
      std::vector<ChannelNoise> scaled = noise;
      for (ChannelNoise& one : scaled)
        if (one.unit.starts_with(unit)) one.deviation /= candidate.factor;
      const AccelerationTable other = acceleration_table({task.definition, task.model, trials, task.values}, scaled);
      const double after = unexplained_share(other);
      if (other.empty() || after > kBetter * before) continue;
      return DataWarning{
          Severity::fault,
          fmt::format(
              "{}: the readings in {} are {:.3g} times too large, as if {}: the model leaves {:.0f} % of the squared "
              "acceleration unexplained, and {:.2g} % with the other unit; check the unit of the column",
              other.channels.front().channel, unit, candidate.factor, candidate.as_where, 100.0 * before,
              100.0 * after)};
    }
  }
  return std::nullopt;
}

}  // namespace lacuna
