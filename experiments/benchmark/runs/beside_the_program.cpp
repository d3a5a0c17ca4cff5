#include "runs/beside_the_program.h"

#include "baselines/baselines.h"
#include "cases/write_case.h"

#include <algorithm>

namespace hidden_effects {
namespace {

EffectAt effect_at(const LawKind& kind, int element, const PlantSpec& spec) {
  const std::string place = where_of(kind, element, spec);
  return {kind.effect, place.empty() ? "world" : place};
}

EffectAt effect_at(const RankedEffect& ranked, const PlantSpec& spec) {
  LawKind kind;
  kind.effect = ranked.effect;
  kind.place = ranked.place;
  return effect_at(kind, ranked.element, spec);
}

}  // namespace

OracleRecord oracle_record(const MadeCase& made, const OracleAnswer& answer) {
  OracleRecord record;
  const PlantSpec& spec = made.base.spec;
  for (std::size_t law = 0; law < answer.rivals.size(); ++law) {
    const int number = static_cast<int>(law);
    record.rivals.push_back({number, {}, answer.base_non_centrality, answer.detectable});
    for (const Rival& rival : answer.rivals[law])
      record.rivals.push_back(
          {number, effect_at(*rival.law.kind, rival.law.element, spec), rival.non_centrality, rival.told_apart});
  }
  for (const Width& width : answer.widths) record.widths.push_back({width.parameter, width.width});
  return record;
}

std::vector<std::string> class_effects(const MadeCase& made, const OracleAnswer& answer) {
  std::vector<std::string> effects;
  for (std::size_t law = 0; law < made.truth.laws.size(); ++law) {
    effects.push_back(made.truth.laws[law].kind->effect);
    if (law >= answer.rivals.size()) continue;
    for (const PlacedLaw& alike : answer.alike(law)) effects.push_back(alike.kind->effect);
  }
  std::sort(effects.begin(), effects.end());
  effects.erase(std::unique(effects.begin(), effects.end()), effects.end());
  return effects;
}

std::vector<BaselineRecord> baseline_records(const MadeCase& made, const std::vector<std::string>& withheld) {
  std::vector<BaselineRecord> records;
  for (const BaselineAnswer& answer : run_baselines(made, withheld)) {
    BaselineRecord record{answer.name, static_cast<int>(answer.chosen), answer.seconds, {}, {}};
    for (const RankedEffect& ranked : answer.ranking) {
      record.ranking.push_back(effect_at(ranked, made.base.spec));
      record.scores.push_back(ranked.score);
    }
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace hidden_effects
