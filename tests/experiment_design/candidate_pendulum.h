#pragma once

#include "config/experiment_reader.h"
#include "evaluation/prediction/test_space.h"
#include "experiment_design/next_test.h"
#include "plugins/built_catalog.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr double kReadingNoise = 1e-3;  ///< rad, of a reading
inline constexpr double kTorqueLimit = 0.6;    ///< N·m, of the amplifier

/// The servo pendulum with an amplifier of little torque, and an effect.
struct Pendulum {
  explicit Pendulum(const std::string& effects) {
    const std::string text = fmt::format(R"([experiment]
name = "candidates"
[target]
kind = "recorded"
files = ["data/servo_pendulum/sine.csv"]
time = {{ column = "t_s" }}
sensors = {{ angle = {{ column = "angle_deg", unit = "deg" }} }}
commands = {{ motor = {{ column = "torque_Nm", unit = "N*m" }} }}
[model]
file = "robots/servo-pendulum.toml"
set = {{ "actuator.motor.force_limit" = {} }}
free = {{ "body.arm.mass" = [0.3, 1.0], "joint.hinge.damping" = [0.0, 0.2] }}
effects = [{}]
[engine]
step = "5 ms"
)",
                                         kTorqueLimit, effects);
    experiment = read_experiment_text(text, std::string(LACUNA_SOURCE_DIRECTORY) + "/experiments/candidates.toml");
    definition = define_model(experiment, built_catalog());
    model = compile(definition.structure, definition.engine);
    values = definition.start_values();
  }
  /// Deviations of the values; 0: held.
  TestCandidate candidate(const std::string& name, const std::vector<double>& deviations) const {
    const Eigen::Map<const Eigen::VectorXd> all(deviations.data(), static_cast<Eigen::Index>(deviations.size()));
    return {name, definition, *model, values, all.cwiseAbs2().asDiagonal()};
  }
  Experiment experiment;
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<double> values;
};

/// The pendulum recorded with a light weight and a heavy one, and one that nobody weighed.
struct PendulumWithLoads {
  explicit PendulumWithLoads(double heavy) {
    const std::string text = fmt::format(R"([experiment]
name = "loads"
[target]
kind = "recorded"
time = {{ column = "t_s" }}
sensors = {{ angle = {{ column = "angle_deg", unit = "deg" }} }}
commands = {{ motor = {{ column = "torque_Nm", unit = "N*m" }} }}
[[target.recording]]
file = "data/servo_pendulum/sine.csv"
set = {{ "body.arm.mass" = "0.4 kg" }}
[[target.recording]]
file = "data/servo_pendulum/steps.csv"
own = ["body.arm.mass"]
[model]
file = "robots/servo-pendulum.toml"
set = {{ "actuator.motor.force_limit" = {} }}
free = {{ "body.arm.mass" = [0.3, 1.0], "joint.hinge.damping" = [0.0, 0.2] }}
[engine]
step = "5 ms"
)",
                                         kTorqueLimit);
    experiment = read_experiment_text(text, std::string(LACUNA_SOURCE_DIRECTORY) + "/experiments/loads.toml");
    definition = define_model(experiment, built_catalog());
    model = compile(definition.structure, definition.engine);
    values = definition.start_values();
    values.back() = heavy;
    setups = known_setups(definition, experiment.target.recording);
  }
  TestCandidate candidate(const std::string& name) const {
    const auto size = static_cast<Eigen::Index>(values.size());
    return {name, definition, *model, values, Eigen::MatrixXd::Identity(size, size) * 1e-18};
  }
  NextTestTask against(const PendulumWithLoads& other) const {
    return {.catalog = built_catalog(),
            .candidates = {candidate("one"), other.candidate("other")},
            .noise = {{"angle", "rad", kReadingNoise, "declared"}},
            .space = test_space(definition.structure.robot, definition.engine, 4.0),
            .start = {},
            .start_deviation = {},
            .setups = setups,
            .evaluations = 20};
  }
  Experiment experiment;
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<double> values;
  std::vector<KnownSetup> setups;
};

}  // namespace lacuna
