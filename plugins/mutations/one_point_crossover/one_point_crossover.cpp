#include <lacuna/mutation_operator.h>
#include <lacuna/plugin.h>

#include <algorithm>

namespace lacuna {

/// The first genes of one parent and the rest of another, with a random cut that is never inside a row.
class OnePointCrossover : public MutationOperator {
 public:
  std::string summary() const override;
  std::size_t parents() const override { return 2; }
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

std::string OnePointCrossover::summary() const {
  return "The first genes of one parent and the rest of another, with a random cut";
}

Genome OnePointCrossover::vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double>,
                               RandomStream& random) const {
  Genome child = parents[0];
  const std::size_t row = std::max<std::size_t>(layout.row, 1);
  const std::size_t rows = layout.size() / row;
  if (rows < 2) return child;
  const std::size_t cut = (1 + random.index(rows - 1)) * row;
  std::copy(parents[1].begin() + static_cast<std::ptrdiff_t>(cut), parents[1].end(),
            child.begin() + static_cast<std::ptrdiff_t>(cut));
  return child;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::MutationOperator, lacuna::OnePointCrossover>("one_point_crossover"))
