#include "candidates/timing.h"

#include "evaluation/prediction/trial_predictor.h"

#include <algorithm>

namespace lacuna {

std::vector<FreeValue> with_timing(std::vector<FreeValue> free, const TimingRange& range) {
  free.push_back({{.address = "timing", .unit = "1", .lower = range.earliest, .upper = range.latest}});
  return free;
}

double longest_command_interval(const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials) longest = std::max(longest, command_interval(trial));
  return longest;
}

}  // namespace lacuna
