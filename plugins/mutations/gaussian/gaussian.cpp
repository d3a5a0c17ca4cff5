#include <lacuna/mutation_operator.h>
#include <lacuna/plugin.h>

namespace lacuna {

/// Adds a normal number to each gene with a probability of `expected` over the number of genes; reflected at the
/// bounds.
class Gaussian : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

namespace {

enum Parameter : std::size_t { kExpected, kSigma };

}  // namespace

std::string Gaussian::summary() const {
  return "Moves some genes by normally distributed steps, reflected at their bounds";
}

ParameterDeclarations Gaussian::parameters() const {
  return {{"expected", "1", 2.0, 0.0, 1e6, Scale::linear, "Expected number of genes that are moved"},
          {"sigma", "1", 0.1, 1e-9, 10.0, Scale::logarithmic, "Standard deviation of a move, as a share of the range"}};
}

Genome Gaussian::vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
                      RandomStream& random) const {
  Genome child = parents.front();
  const double probability = parameters[kExpected] / static_cast<double>(layout.size());
  for (std::size_t i = 0; i < child.size(); ++i) {
    if (!random.chance(probability)) continue;
    const Gene& gene = layout.genes[i];
    child[i] = reflected_value(gene, child[i] + parameters[kSigma] * (gene.upper - gene.lower) * random.normal());
  }
  return child;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::MutationOperator, lacuna::Gaussian>("gaussian"))
