#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "candidates/untestable.h"
#include "loading/plugin_catalog.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// A base model with one more effect at one place, or with one more fitted value: a possible cause of its error.
struct Hypothesis {
  EffectEntry entry;                ///< the effect and where it is
  std::vector<EffectEntry> placed;  ///< `placed_entries` of it
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<std::size_t> base;  ///< position of the base's values in `definition.free`, in the base's order
  std::vector<std::size_t> own;   ///< position of the effect's values: by placed entry, in the order of its declaration
  std::vector<double> neutral;    ///< the effect's values at which it changes nothing
  std::vector<double> defaults;   ///< default values of the effect
  std::vector<std::string> alike;  ///< effects that look alike, as it declares

  /// "joint.hinge"; "world".
  std::string where() const;
  /// How many values the effect has at one place.
  std::size_t parameters() const { return own.size() / std::max<std::size_t>(1, placed.size()); }
  /// Names of its own values: "coulomb_friction @ joint.hinge.torque".
  std::vector<std::string> own_names() const;
  /// All free values: those of the base and of the effect.
  std::vector<double> values(const std::vector<double>& of_base, const std::vector<double>& of_own) const;
};

bool is_length(const FreeValue& free);

/// Whether an effect acts at a fitted place: it can matter at the neutral place too, but differently than elsewhere.
bool has_place(const Hypothesis& hypothesis);

/// "coulomb_friction @ joint.hinge".
std::string member_name(const EffectEntry& entry);

/// The entries for which an effect stands in the model. On all of more than three joints (`joint.*`) it has a value for
/// each, so these are one entry per joint with an id of its own: friction differs from joint to joint, and a set has no
/// room for so many members. Every other entry is itself, with one value for all its elements.
std::vector<EffectEntry> placed_entries(const EffectEntry& entry, const RobotSpec& robot);
/// The same of several, in their order.
std::vector<EffectEntry> placed_entries(const std::vector<EffectEntry>& entries, const RobotSpec& robot);

/// Every effect of the catalog on every element that it can be placed on, one at a time, and on all of them together
/// where there are several, except what `base` has at the same place; then the robot's fixed numbers that may be wrong
/// (`wrong_values`). `among`: the effect filter, names of effects or `wrong_value`; empty: all. What cannot be placed
/// is added to `untestable`. Throws `Error` for a name that no plugin has.
std::vector<Hypothesis> list_hypotheses(const Experiment& experiment, const PluginCatalog& catalog,
                                        const ModelDefinition& base, const std::vector<std::string>& among,
                                        std::vector<Untestable>& untestable);

/// The reason for a hypothesis none of whose probes changes a prediction. `failure`: the error of its last simulation
/// that failed; empty: none failed. An error that the effect caused counts as a failure of its plugin.
Untestable without_probes(const Hypothesis& hypothesis, const std::string& failure);

/// The experiment with one more effect, under an unused id, or with one more fitted value.
Experiment with_effect(Experiment experiment, EffectEntry entry);

}  // namespace lacuna
