#include "diagnosis/rounds/ranking.h"

#include "diagnosis/rounds/channel_errors.h"
#include "diagnosis/rounds/selection.h"

#include <algorithm>

namespace lacuna {
namespace {

const EffectEntry& entry_of(const Round& round, std::size_t rival) {
  return round.hypotheses[round.rivals[rival].hypothesis].entry;
}

RankedModel ranked(const Contender& contender, const Round& round, std::size_t which, const Gain& before) {
  const Rival& rival = round.rivals[which];
  std::vector<EffectEntry> added = contender.added;
  added.push_back(entry_of(round, which));
  RankedModel model;
  model.effects = found_effects(added, round.hypotheses[rival.hypothesis].definition, rival.fit);
  model.gain = sum(before, rival.gain);
  model.errors = channel_errors(round.base, round.bins, round.noise, rival.fit, round.folds);
  model.times_floor = times_floor(model.errors);
  model.segment = round.base.segment;
  return model;
}

}  // namespace

std::vector<RankedModel> ranking_of(const Contender& contender, const Round& round, std::optional<std::size_t> chosen,
                                    const Gain& before, std::uint64_t seed) {
  std::vector<RankedModel> ranking;
  if (chosen) {
    ranking.push_back(ranked(contender, round, *chosen, before));
    for (const std::size_t other : inseparable(round, *chosen, seed))
      ranking.front().look_alikes.push_back(name_of(entry_of(round, other)));
  }
  for (std::size_t i = 0; i < round.rivals.size(); ++i)
    if (i != chosen) ranking.push_back(ranked(contender, round, i, before));
  return ranking;
}

SearchStep step_of(const Contender& contender, const Round& round, std::size_t chosen) {
  SearchStep step{contender.added, {}, chosen};
  for (std::size_t i = 0; i < round.rivals.size(); ++i) {
    const Rival& rival = round.rivals[i];
    step.rivals.push_back({entry_of(round, i), rival.fit.values, rival.gain});
  }
  return step;
}

bool is_last_effect(const RankedModel& model, const std::string& name) {
  return !model.effects.empty() && model.effects.back().effect + " @ " + model.effects.back().where == name;
}

void bring_to_front(std::vector<RankedModel>& ranking, const std::string& name) {
  for (RankedModel& model : ranking) model.look_alikes.clear();  // they are those of the first
  const auto found = std::find_if(ranking.begin(), ranking.end(),
                                  [&](const RankedModel& model) { return is_last_effect(model, name); });
  if (found != ranking.end()) std::rotate(ranking.begin(), found, found + 1);
}

}  // namespace lacuna
