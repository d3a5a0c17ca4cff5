#pragma once

#include <lacuna/search_strategy.h>

namespace lacuna {

/// Differential evolution, rand/1/bin (Storn and Price, 1997): each individual is challenged by a mix of itself with
/// another one that was moved along the difference of two more. Makes its own children: the breeder only draws the
/// first generation.
class DifferentialEvolution : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a population below 4.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

}  // namespace lacuna
