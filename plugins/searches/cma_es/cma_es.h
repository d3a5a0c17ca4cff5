#pragma once

#include <lacuna/search_strategy.h>

namespace lacuna {

/// Evolution strategy with covariance matrix adaptation after N. Hansen, "The CMA evolution strategy: a tutorial"
/// (2016, arXiv:1604.00772), with weights on the better half only. Makes its own children: the breeder is not used. All
/// scores count in full: which of them belong to the better half is not known before the generation ends.
class CmaEs : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a population of 1.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

}  // namespace lacuna
