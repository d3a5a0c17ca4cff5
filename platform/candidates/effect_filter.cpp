#include "candidates/effect_filter.h"

#include "candidates/hypothesis.h"
#include "candidates/wrong_value.h"
#include "foundation/address.h"
#include "foundation/text/counted.h"

#include <lacuna/physical_effect.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lacuna {
namespace {

/// Why an effect of the library has no place in this model.
std::string reason_against(const EffectDescription& description, const ModelDefinition& base, const std::string& name,
                           const std::vector<Untestable>& tried) {
  if (!tried.empty()) return tried.front().reason;
  for (const EffectEntry& entry : base.effects)
    if (entry.effect == name) return "the model already has this effect on every element on which it can act";
  std::vector<std::string> kinds;
  for (const ElementKind kind : description.placements) kinds.push_back(with_article(std::string(to_string(kind))));
  return fmt::format("it acts on {}; the robot has none", fmt::join(kinds, " or "));
}

std::string objection(const std::string& name, const Experiment& experiment, const PluginCatalog& catalog,
                      const ModelDefinition& base) {
  if (name == kWrongValue)
    return wrong_values(base).empty() ? "--among wrong_value: the robot file has no fixed value that could be wrong; "
                                        "remove wrong_value from --among"
                                      : "";
  try {
    const EffectDescription description = catalog.get<PhysicalEffect>(name).describe();
    std::vector<Untestable> tried;
    if (!list_hypotheses(experiment, catalog, base, {name}, tried).empty()) return "";
    return fmt::format("--among {0}: the effect cannot be added to this model: {1}; remove {0} from --among", name,
                       reason_against(description, base, name, tried));
  } catch (const Error& error) {
    return fmt::format("--among {}: {}", name, error.what());
  }
}

}  // namespace

std::vector<std::string> check_effect_filter(const std::vector<std::string>& among, const Experiment& experiment,
                                             const PluginCatalog& catalog, const ModelDefinition& base) {
  ProblemList problems;
  std::vector<std::string> once;
  for (const std::string& name : among) {
    if (std::find(once.begin(), once.end(), name) != once.end()) continue;
    once.push_back(name);
    if (std::string sentence = objection(name, experiment, catalog, base); !sentence.empty())
      problems.add({}, std::move(sentence));
  }
  problems.throw_if_any();
  return once;
}

}  // namespace lacuna
