#pragma once

#include <lacuna/search_strategy.h>

#include "eea/definition/eea_definition.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// Makes genomes of models whose structures differ from those already examined, within a number of attempts. Definition
/// and breeder must outlive it.
class NewStructureBreeder : public Breeder {
 public:
  NewStructureBreeder(const EeaDefinition& definition, std::set<std::string> taken)
      : definition_(definition), breeder_(*definition.estimation.breeder), taken_(std::move(taken)) {}

  /// Whether repeated attempts find a new structure; `key`: of the random numbers.
  bool can_breed(const std::vector<std::uint64_t>& key) const;

  Genome random(RandomStream& random) const override;
  Genome child(std::span<const Genome> parents, RandomStream& random, std::vector<std::size_t>& used) const override;

  bool is_taken(const ModelProposal& model) const { return taken_.contains(model.structure); }

 private:
  /// A genome that cannot be decoded counts as new.
  bool is_taken(const Genome& genome) const;

  const EeaDefinition& definition_;
  const Breeder& breeder_;
  std::set<std::string> taken_;
};

}  // namespace lacuna
