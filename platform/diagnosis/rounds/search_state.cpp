#include "diagnosis/rounds/search_state.h"

namespace lacuna {

std::string name_of(const EffectEntry& entry) {
  return entry.effect + " @ " + (entry.where.empty() ? "world" : entry.where.front());
}

EffectNames names_of(const std::vector<EffectEntry>& entries) {
  EffectNames names;
  for (const EffectEntry& entry : entries) names.insert(name_of(entry));
  return names;
}

EffectNames names_with(const std::vector<EffectEntry>& entries, const EffectEntry& further) {
  EffectNames names = names_of(entries);
  names.insert(name_of(further));
  return names;
}

Contender with_effect_of(const KeptRival& rival, const SearchStep& step, const Contender& plain,
                         const PluginCatalog& catalog) {
  std::vector<EffectEntry> added = step.added;
  added.push_back(rival.entry);
  return with_effects(plain, added, rival.values, catalog);
}

}  // namespace lacuna
