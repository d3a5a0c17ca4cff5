#pragma once

#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "fitting/analytic_models.h"
#include "plugins/built_catalog.h"
#include "search/search_data.h"
#include "support/robots.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr double kArmDamping = 0.02;   ///< N·m·s/rad, of each joint
inline constexpr double kArmNoise = 2e-3;     ///< rad
inline constexpr double kArmInterval = 0.01;  ///< s, between samples
inline constexpr const char* kArmTarget = R"([experiment]
name = "arm"
[target]
kind = "recorded"
files = ["data/servo_pendulum/sine.csv"]
time = {{ column = "t_s" }}
[target.sensors]
{}[target.commands]
{}[model]
file = "robots/servo-pendulum.toml"
[engine]
step = "10 ms"
)";

/// A chain of links whose joints have viscous friction to be fitted, and no dry friction.
inline Experiment arm_experiment(std::size_t joints) {
  std::string sensors, commands;
  for (std::size_t i = 1; i <= joints; ++i) {
    sensors += fmt::format("q{} = {{ column = \"angle_deg\", unit = \"rad\" }}\n", i);
    commands += fmt::format("m{} = {{ column = \"torque_Nm\", unit = \"N*m\" }}\n", i);
  }
  Experiment experiment = read_experiment_text(fmt::format(kArmTarget, sensors, commands),
                                               std::string(LACUNA_SOURCE_DIRECTORY) + "/experiments/arm.toml");
  experiment.model.declared = driven_chain(joints);
  experiment.model.free = {{"joint.*.damping", 0.0, 1.0, kArmDamping}};
  return experiment;
}

/// A recording of it with this dry friction, N·m by joint, integrated in steps of a fraction of a millisecond.
inline Trial recorded_arm(const std::vector<double>& friction, const std::string& name, double duration,
                          std::uint64_t seed) {
  RobotSpec robot = driven_chain(friction.size());
  for (std::size_t i = 0; i < friction.size(); ++i) {
    robot.joints[i].damping = kArmDamping;
    robot.joints[i].dry_friction = friction[i];
  }
  CommandSeries commands;
  commands.series.channels = command_channels(robot);
  commands.series.times = analytic::regular_times(std::lround(duration / kArmInterval) + 1, 1.0 / kArmInterval);
  commands.series.samples.resize(commands.series.times.size(), static_cast<Eigen::Index>(friction.size()));
  for (Eigen::Index joint = 0; joint < commands.series.samples.cols(); ++joint)
    for (Eigen::Index row = 0; row < commands.series.times.size(); ++row)
      commands.series.samples(row, joint) =
          2.0 *
          multisine(commands.series.times(row) + 1.7 * static_cast<double>(joint) + 3.1 * static_cast<double>(seed));
  const std::unique_ptr<CompiledModel> model =
      compile({std::move(robot), {}, {}}, {.step = kArmInterval, .substeps = 32});
  const std::vector<double> rest(friction.size(), 0.0);
  Trial trial = analytic::record(*model, {}, commands.series.times, commands, {rest, rest}, kArmNoise, seed);
  trial.name = name;
  return trial;
}

/// Two recordings as a search sees them, without a search.
class ArmData {
 public:
  /// `friction`: N·m, by joint.
  explicit ArmData(const std::vector<double>& friction, double duration = 3.0)
      : experiment_(arm_experiment(friction.size())),
        trials_({recorded_arm(friction, "one.csv", duration, 1), recorded_arm(friction, "two.csv", duration, 2)}),
        data_({.experiment = experiment_,
               .catalog = built_catalog(),
               .trials = trials_,
               .values = define_model(experiment_, built_catalog()).start_values(),
               .among = {"coulomb_friction"}}) {}
  ArmData(const ArmData&) = delete;
  ArmData& operator=(const ArmData&) = delete;

  const SearchData& data() const { return data_; }

 private:
  const Experiment experiment_;
  const std::vector<Trial> trials_;
  const SearchData data_;
};

}  // namespace lacuna
