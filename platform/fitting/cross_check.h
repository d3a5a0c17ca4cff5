#pragma once

#include <string>
#include <vector>

namespace lacuna {

struct Comparison;
struct ComparisonTask;

/// How far two engines are apart in a channel, over the scored time of the trials.
struct EngineDistance {
  std::string channel;
  std::string unit;
  double apart = 0.0;  ///< RMS between their predictions, channel unit
  double error = 0.0;  ///< RMS of the model's residual, channel unit
};

struct CrossCheck {
  std::string engine;                    ///< the other one
  int substeps = 0;                      ///< of it, the finer solution's
  std::vector<EngineDistance> channels;  ///< in the order of the comparison
  std::vector<std::string> left_out;     ///< trials that the other engine cannot simulate, with the reason
};

/// Predicts the trials of a comparison once more with the other engine, from the same starts, in steps so short that
/// its own error does not count: of two solutions, the limit that its order promises is taken. `task` is what was
/// compared. Throws `Error` where there is no other engine that can move the robot, and `Interrupted`.
CrossCheck cross_check(const ComparisonTask& task, const Comparison& comparison);

}  // namespace lacuna
