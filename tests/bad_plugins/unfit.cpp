#include "bad_effect.h"

/// Effects that say of themselves what cannot be, and one that is sound.
namespace {

class WithoutStage : public bad::Effect {
 public:
  double command(double value, int, const lacuna::StepView&, const lacuna::EffectContext&,
                 std::span<double>) const override {
    return 2.0 * value;
  }
};

class WithoutPlacement : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override { return {}; }
};

template <const char* unit, int lower, int upper>
class Declared : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description = bad::Effect::describe();
    description.placements = {lacuna::ElementKind::joint};
    description.parameters = {{"size", unit, 0.0, lower, upper, lacuna::Scale::linear, "Of the push"}};
    return description;
  }
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext& context, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    loads.joints[0].force += context.parameters[0];
  }
};

constexpr char kForce[] = "{force}", kUnknown[] = "{foo}";

/// The same as a metric.
class Metric : public lacuna::FitnessMetric {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  lacuna::ParameterDeclarations parameters() const override { return {{"share", "N*x", 0.0, 0.0, 1.0, {}, ""}}; }
  std::unique_ptr<lacuna::ScoreAccumulator> accumulator(const lacuna::ComparisonShape&,
                                                        std::span<const double>) const override {
    return nullptr;
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, WithoutStage>("without_stage"),
              lacuna::component<lacuna::PhysicalEffect, WithoutPlacement>("without_placement"),
              lacuna::component<lacuna::PhysicalEffect, Declared<kUnknown, 0, 1>>("unknown_unit"),
              lacuna::component<lacuna::PhysicalEffect, Declared<kForce, 1, 0>>("bounds_reversed"),
              lacuna::component<lacuna::PhysicalEffect, Declared<kForce, -1, 1>>("undeclared_hook"),
              lacuna::component<lacuna::FitnessMetric, Metric>("unknown_metric_unit"))
