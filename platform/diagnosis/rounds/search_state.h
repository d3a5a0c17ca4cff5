#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/findings/diagnosis.h"

#include <lacuna/effect_list.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// Effects of a model, each "name @ where".
using EffectNames = std::set<std::string>;

std::string name_of(const EffectEntry& entry);
EffectNames names_of(const std::vector<EffectEntry>& entries);
EffectNames names_with(const std::vector<EffectEntry>& entries, const EffectEntry& further);

/// A refitted rival of a round, as far as it is needed once the round is over.
struct KeptRival {
  EffectEntry entry;           ///< what it adds
  std::vector<double> values;  ///< of the model with it, SI
  Gain gain;                   ///< over the round's model
};

/// A round in which an effect was chosen.
struct SearchStep {
  std::vector<EffectEntry> added;  ///< of the model that was looked at
  std::vector<KeptRival> rivals;   ///< the largest gain first
  std::size_t chosen = 0;
};

/// The model that a step chose from, with one of its rivals.
Contender with_effect_of(const KeptRival& rival, const SearchStep& step, const Contender& plain,
                         const PluginCatalog& catalog);

inline constexpr std::size_t kMostEffects = 3;

/// Where a search for what is missing stands between two rounds: all that the rest of it follows from, beside what is
/// diagnosed.
struct SearchState {
  std::vector<EffectEntry> added;
  std::vector<double> values;       ///< of the model with `added`, SI
  std::optional<SearchStep> last;   ///< whose choice may still be taken back
  std::optional<SearchStep> first;  ///< of the model without any effect
  std::vector<RankedModel> first_ranking;
  std::size_t most_effects = kMostEffects;    ///< fewer once fewer were found to be enough
  std::set<EffectNames> tried;                ///< models that were looked at
  std::map<EffectNames, Gain> gains;          ///< of models, over the one without any
  std::map<EffectNames, std::string> enough;  ///< of models that do with fewer effects: what a finding says of it
  std::vector<double> base_values;            ///< refitted, of the model without any
  bool law_leads = false;  ///< the first formula for it, over every single effect (outdone_library.h)
  Diagnosis so_far;
};

}  // namespace lacuna
