#include "runs/ask_oracle.h"

#include "cases/write_case.h"
#include "oracle/oracle.h"

#include <algorithm>

namespace hidden_effects {
namespace {

EffectAt effect_at(const PlacedLaw& law, const PlantSpec& spec) {
  const std::string place = where_of(*law.kind, law.element, spec);
  return {law.kind->effect, place.empty() ? "world" : place};
}

void add_once(const OracleRival& one, std::vector<OracleRival>& all) {
  const bool known = std::any_of(all.begin(), all.end(), [&](const OracleRival& other) {
    return other.law == one.law && other.rival == one.rival;
  });
  if (!known) all.push_back(one);
}

}  // namespace

OracleRecord oracle_record(const MadeCase& made) {
  const OracleAnswer answer = ask_oracle(made);
  OracleRecord record;
  for (std::size_t law = 0; law < answer.rivals.size(); ++law) {
    const int number = static_cast<int>(law);
    add_once({number, {"", ""}, answer.base_non_centrality, answer.detectable}, record.rivals);
    for (const Rival& rival : answer.rivals[law])
      add_once({number, effect_at(rival.law, made.truth.spec), rival.non_centrality, rival.told_apart}, record.rivals);
  }
  for (const Width& width : answer.widths) record.widths.push_back({width.parameter, width.width});
  return record;
}

std::vector<std::string> class_effects(const CaseRecord& about, const OracleRecord& oracle) {
  std::vector<std::string> effects;
  const auto add = [&](const std::string& effect) {
    if (!effect.empty() && std::find(effects.begin(), effects.end(), effect) == effects.end())
      effects.push_back(effect);
  };
  for (const HiddenLawRecord& law : about.hidden) add(law.answer.effect);
  for (const OracleRival& one : oracle.rivals)
    if (!one.told_apart) add(one.rival.effect);
  return effects;
}

}  // namespace hidden_effects
