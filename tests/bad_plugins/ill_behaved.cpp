#include "bad_effect.h"

#include <cfenv>
#include <memory>
#include <vector>

/// Effects that describe themselves well and whose hooks do what lacuna/physical_effect.h forbids, and one that does
/// all that it allows.
namespace {

/// An effect with one parameter and two numbers of state.
class OfOneParameter : public bad::Effect {
 public:
  lacuna::EffectDescription describe() const override {
    lacuna::EffectDescription description = bad::Effect::describe();
    description.placements = {lacuna::ElementKind::joint};
    description.parameters = {{"size", "{force}", 0.0, 0.0, 10.0, lacuna::Scale::linear, "Of the push"}};
    return description;
  }
  int state_size(const lacuna::EffectContext&) const override { return 2; }
};

lacuna::JointLoad& load_of(const lacuna::EffectContext& context, lacuna::StepLoads& loads) {
  return loads.joints[static_cast<std::size_t>(context.elements[0])];
}

class Allocates : public OfOneParameter {
 public:
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext& context, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    const std::vector<double> copy(context.parameters.begin(), context.parameters.end());
    load_of(context, loads).force += copy[0];
  }
};

class ReplacesTheList : public OfOneParameter {
 public:
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext&, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    static thread_local std::vector<lacuna::JointLoad> own(8);
    loads.joints = own;
  }
};

class OverwritesOthers : public OfOneParameter {
 public:
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext& context, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    load_of(context, loads).force = context.parameters[0];
  }
};

class ReadsBeyond : public OfOneParameter {
 public:
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext& context, std::span<const double>,
                 lacuna::StepLoads& loads) const override {
    load_of(context, loads).force += context.parameters.data()[1];
  }
};

class AmendsFromBeyond : public OfOneParameter {
 public:
  void amend(lacuna::RobotSpec& robot, const lacuna::EffectContext& context) const override {
    robot.joints[static_cast<std::size_t>(context.elements[0])].damping += *(context.parameters.data() - 1);
  }
};

class WritesBeyond : public OfOneParameter {
 public:
  void advance(const lacuna::StepView&, const lacuna::EffectContext&, std::span<double> state) const override {
    state.data()[2] = 1.0;
  }
};

class Rounds : public OfOneParameter {
 public:
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext&, std::span<const double>,
                 lacuna::StepLoads&) const override {
    std::fesetround(FE_DOWNWARD);
  }
};

/// Scales what others have added, allocates where that is allowed, and remembers.
class Sound : public OfOneParameter {
 public:
  void amend(lacuna::RobotSpec& robot, const lacuna::EffectContext&) const override {
    robot.name = std::string(100, 'x');
  }
  void start(const lacuna::StepView&, const lacuna::EffectContext&, std::span<double> state) const override {
    state[1] = *std::make_unique<double>(2.0);
  }
  void add_loads(const lacuna::StepView& view, const lacuna::EffectContext& context, std::span<const double> state,
                 lacuna::StepLoads& loads) const override {
    lacuna::JointLoad& load = load_of(context, loads);
    load.friction_upper *= 1.1;
    load.force += context.parameters[0] * view.positions[0] + state[1];
    loads.contact.friction = 0.5;
  }
  void advance(const lacuna::StepView&, const lacuna::EffectContext&, std::span<double> state) const override {
    state[0] += 1.0;
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, Allocates>("allocates"),
              lacuna::component<lacuna::PhysicalEffect, ReplacesTheList>("replaces_the_list"),
              lacuna::component<lacuna::PhysicalEffect, OverwritesOthers>("overwrites_others"),
              lacuna::component<lacuna::PhysicalEffect, ReadsBeyond>("reads_beyond"),
              lacuna::component<lacuna::PhysicalEffect, AmendsFromBeyond>("amends_from_beyond"),
              lacuna::component<lacuna::PhysicalEffect, WritesBeyond>("writes_beyond"),
              lacuna::component<lacuna::PhysicalEffect, Rounds>("rounds"),
              lacuna::component<lacuna::PhysicalEffect, Sound>("sound"))
