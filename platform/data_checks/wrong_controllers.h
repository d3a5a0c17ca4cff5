#pragma once

#include <lacuna/trial.h>

#include <string>
#include <vector>

namespace lacuna {

/// A declared controller that does not make the recorded commands of a trial of its recorded readings.
struct WrongController {
  std::string trial;
  std::string actuator;
  double off = 0.0;  ///< RMS of its commands less the recorded ones, over the standard deviation of these
};

/// Those of the fit trials, by trial: each whose commands differ by more than a tenth of the deviation of the recorded
/// ones.
std::vector<WrongController> wrong_controllers(const std::vector<Trial>& trials);

}  // namespace lacuna
