#pragma once

#include <string>
#include <vector>

namespace lacuna {

struct Comparison;
struct ComparisonTask;

/// Difference between two engines in a channel, over the scored time of the trials.
struct EngineDistance {
  std::string channel;
  std::string unit;
  double apart = 0.0;  ///< RMS between their predictions, channel unit
  double error = 0.0;  ///< RMS of the model's residual, channel unit
};

struct CrossCheck {
  std::string engine;                    ///< the other one
  int substeps = 0;                      ///< of the other engine, for the finer solution
  std::vector<EngineDistance> channels;  ///< in the order of the comparison
  std::vector<std::string> left_out;     ///< trials that the other engine cannot simulate, with the reason
};

/// Predicts the trials of a comparison again with the other engine, from the same starts, in steps so short that its
/// error does not matter: two solutions are extrapolated to the limit of their order. `task`: that of the comparison.
/// Throws `Error` where no other engine can simulate the robot, and `Interrupted`.
CrossCheck cross_check(const ComparisonTask& task, const Comparison& comparison);

}  // namespace lacuna
