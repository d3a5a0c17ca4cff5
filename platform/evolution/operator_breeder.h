#pragma once

#include <lacuna/mutation_operator.h>
#include <lacuna/search_strategy.h>

#include "foundation/processes/guarded_call.h"

#include <functional>
#include <vector>

namespace lacuna {

/// A mutation operator with its settings.
struct AppliedMutation {
  const MutationOperator* mutation = nullptr;
  std::vector<double> parameters;
  double chance = 1.0;  ///< that it is applied to a child
  ComponentOrigin origin;
};

/// Makes children by a list of operators: one of the parents is chosen at random, then each operator is applied in its
/// turn with its chance. An operator of several parents gets the child so far first, then others chosen at random from
/// the rest. Const and shared by threads.
class OperatorBreeder : public Breeder {
 public:
  OperatorBreeder(GenomeLayout layout, std::function<Genome(RandomStream&)> random,
                  std::vector<AppliedMutation> mutations);

  const GenomeLayout& layout() const { return layout_; }
  const std::vector<AppliedMutation>& mutations() const { return mutations_; }
  /// A child of a random genome by one of the mutations alone, whatever its chance. Throws `Error` as `child` does.
  Genome trial_child(std::size_t index, RandomStream& random) const;
  Genome random(RandomStream& random) const override;
  /// Throws `Error` where an operator throws, or makes a genome that does not fit the layout.
  Genome child(std::span<const Genome> parents, RandomStream& random, std::vector<std::size_t>& used) const override;

 private:
  Genome varied(const AppliedMutation& applied, const std::function<std::vector<Genome>()>& group,
                RandomStream& random) const;

  GenomeLayout layout_;
  std::function<Genome(RandomStream&)> random_;
  std::vector<AppliedMutation> mutations_;
};

/// Why the genome does not fit the layout, as in "has 3 genes instead of 17"; empty: it fits.
std::string misfit(const Genome& genome, const GenomeLayout& layout);

}  // namespace lacuna
