#include "runs/ask_oracle.h"

#include "cases/write_case.h"
#include "oracle/oracle.h"
#include "oracle/rivals.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hidden_effects {
namespace {

EffectAt effect_at(const PlacedLaw& law, const PlantSpec& spec) {
  const std::string place = where_of(*law.kind, law.element, spec);
  return {law.kind->effect, place.empty() ? "world" : place};
}

std::optional<std::vector<double>> parameters_of(const RankedEffectRecord& effect, const LawKind& kind) {
  std::vector<double> parameters;
  for (const std::string& name : kind.parameters)
    for (const IntervalRecord& one : effect.parameters)
      if (one.parameter == name && std::isfinite(one.value))
        parameters.push_back(is_even(kind, name) ? std::abs(one.value) : one.value);
  return parameters.size() == kind.parameters.size() ? std::optional(parameters) : std::nullopt;
}

bool is_member(const EffectAt& what, const RankedModelRecord& answer) {
  return std::find(answer.look_alikes.begin(), answer.look_alikes.end(), what) != answer.look_alikes.end() ||
         std::any_of(answer.effects.begin(), answer.effects.end(),
                     [&](const RankedEffectRecord& effect) { return effect.what == what; });
}

/// Where the first diagnosis puts the members of its answer.
std::vector<KnownStart> known_starts(const MadeCase& made, const std::vector<DiagnosisRecord>& told) {
  std::vector<KnownStart> known;
  if (told.empty() || told.front().ranking.empty()) return known;
  const PlantSpec& spec = made.truth.spec;
  for (const RankedModelRecord& model : told.front().ranking)
    for (const RankedEffectRecord& effect : model.effects) {
      if (!is_member(effect.what, told.front().ranking.front())) continue;
      for (const PlacedLaw& law : library_laws(spec))
        if (effect_at(law, spec) == effect.what)
          if (auto parameters = parameters_of(effect, *law.kind)) known.push_back({law, std::move(*parameters)});
    }
  return known;
}

void add_once(const OracleRival& one, std::vector<OracleRival>& all) {
  const bool known = std::any_of(all.begin(), all.end(), [&](const OracleRival& other) {
    return other.law == one.law && other.rival == one.rival;
  });
  if (!known) all.push_back(one);
}

/// Of two laws that do for each other, but not both: that of both.
Absence absence_of(const OracleAnswer& answer, std::size_t law) {
  const bool none_is_told =
      std::none_of(answer.absences.begin(), answer.absences.end(), [](const Absence& one) { return one.told_apart; });
  return none_is_told ? Absence{answer.base_non_centrality, answer.detectable} : answer.absences[law];
}

}  // namespace

OracleRecord oracle_record(const MadeCase& made, const std::vector<DiagnosisRecord>& told) {
  OracleOptions options;
  options.known = known_starts(made, told);
  const OracleAnswer answer = ask_oracle(made, options);
  OracleRecord record;
  for (std::size_t law = 0; law < answer.rivals.size(); ++law) {
    const int number = static_cast<int>(law);
    const Absence absence = absence_of(answer, law);
    add_once({number, {"", ""}, absence.non_centrality, absence.told_apart}, record.rivals);
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
