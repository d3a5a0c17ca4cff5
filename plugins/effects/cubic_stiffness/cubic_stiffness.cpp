#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// A spring whose torque grows with the third power of its deflection (Duffing).
class CubicStiffness : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kStiffness, kRest };

}  // namespace

EffectDescription CubicStiffness::describe() const {
  return {
      .summary = "A spring in a joint whose torque grows with the third power of its deflection",
      .equation = "tau = -stiffness*(q - rest)^3",
      .literature = "G. Duffing, Erzwungene Schwingungen bei veraenderlicher Eigenfrequenz, Vieweg 1918",
      .regime = "large excursions; a frequency that depends on the amplitude",
      .look_alikes = {"joint_spring", "hard_stop"},
      .placements = {ElementKind::joint},
      .parameters = {{"stiffness", "{force}/{position}^3", 0.0, -1e6, 1e6, Scale::linear,
                      "Torque per cubed angle, on a slider force per cubed distance"},
                     {"rest", "{position}", 0.0, -1000.0, 1000.0, Scale::linear, "Position without spring torque"}}};
}

void CubicStiffness::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

/// The tangent at the present deflection d: −k·d³ − 3·k·d²·(q' − q).
void CubicStiffness::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                               StepLoads& loads) const {
  const double stiffness = context.parameters[kStiffness], rest = context.parameters[kRest];
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double deflection = view.positions[coordinate] - rest;
    const double slope = 3.0 * stiffness * deflection * deflection;
    loads.joints[coordinate].force -= slope * deflection / 3.0;
    loads.joints[coordinate].stiffness += std::max(0.0, slope);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CubicStiffness>("cubic_stiffness"))
