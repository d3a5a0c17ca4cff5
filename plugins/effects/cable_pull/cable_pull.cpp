#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// A constant pull on a body's centre of mass towards a fixed point.
class CablePull : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kTension, kX, kY, kZ };

}  // namespace

EffectDescription CablePull::describe() const {
  return {
      .summary = "A cable under constant tension between a body and a fixed point",
      .equation = "F = tension*(point - com)/|point - com|",
      .literature = "J. L. Meriam, L. G. Kraige, Engineering Mechanics: Statics, Wiley 2006, chapter 3",
      .regime = "a force whose direction turns as the body moves; a shifted rest position",
      .look_alikes = {"joint_offset_torque", "joint_spring", "mount_tilt"},
      .placements = {ElementKind::body},
      .parameters = {{"tension", "N", 0.0, 0.0, 100000.0, Scale::linear, "Pull of the cable"},
                     {"x", "m", 0.0, -100.0, 100.0, Scale::linear, "Point where the cable is fixed, in the world"},
                     {"y", "m", 0.0, -100.0, 100.0, Scale::linear, "Point where the cable is fixed, in the world"},
                     {"z", "m", 0.0, -100.0, 100.0, Scale::linear, "Point where the cable is fixed, in the world"}}};
}

void CablePull::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                          StepLoads& loads) const {
  const auto p = context.parameters;
  const Eigen::Vector3d point(p[kX], p[kY], p[kZ]);
  for (const int element : context.elements) {
    const auto body = static_cast<std::size_t>(element);
    const Eigen::Vector3d way = point - view.body_positions[body];
    const double length = way.norm();
    if (length > 0.0) loads.bodies[body].force += p[kTension] / length * way;
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::CablePull>("cable_pull"))
