#include "base_compliance.h"

#include <lacuna/joint_laws.h>
#include <lacuna/plugin.h>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kRatio, kFrequency, kDampingRatio };

}  // namespace

EffectDescription BaseCompliance::describe() const {
  return {.summary = "A mount that gives way to the reaction of a joint's actuators, and shakes",
          .equation = "dw2/dt2 = -frequency^2*w - 2*damping_ratio*frequency*dw/dt - tau_actuator, tau = -ratio*d2w/dt2",
          .literature = "W. J. Book, S. H. Lee, American Control Conference 1989, 1377-1380",
          .regime = "quick changes of the command, after which the joint goes on shaking",
          .look_alikes = {"link_flexibility", "joint_compliance"},
          .placements = {ElementKind::joint},
          .parameters = {
              {"ratio", "1", 0.0, 0.0, 10.0, Scale::linear, "Inertia that the joint moves over inertia of the base"},
              {"frequency", "1/s", 60.0, 0.1, 100000.0, Scale::logarithmic, "Angular frequency of the base alone"},
              {"damping_ratio", "1", 0.05, 0.0, 2.0, Scale::linear, "Damping of the base over critical damping"}}};
}

/// State of each joint: w and its velocity.
int BaseCompliance::state_size(const EffectContext& context) const {
  return 2 * static_cast<int>(context.elements.size());
}

void BaseCompliance::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

/// Implicit Euler in w, which stays stable for any frequency.
void BaseCompliance::before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                                 StepLoads& loads) const {
  const auto p = context.parameters;
  const double h = context.step, square = p[kFrequency] * p[kFrequency];
  const double damping = 2.0 * p[kDampingRatio] * p[kFrequency];
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    double reaction = 0.0;
    for (std::size_t a = 0; a < view.actuator_forces.size(); ++a)
      if (view.actuator_coordinate[a] == static_cast<int>(coordinate)) reaction -= view.actuator_forces[a];
    double& w = state[2 * i];
    double& velocity = state[2 * i + 1];
    const double acceleration =
        (reaction - square * (w + h * velocity) - damping * velocity) / (1.0 + h * (damping + h * square));
    velocity += h * acceleration;
    w += h * velocity;
    loads.joints[coordinate].force -= p[kRatio] * acceleration;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::BaseCompliance>("base_compliance"))
