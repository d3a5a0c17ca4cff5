#include "fitting/stage_drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kShare = 0.2;
constexpr double kIntervals = 2.0;

bool moved(double before, double after) {
  return std::abs(after - before) > kShare * std::max(std::abs(before), std::abs(after));
}

bool drifts(double before, const FittedValue& value) {
  const double half = 0.5 * (value.upper_95 - value.lower_95);  // NaN at a bound
  const bool within = std::isfinite(half) && std::abs(value.value - before) <= kIntervals * half;
  return moved(before, value.value) && !within;
}

std::string over(const FitStage& stage) {
  return stage.segment > 0.0 ? fmt::format("over {:.2g} s", stage.segment) : "over whole trials";
}

}  // namespace

bool moved(const std::vector<double>& before, const std::vector<double>& after) {
  for (std::size_t i = 0; i < before.size(); ++i)
    if (moved(before[i], after[i])) return true;
  return false;
}

std::vector<std::string> drift_sentences(const std::vector<FitStage>& stages, const std::vector<FittedValue>& values) {
  std::vector<std::string> sentences;
  if (stages.size() < 2) return sentences;
  const FitStage& before = stages[stages.size() - 2];
  for (std::size_t i = 0; i < values.size(); ++i)
    if (drifts(before.values[i], values[i]))
      sentences.push_back(
          fmt::format("{} is {:.3g} {} but {:.3g} {}: a model that lacks nothing tells the same over any length",
                      values[i].address, before.values[i], over(before), values[i].value, over(stages.back())));
  return sentences;
}

}  // namespace lacuna
