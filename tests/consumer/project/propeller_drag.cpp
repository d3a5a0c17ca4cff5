#include <lacuna/force_law.h>
#include <lacuna/plugin.h>

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
    using lacuna::Dual;
    const double drag = context.parameters[0];
    for (const int joint : context.elements) {
      const auto i = static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(joint)]);
      lacuna::add_force_law(loads.joints[i], view.positions[i], view.velocities[i],
                            [&](const Dual&, const Dual& v) { return -drag * v * abs(v); });
    }
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, PropellerDrag>("propeller_drag"))
