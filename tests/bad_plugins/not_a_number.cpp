#include "bad_effect.h"

#include <algorithm>
#include <limits>

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class Load : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description = bad::Effect::describe();
    description.placements = {lacuna::ElementKind::joint};
    return description;
  }
  void add_loads(const lacuna::StepView& view, const lacuna::EffectContext& context, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    const int coordinate = view.first_coordinate[static_cast<std::size_t>(context.elements[0])];
    if (view.time >= bad::kOnset) loads.joints[static_cast<std::size_t>(coordinate)].force = kNan;
  }
};

class Command : public bad::Effect {
 public:
  lacuna::EffectStages stages() const override { return {.command = lacuna::CommandStage::offset}; }
  double command(double value, int, const lacuna::StepView& view, const lacuna::EffectContext&,
                 std::span<double>) const override {
    return view.time >= bad::kOnset ? kNan : value;
  }
};

class Reading : public bad::Effect {
 public:
  lacuna::EffectStages stages() const override { return {.sensor = lacuna::SensorStage::offset}; }
  void sense(std::span<double> channels, int, const lacuna::StepView& view, const lacuna::EffectContext&,
             std::span<double>) const override {
    if (view.time >= bad::kOnset) std::fill(channels.begin(), channels.end(), kNan);
  }
};

class Bounds : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description = bad::Effect::describe();
    description.parameters = {{"size", "1", kNan, 0.0, 1.0, lacuna::Scale::linear, "Without a default"}};
    return description;
  }
};

class Robot : public lacuna::RobotDefinition {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  lacuna::RobotSpec build(const lacuna::RobotRequest&) const override {
    lacuna::RobotSpec robot;
    robot.bodies.resize(1);
    robot.bodies[0].name = "ghost";
    robot.bodies[0].mass = kNan;
    return robot;
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, Load>("nan_load"),
              lacuna::component<lacuna::PhysicalEffect, Command>("nan_command"),
              lacuna::component<lacuna::PhysicalEffect, Reading>("nan_reading"),
              lacuna::component<lacuna::PhysicalEffect, Bounds>("nan_default"),
              lacuna::component<lacuna::RobotDefinition, Robot>("nan_robot"))
