#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>
#include <lacuna/relaxation.h>

namespace lacuna {

/// The first bending mode of a link: inertia coupled to the joint by a spring.
class LinkFlexibility : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  int state_size(const EffectContext& context) const override;
  void start(const StepView& view, const EffectContext& context, std::span<double> state) const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
  void advance(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

namespace {

enum Parameter : std::size_t { kInertia, kFrequency, kDampingRatio };

/// A step of the mode beside a joint of velocity v: at the share s of the step its deflection is δ + s·h·w, with w =
/// dx/dt − v there, and pull = ω²·deflection + 2·ζ·ω·w acts on dx/dt through the whole step.
struct ModeStep {
  ModeStep(const EffectContext& context, double deflection, double velocity, double v) {
    const auto p = context.parameters;
    const double h = context.step, square = p[kFrequency] * p[kFrequency];
    const double share = share_of_step(p[kFrequency] * h) * h;
    const double c = share * square + 2.0 * p[kDampingRatio] * p[kFrequency];
    const double divisor = 1.0 + share * c;
    relative = (velocity - v - share * square * deflection) / divisor;
    pull = square * deflection + c * relative;
    slope = c / divisor;
  }
  double relative = 0.0, pull = 0.0;
  double slope = 0.0;  ///< decrease of the pull per velocity of the joint
};

}  // namespace

EffectDescription LinkFlexibility::describe() const {
  return {
      .summary = "The first bending mode of a link: an inertia that is coupled to its joint by a spring",
      .equation = "inertia*d2x/dt2 = -tau, tau = inertia*(frequency^2*(x - q) + 2*damping_ratio*frequency*(dx/dt - v))",
      .literature = "W. J. Book, Int. J. Robotics Research 3 (1984) 87-101",
      .regime = "quick changes of the torque, after which the joint oscillates",
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

void LinkFlexibility::add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                                StepLoads& loads) const {
  const double inertia = context.parameters[kInertia];
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const std::size_t coordinate = coordinate_of(view, context.elements[i]);
    const ModeStep step(context, state[2 * i], state[2 * i + 1], view.velocities[coordinate]);
    loads.joints[coordinate].force += inertia * step.pull;
    loads.joints[coordinate].damping += inertia * step.slope;
  }
}

void LinkFlexibility::advance(const StepView& view, const EffectContext& context, std::span<double> state) const {
  for (std::size_t i = 0; i < context.elements.size(); ++i) {
    const double v = view.velocities[coordinate_of(view, context.elements[i])];
    const ModeStep step(context, state[2 * i], state[2 * i + 1], v);
    state[2 * i] += context.step * step.relative;
    state[2 * i + 1] -= context.step * step.pull;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::LinkFlexibility>("link_flexibility"))
