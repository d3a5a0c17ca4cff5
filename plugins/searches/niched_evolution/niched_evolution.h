#pragma once

#include <lacuna/search_strategy.h>

namespace lacuna {

/// Differential evolution inside niches: a niche is a combination of the whole-number genes, a structure, and its
/// members differ in the real ones. Every few generations the worse half of the niches gives up its place, so that the
/// evaluations go to the structures that explain most.
class NichedEvolution : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for niches of fewer than four members, and where fewer niches begin than are to be left.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

}  // namespace lacuna
