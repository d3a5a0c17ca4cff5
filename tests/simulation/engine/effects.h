#pragma once

#include "simulation/model_structure.h"

#include <lacuna/error.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace lacuna::testing {

/// Places an effect; it must outlive the structure.
inline PlacedEffect place(const std::string& id, const PhysicalEffect& effect, ElementKind kind,
                          std::vector<int> elements, std::vector<double> values = {}) {
  return {.id = id,
          .name = id,
          .effect = &effect,
          .kind = kind,
          .elements = std::move(elements),
          .values = std::move(values),
          .file = {}};
}

inline ParameterDeclaration parameter(const std::string& name, double lower, double upper) {
  return {.name = name,
          .unit = "1",
          .default_value = lower,
          .lower = lower,
          .upper = upper,
          .scale = Scale::linear,
          .description = name};
}

/// A joint law with memory: friction that grows with the distance travelled, a filtered spring,
/// a side wind on all bodies.
class WearingFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override {
    EffectDescription description;
    description.parameters = {parameter("limit", 0.0, 10.0)};
    return description;
  }
  int state_size(const EffectContext&) const override { return 2; }
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override {
    state[1] = view.positions[coordinate(view, context)];
  }
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override {
    JointLoad& load = loads.joints[coordinate(view, context)];
    load.add_friction(context.parameters[0] * (1.0 + state[0]));
    load.add_spring(0.5, view.positions[coordinate(view, context)] - state[1]);
    for (BodyLoad& body : loads.bodies) body.force.y() += 0.01 * std::sin(5.0 * view.time);
    loads.contact.friction *= 1.0 + 0.1 * std::sin(3.0 * view.time);
    loads.contact.slope += 0.01 * std::sin(3.0 * view.time);
  }
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override {
    const std::size_t i = coordinate(view, context);
    state[0] += std::abs(view.velocities[i]) * context.step;
    state[1] += 0.01 * (view.positions[i] - state[1]);
  }

 private:
  static std::size_t coordinate(const StepView& view, const EffectContext& context) {
    return static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(context.elements[0])]);
  }
};

/// A first-order lag of commands or readings; one state an element.
class Lag : public PhysicalEffect {
 public:
  explicit Lag(bool of_command) : of_command_(of_command) {}
  EffectDescription describe() const override {
    EffectDescription description;
    description.parameters = {parameter("share", 0.0, 1.0)};
    return description;
  }
  EffectStages stages() const override {
    if (of_command_) return {.command = CommandStage::lag};
    return {.sensor = SensorStage::lag};
  }
  int state_size(const EffectContext& context) const override { return static_cast<int>(context.elements.size()); }
  double command(double value, int which, const StepView&, const EffectContext& context,
                 std::span<double> state) const override {
    double& lagged = state[static_cast<std::size_t>(which)];
    return lagged += context.parameters[0] * (value - lagged);
  }
  void sense(std::span<double> channels, int which, const StepView&, const EffectContext& context,
             std::span<double> state) const override {
    double& lagged = state[static_cast<std::size_t>(which)];
    lagged += context.parameters[0] * (channels[0] - lagged);
    channels[0] = lagged;
  }

 private:
  bool of_command_;
};

/// Multiplies by or adds its parameter to a command, to show the order of stages.
class CommandArithmetic : public PhysicalEffect {
 public:
  CommandArithmetic(CommandStage stage, bool multiply) : stage_(stage), multiply_(multiply) {}
  EffectDescription describe() const override {
    EffectDescription description;
    description.parameters = {parameter("operand", -100.0, 100.0)};
    return description;
  }
  EffectStages stages() const override { return {.command = stage_}; }
  double command(double value, int, const StepView&, const EffectContext& context, std::span<double>) const override {
    return multiply_ ? value * context.parameters[0] : value + context.parameters[0];
  }

 private:
  CommandStage stage_;
  bool multiply_;
};

/// More mass on the first body of its placement.
class ExtraMass : public PhysicalEffect {
 public:
  EffectDescription describe() const override {
    EffectDescription description;
    description.parameters = {parameter("mass", -10.0, 10.0)};
    return description;
  }
  void amend(RobotSpec& robot, const EffectContext& context) const override {
    robot.bodies[static_cast<std::size_t>(context.elements[0])].mass += context.parameters[0];
  }
};

/// Misbehaves from a moment on.
class Misbehaviour : public PhysicalEffect {
 public:
  enum class Kind { throws_error, throws_foreign, writes_nan, pushes_hard, twists_hard, negative_damping };
  explicit Misbehaviour(Kind kind, double from = 0.05) : kind_(kind), from_(from) {}
  EffectDescription describe() const override { return {}; }
  void add_loads(const StepView& view, const EffectContext&, std::span<const double>, StepLoads& loads) const override {
    if (view.time < from_) return;
    switch (kind_) {
      case Kind::throws_error: throw Error("the table has no entry here");
      case Kind::throws_foreign: throw 42;
      case Kind::writes_nan: loads.joints[0].force = std::numeric_limits<double>::quiet_NaN(); break;
      case Kind::pushes_hard: loads.joints[0].force = 1e300; break;
      case Kind::twists_hard: loads.bodies[0].torque = {1e308, 1e308, 1e308}; break;
      case Kind::negative_damping: loads.joints[0].damping = -1.0; break;
    }
  }

 private:
  Kind kind_;
  double from_;
};

}  // namespace lacuna::testing
