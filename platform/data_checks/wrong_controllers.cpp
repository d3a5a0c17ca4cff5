#include "data_checks/wrong_controllers.h"

#include "measurement/trials/recorded_controller.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kOtherCommands = 0.1;  // of the commands' standard deviation, RMS

/// RMS difference between computed and recorded commands, over the standard deviation of the recorded ones.
double disagreement(const RecordedController& controller, std::size_t law) {
  const Eigen::ArrayXd made = controller.of_recorded_readings(law).array();
  const Eigen::ArrayXd sent = controller.commands().series.samples.col(controller.laws()[law].command_column).array();
  const auto known = made.isFinite();
  const auto count = std::max(1.0, static_cast<double>(known.count()));
  const double off = std::sqrt(known.select(made - sent, 0.0).square().sum() / count);
  return off / std::max(std::sqrt((sent - sent.mean()).square().mean()), 1e-300);
}

}  // namespace

std::vector<WrongController> wrong_controllers(const std::vector<Trial>& trials) {
  std::vector<WrongController> wrong;
  for (const Trial& trial : trials) {
    const auto* controller = dynamic_cast<const RecordedController*>(trial.controller.get());
    if (trial.held_out || controller == nullptr) continue;
    for (std::size_t law = 0; law < controller->laws().size(); ++law) {
      const double off = disagreement(*controller, law);
      const auto column = static_cast<std::size_t>(controller->laws()[law].command_column);
      if (off > kOtherCommands) wrong.push_back({trial.name, controller->commands().series.channels[column].name, off});
    }
  }
  return wrong;
}

}  // namespace lacuna
