#include "fitting/stage_drift.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kShare = 0.2;
constexpr double kIntervals = 2.0;
constexpr double kNear = 1e-6;  ///< of a range

bool moved(double before, double after) {
  return std::abs(after - before) > kShare * std::max(std::abs(before), std::abs(after));
}

bool drifts(double before, const FittedValue& value) {
  const double half = 0.5 * (value.upper_95 - value.lower_95);  // NaN at a bound
  const bool within = std::isfinite(half) && std::abs(value.value - before) <= kIntervals * half;
  return moved(before, value.value) && !within;
}

/// 0 means that the effect is absent; at any other end of its range a value is not determined.
bool is_at_end(double value, const FreeValue& free) {
  const double near = kNear * (free.upper - free.lower);
  const auto is = [&](double end) { return end != 0.0 && std::isfinite(near) && std::abs(value - end) <= near; };
  return is(free.lower) || is(free.upper);
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

std::vector<std::string> drift_sentences(const std::vector<FitStage>& stages, const std::vector<FittedValue>& values,
                                         const std::vector<FreeValue>& free) {
  std::vector<std::string> sentences;
  if (stages.size() < 2) return sentences;
  const FitStage& before = stages[stages.size() - 2];
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_at_end(before.values[i], free[i]) && drifts(before.values[i], values[i]))
      sentences.push_back(
          fmt::format("{} is {} {} but {} {}: with a complete model the value does not depend on the length",
                      values[i].address, format_quantity(before.values[i], free[i].unit), over(before),
                      format_quantity(values[i].value, free[i].unit), over(stages.back())));
  return sentences;
}

}  // namespace lacuna
