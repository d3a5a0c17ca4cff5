#include <lacuna/plugin.h>

#include <cmath>

namespace {

/// Drag of a propeller on a joint's axis: tau = −c·v·|v|. A plugin as somebody outside of Lacuna writes it.
class PropellerDrag : public lacuna::PhysicalEffect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description;
    description.summary = "Drag of a propeller on a joint's axis";
    description.equation = "tau = -drag*v*|v|";
    description.placements = {lacuna::ElementKind::joint};
    description.parameters = {
        {"drag", "{force}*s^2/{position}^2", 0.0, 0.0, 10.0, lacuna::Scale::linear, "Torque per squared velocity"}};
    return description;
  }
  void add_loads(const lacuna::StepView& view, const lacuna::EffectContext& context, std::span<const double>,
                   lacuna::StepLoads& loads) const override {
    for (const int joint : context.elements) {
      const auto coordinate = static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(joint)]);
      loads.joints[coordinate].damping += context.parameters[0] * std::abs(view.velocities[coordinate]);
    }
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, PropellerDrag>("propeller_drag"))
