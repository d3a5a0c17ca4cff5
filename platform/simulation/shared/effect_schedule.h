#pragma once

#include "simulation/model_structure.h"

#include <span>
#include <vector>

namespace lacuna::simulation {

/// The effects of a structure in their canonical order: by name, placement, id. All results that depend on an effect's
/// position use this order, never that of the file.
std::vector<PlacedEffect> canonical(std::vector<PlacedEffect> effects);

/// The order of calls to effects. Const, part of the compiled model.
class EffectSchedule {
 public:
  /// `effects` in canonical order, must outlive the schedule. Throws `BadInput` for effects with wrong values or
  /// elements and for hooks that are not possible at their placement.
  EffectSchedule(const std::vector<PlacedEffect>& effects, const RobotSpec& robot, double step);

  /// A command or sense hook for one element of its placement.
  struct Call {
    std::size_t effect = 0;
    int which = 0;  ///< index into the placement's elements
  };

  /// Gets the size of each effect's state; `largest_values`: per effect, one per parameter.
  void size_states(const std::vector<std::vector<double>>& largest_values);

  const std::vector<PlacedEffect>& effects() const { return effects_; }
  /// Name of the effect for a parent process (foundation/plugins/plugin_call.h).
  const char* on_page(std::size_t effect) const { return on_page_[effect]; }
  EffectContext context(std::size_t effect, std::span<const double> values) const;  ///< of a whole step
  std::span<double> state_of(std::size_t effect, std::span<double> states) const;
  std::size_t state_size() const { return state_offsets_.back(); }

  const std::vector<std::size_t>& amending() const { return amending_; }
  const std::vector<std::size_t>& loading() const { return loading_; }
  const std::vector<std::size_t>& advancing() const { return advancing_; }
  /// Whether any effect needs bodies. Effects on joints, actuators and sensors do not, nor those that only change
  /// numbers.
  bool looks_at_bodies() const { return looks_at_bodies_; }
  bool acts_in_steps() const { return !loading_.empty() || !advancing_.empty(); }
  const std::vector<Call>& commands(std::size_t actuator) const { return commands_[actuator]; }  ///< by stage
  const std::vector<Call>& senses(std::size_t sensor) const { return senses_[sensor]; }          ///< by stage
  bool any_sense() const { return any_sense_; }

 private:
  void schedule(std::size_t effect);

  const std::vector<PlacedEffect>& effects_;
  double step_;
  std::vector<const char*> on_page_;  // per effect
  std::vector<std::size_t> amending_, loading_, advancing_;
  std::vector<std::vector<Call>> commands_, senses_;  // per actuator, per sensor
  std::vector<std::size_t> state_offsets_;            // one more than effects
  bool any_sense_ = false;
  bool looks_at_bodies_ = false;
};

}  // namespace lacuna::simulation
