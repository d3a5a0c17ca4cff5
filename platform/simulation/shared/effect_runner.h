#pragma once

#include "foundation/plugins/plugin_call.h"
#include "foundation/processes/process_watch.h"
#include "simulation/shared/effect_schedule.h"
#include "simulation/shared/model_instance.h"
#include "simulation/shared/state_archive.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna::simulation {

/// Calls the effects of one simulation and holds their state. Belongs to a workspace; allocates nothing after
/// construction.
class EffectRunner {
 public:
  EffectRunner(const EffectSchedule& schedule, const ModelInstance& instance)
      : schedule_(schedule), instance_(instance), states_(schedule.state_size(), 0.0) {}

  /// Called first in every simulation, on its thread.
  void amend(RobotSpec& robot);
  void start(const StepView& view);
  /// Throws `Error` that names the effect if a load is not finite.
  void add_loads(const StepView& view, double length, StepLoads& loads);
  void advance(const StepView& view, double length);
  double command(std::size_t actuator, double value, const StepView& view);
  void sense(std::size_t sensor, std::span<double> channels, const StepView& view);
  /// Delay of a sensor's readings behind the motion because of the effects, s.
  double lateness(std::size_t sensor, double time);

  void save(StateWriter& writer) const { writer.put(states_); }
  void load(StateReader& reader) { reader.get(states_); }

  /// Called last. Throws `Error` where the effects changed the process; checks everything that is not checked after
  /// each hook.
  void end() const;

  /// Whether the current exception came from a hook of an effect. Before `explain`.
  bool runs_one() const { return running_ != kNone; }
  /// Only inside a `catch` block, once: a sentence about the exception, which names the effect if it came from one of
  /// the hooks.
  std::string explain();

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  void enter(std::size_t effect, const char* hook) {
    running_ = effect;
    hook_ = hook;
    call_->enter(schedule_.on_page(effect), hook);
  }
  /// Called after each hook; takes a few instructions.
  void check() const { throw_if_arithmetic_changed(hook_); }
  void leave() {
    running_ = kNone;
    call_->leave();
  }
  EffectContext context(std::size_t effect) const { return schedule_.context(effect, instance_.effect_values(effect)); }
  std::span<double> state(std::size_t effect) { return schedule_.state_of(effect, states_); }
  EffectContext context(std::size_t effect, double length) const {
    EffectContext context = this->context(effect);
    context.step = length;
    return context;
  }
  void add_loads_of(std::size_t effect, const StepView& view, double length, StepLoads& loads);
  [[noreturn]] void throw_culprit(const StepView& view, double length, StepLoads& loads);

  const EffectSchedule& schedule_;
  const ModelInstance& instance_;
  std::vector<double> states_;
  std::size_t running_ = kNone;  // the effect whose hook runs
  const char* hook_ = "";
  std::optional<CallSequence> call_;  // of this thread
};

}  // namespace lacuna::simulation
