#include "runs/ask_baselines.h"

#include "baselines/baselines.h"
#include "cases/write_case.h"

#include <algorithm>

namespace hidden_effects {
namespace {

EffectAt effect_at(const RankedEffect& ranked, const PlantSpec& spec) {
  LawKind kind;
  kind.place = ranked.place;
  const std::string place = where_of(kind, ranked.element, spec);
  return {ranked.effect, place.empty() ? "world" : place};
}

}  // namespace

std::vector<BaselineRecord> ask_baselines(const MadeCase& made, const std::vector<std::string>& withheld) {
  std::vector<BaselineRecord> records;
  for (const BaselineAnswer& answer : run_baselines(made, withheld)) {
    BaselineRecord& record = records.emplace_back();
    record.method = answer.name;
    record.chosen = static_cast<int>(answer.chosen);
    record.seconds = answer.seconds;
    for (std::size_t i = 0; i < std::min(answer.ranking.size(), kBaselineRanks); ++i) {
      record.ranking.push_back(effect_at(answer.ranking[i], made.base.spec));
      record.scores.push_back(answer.ranking[i].score);
    }
  }
  return records;
}

}  // namespace hidden_effects
