#include <lacuna/plugin.h>

#include <gtest/gtest.h>

#include <memory>

/// Which hooks a class overrides follows from the class, however it comes to them.
namespace lacuna {
namespace {

class Still : public PhysicalEffect {
 public:
  EffectDescription describe() const override { return {}; }
};

class Pushing : public Still {
 public:
  void add_loads(const StepView&, const EffectContext&, std::span<const double>, StepLoads&) const override {}
};

class Heavier final : public Pushing {
 public:
  using Pushing::advance;
  void amend(RobotSpec&, const EffectContext&) const noexcept override {}
  EffectStages stages() const override { return {.sensor = SensorStage::offset}; }
  void sense(std::span<double>, int, const StepView&, const EffectContext&, std::span<double>) const override {}
};

class Hidden : public Still {
  void add_loads(const StepView&, const EffectContext&, std::span<const double>, StepLoads&) const override {}
};

static_assert(!HooksVisible<Hidden> && HooksVisible<Heavier>);  // `component` refuses the first at compile time

TEST(OverriddenHooks, NoneOfAnEffectThatOnlyDescribesItself) {
  const OverriddenHooks hooks = overridden_hooks<Still>();
  EXPECT_FALSE(hooks.amend || hooks.add_loads || hooks.advance || hooks.command || hooks.sense);
}

TEST(OverriddenHooks, ThoseOfAClassAndOfTheClassesBelowIt) {
  const OverriddenHooks hooks = overridden_hooks<Heavier>();
  EXPECT_TRUE(hooks.amend && hooks.add_loads && hooks.sense);
  EXPECT_FALSE(hooks.advance || hooks.command);
}

TEST(OverriddenHooks, AreWhatTheHostCallsOfAComponent) {
  const ComponentEntry entry = component<PhysicalEffect, Heavier>("heavier");
  const std::unique_ptr<PhysicalEffect> effect(static_cast<PhysicalEffect*>(entry.create()));
  const EffectHooks hooks = effect->hooks();
  EXPECT_TRUE(hooks.amends_robot && hooks.add_loads);
  EXPECT_FALSE(hooks.advance);
  EXPECT_EQ(hooks.command, CommandStage::none);
  EXPECT_EQ(hooks.sensor, SensorStage::offset);
}

}  // namespace
}  // namespace lacuna
