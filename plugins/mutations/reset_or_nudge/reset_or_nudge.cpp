#include "reset_or_nudge.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kReset, kCoarsest, kFinest };

/// The gene moved by ±range·10^−δ and held within its bounds.
double nudged(const Gene& gene, double value, double delta, bool up) {
  const double move = (gene.upper - gene.lower) * std::pow(10.0, -delta);
  const double moved = std::clamp(value + (up ? move : -move), gene.lower, gene.upper);
  return gene.kind == GeneKind::integer ? std::round(moved) : moved;
}

}  // namespace

std::string ResetOrNudge::summary() const {
  return "Gives one gene a new uniform value or moves it a little, by steps of all sizes";
}

ParameterDeclarations ResetOrNudge::parameters() const {
  return {{"reset", "1", 0.5, 0.0, 1.0, Scale::linear, "Chance of a new value; otherwise the gene moves"},
          {"coarsest", "1", 1.0, 0.0, 15.0, Scale::linear, "Decades below the gene's range of the largest move"},
          {"finest", "1", 7.0, 0.0, 15.0, Scale::linear, "Decades below the gene's range of the smallest move"}};
}

Genome ResetOrNudge::vary(std::span<const Genome> parents, const GenomeLayout& layout,
                          std::span<const double> parameters, RandomStream& random) const {
  if (parameters[kCoarsest] > parameters[kFinest])
    throw Error("coarsest is to be at most finest: both count decades below the gene's range");
  Genome child = parents.front();
  const std::size_t place = random.index(child.size());
  const Gene& gene = layout.genes[place];
  if (random.chance(parameters[kReset])) {
    child[place] = uniform_value(gene, random);
  } else {
    const double delta = random.uniform(parameters[kCoarsest], parameters[kFinest]);
    child[place] = nudged(gene, child[place], delta, random.chance(0.5));
  }
  return child;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::MutationOperator, lacuna::ResetOrNudge>("reset_or_nudge"))
