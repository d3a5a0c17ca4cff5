#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>
#include <lacuna/relaxation.h>

namespace lacuna {

/// An elastic mount that moves under the reaction of a joint's actuators.
class BaseCompliance : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kRatio, kFrequency, kDampingRatio };

double actuator_force(const StepView& view, std::size_t coordinate) {
  double force = 0.0;
  for (std::size_t a = 0; a < view.actuator_forces.size(); ++a)
    if (view.actuator_coordinate[a] == static_cast<int>(coordinate)) force += view.actuator_forces[a];
  return force;
}

/// A step of the base under a force of the joint's actuators: its acceleration, with its position taken at a share of
/// the step.
struct BaseStep {
  BaseStep(const EffectContext& context, double w, double velocity, double force) {
    const auto p = context.parameters;
    const double square = p[kFrequency] * p[kFrequency], damping = 2.0 * p[kDampingRatio] * p[kFrequency];
    share = share_of_step(p[kFrequency] * context.step) * context.step;
    acceleration =
        (-force - square * (w + share * velocity) - damping * velocity) / (1.0 + share * (damping + share * square));
  }
  double share = 0.0;  ///< s
  double acceleration = 0.0;
};

}  // namespace

EffectDescription BaseCompliance::describe() const {
  return {.summary = "An elastic mount that moves and oscillates under the reaction of a joint's actuators",
          .equation = "dw2/dt2 = -frequency^2*w - 2*damping_ratio*frequency*dw/dt - tau_actuator, tau = -ratio*d2w/dt2",
          .literature = "W. J. Book, S. H. Lee, American Control Conference 1989, 1377-1380",
          .regime = "quick changes of the command, after which the joint oscillates",
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

void BaseCompliance::add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                               StepLoads& loads) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    const BaseStep step(context, state[2 * i], state[2 * i + 1], actuator_force(view, coordinate));
    loads.joints[coordinate].force -= context.parameters[kRatio] * step.acceleration;
  }
}

void BaseCompliance::advance(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const double force = actuator_force(view, coordinate_of(view, context.elements[i]));
    const BaseStep step(context, state[2 * i], state[2 * i + 1], force);
    state[2 * i] += context.step * (state[2 * i + 1] + step.share * step.acceleration);
    state[2 * i + 1] += context.step * step.acceleration;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::BaseCompliance>("base_compliance"))
