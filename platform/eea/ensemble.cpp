#include "eea/ensemble.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace lacuna {

std::vector<std::size_t> differing(const std::vector<KnownModel>& models, std::size_t count) {
  std::vector<std::size_t> chosen, left;
  std::set<std::pair<int, std::string>> niches;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const bool first_of_its_niche = niches.insert({models[i].restart, models[i].model.structure}).second;
    (first_of_its_niche ? chosen : left).push_back(i);
  }
  chosen.insert(chosen.end(), left.begin(), left.end());
  chosen.resize(std::min(count, chosen.size()));
  return chosen;
}

}  // namespace lacuna
