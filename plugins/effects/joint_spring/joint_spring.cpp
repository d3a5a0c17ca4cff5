#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A linear spring in a joint: tau = −k·(q − rest).
class JointSpring : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
};

namespace {

enum Parameter : std::size_t { kStiffness, kRest };

}  // namespace

EffectDescription JointSpring::describe() const {
  return {
      .summary = "A linear spring in a joint",
      .equation = "tau = -stiffness*(q - rest)",
      .literature = "R. Hooke, De potentia restitutiva, 1678",
      .regime = "large distances from the rest position; slow motion without another restoring force",
      .look_alikes = {"cubic_stiffness", "cable_pull", "hard_stop"},
      .placements = {ElementKind::joint},
      .parameters = {{"stiffness", "{force}/{position}", 0.0, 0.0, 1e6, Scale::linear,
                      "Torque per angle, on a slider force per distance"},
                     {"rest", "{position}", 0.0, -1000.0, 1000.0, Scale::linear, "Position without spring torque"}}};
}

void JointSpring::amend(RobotSpec& robot, const EffectContext& context) const {
  const double stiffness = context.parameters[kStiffness];
  for (const int joint : context.elements) {
    JointSpec& spec = joint_with_laws(robot, joint);
    if (stiffness == 0.0) continue;
    const double total = spec.stiffness + stiffness;
    spec.rest = (spec.stiffness * spec.rest + stiffness * context.parameters[kRest]) / total;
    spec.stiffness = total;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::JointSpring>("joint_spring"))
