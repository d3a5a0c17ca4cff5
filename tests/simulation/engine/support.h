#pragma once

#include "simulation/compiled_model.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna::testing {

/// A rod of mass 1 kg and length 1 m that hangs from a hinge "hinge" about y at the world's
/// origin, with a torque actuator "motor" and sensors "angle", "rate" and "torque".
RobotSpec pendulum();
/// A cart of 2 kg on a slider "rail" along x, with a force actuator "motor" and sensors "place", "speed", "force".
RobotSpec cart();

/// Every feature that has memory at once: a box that slides on soft ground and carries an arm on a
/// delayed position servo, a PID slider, a wheel on a compliant transmission with a gap, a universal
/// and a ball joint, stops, dry friction, springs, armature, and all sensors, delayed or not.
RobotSpec everything();
/// The same in the air, where it touches nothing.
RobotSpec everything_in_the_air();

/// The engines, and what each is to be tested on.
inline const std::vector<std::string>& engines() {
  static const std::vector<std::string> names = {"articulated", "ode"};
  return names;
}
RobotSpec everything_for(const std::string& engine);

SensorSpec sensor(const std::string& name, SensorKind kind, const std::string& element);
EngineSettings step_of(double seconds);
/// A series with one sample a time.
Test series(const std::string& channel, std::vector<double> times, std::vector<double> values,
            Hold hold = Hold::zero_order);
Test constant(const std::string& channel, double value);
/// All of `everything`'s actuators moving.
Test shake();
std::vector<double> grid(double begin, double end, double step);

/// A compiled model with a workspace and a result, ready to run.
class Rig {
 public:
  explicit Rig(const ModelStructure& structure, const EngineSettings& settings = {});
  explicit Rig(RobotSpec robot, const EngineSettings& settings = {});

  /// Runs to the last of `times` with the options set before.
  const SimulationResult& run(const Test& test, const std::vector<double>& times,
                              const std::vector<double>& parameters = {});

  std::unique_ptr<CompiledModel> model;
  std::unique_ptr<Workspace> workspace;
  SimulationOptions options;
  SimulationResult result;
};

}  // namespace lacuna::testing
