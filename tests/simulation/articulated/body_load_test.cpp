#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

namespace lacuna::body_load_test {
namespace {

/// A constant force on a body, by an effect that stands on the joint.
class PushOfBody : public PhysicalEffect {
 public:
  EffectDescription describe() const override {
    EffectDescription description{.summary = "A push", .equation = "F = push", .placements = {ElementKind::joint}};
    description.parameters.push_back({"push", "N", 0.0, -1e3, 1e3, Scale::linear, "Force along x"});
    return description;
  }
  void add_loads(const StepView&, const EffectContext& context, std::span<const double>,
                 StepLoads& loads) const override {
    loads.bodies[0].force += Eigen::Vector3d(context.parameters[0], 0.0, 0.0);
  }
};

TEST(BodyLoad, OfAnEffectOnTheOnlyJointMovesItsBody) {
  const PushOfBody push;
  SimulationRun run(one_joint(JointKind::slider, 2.0, Eigen::Vector3d::UnitX()), 0.01);
  run.engine.engine = "articulated";
  run.place(push, ElementKind::joint, {0}, {3.0});
  EXPECT_NEAR(run.last("velocity", 1.0), 1.5, kRounding);
  EXPECT_NEAR(run.last("position", 1.0), 0.75, kRounding);
}

}  // namespace
}  // namespace lacuna::body_load_test
