#include "diagnosis/rounds/outdone_library.h"

#include "diagnosis/rounds/selection.h"

#include <algorithm>

namespace lacuna {

bool law_leads(const Round& round, std::uint64_t seed) {
  return !round.formulas.empty() && std::all_of(round.rivals.begin(), round.rivals.end(), [&](const Rival& rival) {
    return gain(rival.held_out, round.formulas.front().held_out, seed).lower_95 > 0.0;
  });
}

bool outdoes_library(const ForceFormula& law, const Round& round, std::size_t added, const Gain& before) {
  return added >= law.terms.size() && round.free_force.p < kFreeForceLevel && lead_of(law, round, before) > 0.0;
}

double lead_of(const ForceFormula& law, const Round& round, const Gain& before) {
  double best = before.value;
  for (const Rival& rival : round.rivals) best = std::max(best, sum(before, rival.gain).value);
  return law.gain.value - best;
}

}  // namespace lacuna
