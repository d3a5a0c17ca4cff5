#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// Dry friction that varies periodically with the position, such as from a bent shaft or an eccentric gear.
class PositionFriction : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kMean, kSine, kCosine, kPeriods };

}  // namespace

EffectDescription PositionFriction::describe() const {
  return {.summary = "Dry friction in a joint that varies periodically with its position",
          .equation = "tau = -max(0, mean + sine*sin(periods*q) + cosine*cos(periods*q))*sgn(v)",
          .literature = "B. Armstrong-Hélouvry, Control of Machines with Friction, Kluwer 1991, chapter 4",
          .regime = "slow motion over a wide range of positions",
          .look_alikes = {"coulomb_friction", "cogging"},
          .placements = {ElementKind::joint},
          .parameters = {{"mean", "{force}", 0.0, 0.0, 10000.0, Scale::linear, "Mean friction"},
                         {"sine", "{force}", 0.0, -10000.0, 10000.0, Scale::linear, "Amplitude of the sine"},
                         {"cosine", "{force}", 0.0, -10000.0, 10000.0, Scale::linear, "Amplitude of the cosine"},
                         {"periods", "1/{position}", 1.0, 0.001, 100000.0, Scale::logarithmic,
                          "Periods per 2 pi of the coordinate: 1 is once per turn"}},
          .dissipative = true};
}

void PositionFriction::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void PositionFriction::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                                 StepLoads& loads) const {
  const auto p = context.parameters;
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double phase = p[kPeriods] * view.positions[coordinate];
    const double limit = p[kMean] + p[kSine] * std::sin(phase) + p[kCosine] * std::cos(phase);
    loads.joints[coordinate].add_friction(std::max(0.0, limit));
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::PositionFriction>("position_friction"))
