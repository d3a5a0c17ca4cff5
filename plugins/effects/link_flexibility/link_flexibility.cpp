#include "link_flexibility.h"

#include <lacuna/joint_laws.h>
#include <lacuna/plugin.h>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kInertia, kFrequency, kDampingRatio };

/// Implicit Euler over a step, with w = dx/dt − v' after it: w = (u − h·ω²·δ − v')/d.
struct Mode {
  Mode(const EffectContext& context)
      : h(context.step),
        square(context.parameters[kFrequency] * context.parameters[kFrequency]),
        c(h * square + 2.0 * context.parameters[kDampingRatio] * context.parameters[kFrequency]),
        d(1.0 + h * c) {}
  double h, square, c, d;
};

}  // namespace

EffectDescription LinkFlexibility::describe() const {
  return {
      .summary = "The first bending mode of a link, an inertia that follows its joint by a spring",
      .equation = "inertia*d2x/dt2 = -tau, tau = inertia*(frequency^2*(x - q) + 2*damping_ratio*frequency*(dx/dt - v))",
      .literature = "W. J. Book, Int. J. Robotics Research 3 (1984) 87-101",
      .regime = "quick changes of the torque, after which the joint goes on shaking",
      .look_alikes = {"joint_compliance", "base_compliance"},
      .placements = {ElementKind::joint},
      .parameters = {
          {"inertia", "{inertia}", 0.0, 0.0, 10000.0, Scale::linear, "Inertia of the mode about the joint"},
          {"frequency", "1/s", 60.0, 0.1, 100000.0, Scale::logarithmic,
           "Angular frequency of the mode with the joint held"},
          {"damping_ratio", "1", 0.02, 0.0, 1.0, Scale::linear, "Damping of the mode over critical damping"}}};
}

int LinkFlexibility::state_size(const EffectContext& context) const {
  return 2 * static_cast<int>(context.elements.size());
}

/// State of each joint: deflection x − q and velocity dx/dt.
void LinkFlexibility::start(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i)
    state[2 * i + 1] = view.velocities[coordinate_of(view, context.elements[i])];
}

void LinkFlexibility::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void LinkFlexibility::before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                                  StepLoads& loads) const {
  const double inertia = context.parameters[kInertia];
  const Mode mode(context);
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const double deflection = state[2 * i], velocity = state[2 * i + 1];
    JointLoad& load = loads.joints[coordinate_of(view, context.elements[i])];
    load.force +=
        inertia * (mode.square * deflection + mode.c * (velocity - mode.h * mode.square * deflection) / mode.d);
    load.damping += inertia * mode.c / mode.d;
  }
}

void LinkFlexibility::after_step(const StepView& view, const EffectContext& context, std::span<double> state) const {
  const Mode mode(context);
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    double& deflection = state[2 * i];
    double& velocity = state[2 * i + 1];
    const double v = view.velocities[coordinate_of(view, context.elements[i])];
    const double relative = (velocity - mode.h * mode.square * deflection - v) / mode.d;
    deflection += mode.h * relative;
    velocity = v + relative;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::LinkFlexibility>("link_flexibility"))
