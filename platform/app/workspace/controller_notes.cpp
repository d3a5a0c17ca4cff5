#include "app/workspace/controller_notes.h"

#include "data_checks/wrong_controllers.h"

#include <fmt/format.h>

namespace lacuna {

std::vector<ReadingNote> controller_notes(const Experiment& experiment, const std::vector<Trial>& trials) {
  const std::vector<WrongController> wrong = wrong_controllers(trials);
  std::vector<ReadingNote> notes;
  for (const ControllerMapping& law : experiment.target.recording.controllers) {
    std::string off;
    for (const WrongController& one : wrong)
      if (one.actuator == law.actuator)
        off += fmt::format("{}{:.0f} % in {}", off.empty() ? "" : ", ", 100.0 * one.off, one.trial);
    if (off.empty()) continue;
    notes.push_back({law.location,
                     fmt::format("the controller of {} does not reproduce the recorded commands from the recorded "
                                 "readings: the RMS difference, over the standard deviation of the commands, is {}. "
                                 "Check its gains, their signs and the reference",
                                 law.actuator, off),
                     true});
  }
  return notes;
}

}  // namespace lacuna
