#pragma once

#include <lacuna/search_strategy.h>

namespace lacuna {

/// The seed's search (Bongard and Lipson, experiment 1): each generation keeps the best and replaces the others by
/// their children. Survivors keep their scores. An evaluation may be abandoned as soon as it is worse than the worst
/// survivor.
class Truncation : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where nothing would be left to replace.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

}  // namespace lacuna
