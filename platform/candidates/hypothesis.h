#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "loading/plugin_catalog.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// A base model with one more effect at one place, or with one more value fitted: what the base may lack.
struct Hypothesis {
  EffectEntry entry;  ///< the effect and where it is
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::vector<std::size_t> base;   ///< where `definition.free` has the base's values, in the base's order
  std::vector<std::size_t> own;    ///< where it has the effect's, in the order of its declaration
  std::vector<double> neutral;     ///< values of its own at which the effect changes nothing
  std::vector<double> defaults;    ///< declared values of its own
  std::vector<std::string> alike;  ///< effects that look alike, as it declares

  /// "joint.hinge"; "world".
  std::string where() const;
  /// All free values: the base's and its own.
  std::vector<double> values(const std::vector<double>& of_base, const std::vector<double>& of_own) const;
};

bool is_length(const FreeValue& free);

/// Whether an effect acts at a place that is fitted: at the neutral one it may matter, and yet not as it does
/// elsewhere.
bool has_place(const Hypothesis& hypothesis);

/// "coulomb_friction @ joint.hinge".
std::string member_name(const EffectEntry& entry);

/// Why an effect is not tested.
struct Untestable {
  std::string effect;
  std::string where;  ///< empty: nowhere
  std::string reason;
  bool failed = false;  ///< its plugin failed; else it has no place here, or nothing shows it
  bool operator==(const Untestable&) const = default;
};

/// Every effect of the catalog on every element that it can be placed on, one at a time, and on all of them together
/// where there are several; what `base` has already at the same place is left out; then the robot's fixed numbers that
/// may be wrong (`wrong_values`). `among`: names of effects, or `wrong_value`; empty: all. What cannot be placed is
/// added to `untestable`. Throws `Error` for a name that no plugin has.
std::vector<Hypothesis> list_hypotheses(const Experiment& experiment, const PluginCatalog& catalog,
                                        const ModelDefinition& base, const std::vector<std::string>& among,
                                        std::vector<Untestable>& untestable);

/// For one whose probes all show nothing or fail. `failure`: why its last simulation that failed did; empty: none did.
/// What the effect did wrong in a step is its plugin's failure.
Untestable without_probes(const Hypothesis& hypothesis, const std::string& failure);

/// The experiment with one effect more, under an id that is not taken, or with one value more that is fitted.
Experiment with_effect(Experiment experiment, EffectEntry entry);

}  // namespace lacuna
