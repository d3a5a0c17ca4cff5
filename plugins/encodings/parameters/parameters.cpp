#include "parameters.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

std::string Parameters::summary() const { return "One gene a free parameter: its value in SI units"; }

GenomeLayout Parameters::layout(const ModelSpace& space, std::span<const double>) const {
  if (space.free.empty()) throw Error("the model has no free parameter to encode; name some under [model.free]");
  GenomeLayout layout;
  for (const FreeParameter& free : space.free) {
    if (!std::isfinite(free.lower) || !std::isfinite(free.upper) || free.lower > free.upper)
      throw Error(free.address + " has no finite search range; give its bounds under [model.free]");
    layout.genes.push_back({free.address, free.unit, GeneKind::real, free.lower, free.upper});
  }
  return layout;
}

ModelProposal Parameters::decode(const ModelSpace& space, std::span<const double>,
                                 std::span<const double> genome) const {
  if (genome.size() != space.free.size())
    throw Error("a genome of " + std::to_string(genome.size()) + " genes does not fit a model with " +
                std::to_string(space.free.size()) + " free parameters");
  ModelProposal model;
  for (std::size_t i = 0; i < genome.size(); ++i)
    model.values.push_back(std::clamp(genome[i], space.free[i].lower, space.free[i].upper));
  return model;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ModelEncoding, lacuna::Parameters>("parameters"))
