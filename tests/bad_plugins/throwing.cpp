#include "bad_effect.h"

#include <stdexcept>

namespace rig {

/// Derived from nothing that a host knows.
struct Trouble {
  int code = 7;
};

class ThrowsInFactory : public bad::Effect {
 public:
  ThrowsInFactory() { throw std::runtime_error("no licence found"); }
};

class ThrowsForeignInFactory : public bad::Effect {
 public:
  ThrowsForeignInFactory() { throw Trouble{}; }
};

class ThrowsWhenDescribed : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override { throw Trouble{}; }
};

class ThrowsInStep : public bad::Effect {
 public:
  void add_loads(const lacuna::StepView& view, const lacuna::EffectContext&, std::span<const double>,
                 lacuna::StepLoads&) const override {
    if (view.time >= bad::kOnset) throw Trouble{};
  }
};

class ThrowsInSense : public bad::Effect {
 public:
  lacuna::EffectStages stages() const override { return {.sensor = lacuna::SensorStage::offset}; }
  void sense(std::span<double>, int, const lacuna::StepView& view, const lacuna::EffectContext&,
             std::span<double>) const override {
    if (view.time >= bad::kOnset) throw 42;
  }
};

class ThrowsWhenSized : public bad::Effect {
 public:
  int state_size(const lacuna::EffectContext&) const override { throw Trouble{}; }
};

class ThrowsInBuild : public lacuna::RobotDefinition {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  lacuna::RobotSpec build(const lacuna::RobotRequest&) const override { throw Trouble{}; }
};

}  // namespace rig

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, rig::ThrowsInFactory>("throws_in_factory"),
              lacuna::component<lacuna::PhysicalEffect, rig::ThrowsForeignInFactory>("throws_foreign_in_factory"),
              lacuna::component<lacuna::PhysicalEffect, rig::ThrowsWhenDescribed>("throws_when_described"),
              lacuna::component<lacuna::PhysicalEffect, rig::ThrowsInStep>("throws_in_step"),
              lacuna::component<lacuna::PhysicalEffect, rig::ThrowsInSense>("throws_in_sense"),
              lacuna::component<lacuna::PhysicalEffect, rig::ThrowsWhenSized>("throws_when_sized"),
              lacuna::component<lacuna::RobotDefinition, rig::ThrowsInBuild>("throws_in_build"),
              lacuna::component<lacuna::PhysicalEffect, bad::Effect>("harmless"))
