#include "evolution/operator_breeder.h"

#include "foundation/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

/// The child so far and as many others as the operator asks for.
std::vector<Genome> group_of(const Genome& child, std::size_t first, std::span<const Genome> parents, std::size_t count,
                             RandomStream& random, std::vector<std::size_t>& used) {
  std::vector<Genome> group = {child};
  while (group.size() < count) {
    std::size_t other = random.index(parents.size());
    if (parents.size() > 1) {
      other = random.index(parents.size() - 1);
      other += other >= first ? 1 : 0;  // any but the first
    }
    used.push_back(other);
    group.push_back(parents[other]);
  }
  return group;
}

void check(const Genome& genome, const GenomeLayout& layout, const ComponentOrigin& origin) {
  const std::string problem = misfit(genome, layout);
  if (!problem.empty())
    throw Error(to_string(origin) + ": its genome " + problem + "; this is a fault of the plugin: repair it");
}

}  // namespace

std::string misfit(const Genome& genome, const GenomeLayout& layout) {
  if (genome.size() != layout.size())
    return "has " + std::to_string(genome.size()) + " genes instead of " + std::to_string(layout.size());
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const Gene& gene = layout.genes[i];
    const std::string what = "has " + number_text(genome[i]) + " for " + gene.name;
    if (!(genome[i] >= gene.lower && genome[i] <= gene.upper))
      return what + ", out of its bounds " + number_text(gene.lower) + " to " + number_text(gene.upper);
    if (gene.kind == GeneKind::integer && genome[i] != std::round(genome[i])) return what + ", which is to be whole";
  }
  return {};
}

OperatorBreeder::OperatorBreeder(GenomeLayout layout, std::function<Genome(RandomStream&)> random,
                                 std::vector<AppliedMutation> mutations)
    : layout_(std::move(layout)), random_(std::move(random)), mutations_(std::move(mutations)) {}

Genome OperatorBreeder::random(RandomStream& random) const { return random_(random); }

Genome OperatorBreeder::child(std::span<const Genome> parents, RandomStream& random,
                              std::vector<std::size_t>& used) const {
  const std::size_t first = random.index(parents.size());
  used.assign(1, first);
  Genome child = parents[first];
  for (const AppliedMutation& applied : mutations_) {
    if (!random.chance(applied.chance)) continue;
    const auto group = [&] { return group_of(child, first, parents, applied.mutation->parents(), random, used); };
    child = varied(applied, group, random);
  }
  return child;
}

Genome OperatorBreeder::trial_child(std::size_t index, RandomStream& random) const {
  const AppliedMutation& applied = mutations_[index];
  const Genome parent = random_(random);
  const auto group = [&] { return std::vector<Genome>(std::max<std::size_t>(applied.mutation->parents(), 1), parent); };
  return varied(applied, group, random);
}

Genome OperatorBreeder::varied(const AppliedMutation& applied, const std::function<std::vector<Genome>()>& group,
                               RandomStream& random) const {
  Genome child = guarded_call(applied.origin, "vary",
                              [&] { return applied.mutation->vary(group(), layout_, applied.parameters, random); });
  check(child, layout_, applied.origin);
  return child;
}

}  // namespace lacuna
