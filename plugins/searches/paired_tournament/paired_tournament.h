#pragma once

#include <lacuna/search_strategy.h>

namespace lacuna {

/// The search of the seed's experiment 2: pairs drawn one after the other; the fitter overwrites the other, and the
/// copy is varied. A generation is so many pairs. Pairs whose individuals have a score are asked together.
class PairedTournament : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

}  // namespace lacuna
