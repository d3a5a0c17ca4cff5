#include <lacuna/joint_laws.h>
#include <lacuna/physical_effect.h>
#include <lacuna/plugin.h>

#include <cmath>

namespace lacuna {

/// A torque that varies periodically with the position, such as from a motor's magnets or an unbalanced wheel.
class Cogging : public PhysicalEffect {
 public:
  EffectDescription describe() const override;
  void amend(RobotSpec& robot, const EffectContext& context) const override;
  void add_loads(const StepView& view, const EffectContext& context, std::span<const double> state,
                 StepLoads& loads) const override;
};

namespace {

enum Parameter : std::size_t { kSine, kCosine, kPeriods };

}  // namespace

EffectDescription Cogging::describe() const {
  return {.summary = "A torque that varies periodically with a joint's position",
          .equation = "tau = sine*sin(periods*q) + cosine*cos(periods*q)",
          .literature = "T. M. Jahns, W. L. Soong, IEEE Trans. Industrial Electronics 43 (1996) 321-330",
          .regime = "slow motion: a ripple that repeats with the position, not with time",
          .look_alikes = {"position_friction", "encoder_eccentricity"},
          .placements = {ElementKind::joint},
          .parameters = {{"sine", "{force}", 0.0, -10000.0, 10000.0, Scale::linear, "Amplitude of the sine"},
                         {"cosine", "{force}", 0.0, -10000.0, 10000.0, Scale::linear, "Amplitude of the cosine"},
                         {"periods", "1/{position}", 1.0, 0.5, 100000.0, Scale::logarithmic,
                          "Periods per 2 pi of the coordinate: 1 is once per turn"}}};
}

void Cogging::amend(RobotSpec& robot, const EffectContext& context) const {
  for (const int joint : context.elements) joint_with_one_coordinate(robot, joint);
}

void Cogging::add_loads(const StepView& view, const EffectContext& context, std::span<const double>,
                        StepLoads& loads) const {
  const auto p = context.parameters;
  for (const int joint : context.elements) {
    const std::size_t coordinate = coordinate_of(view, joint);
    const double phase = p[kPeriods] * view.positions[coordinate];
    loads.joints[coordinate].force += p[kSine] * std::sin(phase) + p[kCosine] * std::cos(phase);
  }
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, lacuna::Cogging>("cogging"))
