#pragma once

#include <lacuna/trial.h>

#include <string>
#include <vector>

namespace lacuna {

/// A declared controller that does not reproduce the recorded commands of a trial from its recorded readings.
struct WrongController {
  std::string trial;
  std::string actuator;
  double off = 0.0;  ///< RMS difference from the recorded commands, over their standard deviation
};

/// Those of the fit trials, in the order of the trials: RMS difference above a tenth of the standard deviation of the
/// recorded commands.
std::vector<WrongController> wrong_controllers(const std::vector<Trial>& trials);

}  // namespace lacuna
