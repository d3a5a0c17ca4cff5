#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Elastic stops at both ends of a joint's range.
class HardStop : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kLower, kUpper, kStiffness, kDamping };

}  // namespace

EffectDescription HardStop::describe() const {
  return {.summary = "Elastic stops at the ends of a joint's range",
          .equation = "tau = -max(0, stiffness*(q - upper) + damping*v) for q > upper; the same below lower",
          .literature =
              "G. Gilardi, I. Sharf, Mechanism and Machine Theory 37 (2002) 1213-1239 (spring and dashpot in parallel)",
          .regime = "motion to the ends of the range",
          .look_alikes = {"cubic_stiffness", "joint_spring"},
          .placements = {ElementKind::joint},
          .parameters = {
              {"lower", "{position}", -1000.0, -1000.0, 1000.0, Scale::linear, "Position of the lower stop"},
              {"upper", "{position}", 1000.0, -1000.0, 1000.0, Scale::linear, "Position of the upper stop"},
              {"stiffness", "{force}/{position}", 1000.0, 0.001, 1e9, Scale::logarithmic, "Stiffness of the stops"},
              {"damping", "{force}*s/{position}", 0.0, 0.0, 1e6, Scale::linear, "Damping during contact with a stop"}}};
}

void HardStop::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void HardStop::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                         StepLoads& loads) const {
  const auto p = context.parameters;
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double q = view.positions[coordinate], v = view.velocities[coordinate];
    if (q >= p[kLower] && q <= p[kUpper]) continue;
    const bool above = q > p[kUpper];
    const double stop = above ? p[kUpper] : p[kLower];
    const double push = p[kStiffness] * (q - stop) + p[kDamping] * v;
    if (above ? push <= 0.0 : push >= 0.0) continue;  // a stop does not pull
    loads.joints[coordinate].add_spring(p[kStiffness], q - stop);
    loads.joints[coordinate].add_damping(p[kDamping], v);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::HardStop>("hard_stop"))
