#include <lacuna/mutation_operator.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Gives each gene a new uniform value with a probability of `expected` over the number of genes.
class UniformReset : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

std::string UniformReset::summary() const {
  return "Gives some genes new values, uniformly distributed within their bounds";
}

ParameterDeclarations UniformReset::parameters() const {
  return {{"expected", "1", 2.0, 0.0, 1e6, Scale::linear, "Expected number of genes with a new value"}};
}

Genome UniformReset::vary(std::span<const Genome> parents, const GenomeLayout& layout,
                          std::span<const double> parameters, RandomStream& random) const {
  Genome child = parents.front();
  const double probability = parameters[0] / static_cast<double>(layout.size());
  for (std::size_t i = 0; i < child.size(); ++i)
    if (random.chance(probability)) child[i] = uniform_value(layout.genes[i], random);
  return child;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::MutationOperator, lacuna::UniformReset>("uniform_reset"))
