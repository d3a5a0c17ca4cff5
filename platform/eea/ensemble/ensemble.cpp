#include "eea/ensemble/ensemble.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace lacuna {

std::vector<std::size_t> differing(const std::vector<KnownModel>& models, std::size_t count,
                                   const Phenotypes& phenotypes) {
  std::vector<std::size_t> chosen, others, copies;
  std::set<std::pair<int, std::string>> niches;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const bool is_new = seen.insert(phenotypes.of(models[i].model)).second;
    const bool first_of_its_niche = niches.insert({models[i].restart, models[i].model.structure}).second;
    (!is_new ? copies : first_of_its_niche ? chosen : others).push_back(i);
  }
  chosen.insert(chosen.end(), others.begin(), others.end());
  chosen.insert(chosen.end(), copies.begin(), copies.end());
  chosen.resize(std::min(count, chosen.size()));
  return chosen;
}

}  // namespace lacuna
