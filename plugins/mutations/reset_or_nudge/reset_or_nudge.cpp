#include <lacuna/error.h>
#include <lacuna/mutation_operator.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// The mutation of the seed's experiment 2 (Eq. 2): one gene gets a new uniform value, or moves by ±range·10^−δ with δ
/// uniform in [`coarsest`, `finest`] decades. A move beyond a bound ends at it (`clip` = 1) or is reflected there (0).
class ResetOrNudge : public MutationOperator {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where the decades are in the wrong order, or `clip` is neither 0 nor 1.
  Genome vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
              RandomStream& random) const override;
};

namespace {

enum Parameter : std::size_t { kReset, kCoarsest, kFinest, kClip };

/// `value` reflected at the bound that it exceeds, by at most the width of the range.
double reflected(const Gene& gene, double value) {
  if (value > gene.upper) return 2.0 * gene.upper - value;
  return value < gene.lower ? 2.0 * gene.lower - value : value;
}

/// The gene moved by `move`, no more than its range, and kept within its bounds.
double nudged(const Gene& gene, double value, double move, bool clips) {
  const double moved = clips ? value + move : reflected(gene, value + move);
  const double within = std::clamp(moved, gene.lower, gene.upper);
  return gene.kind == GeneKind::integer ? std::round(within) : within;
}

}  // namespace

std::string ResetOrNudge::summary() const {
  return "Gives one gene a new uniform value or moves it by a step of random size";
}

ParameterDeclarations ResetOrNudge::parameters() const {
  return {
      {"reset", "1", 0.5, 0.0, 1.0, Scale::linear, "Probability of a new value; otherwise the gene moves"},
      {"coarsest", "1", 1.0, 0.0, 15.0, Scale::linear, "Decades below the gene's range, for the largest move"},
      {"finest", "1", 7.0, 0.0, 15.0, Scale::linear, "Decades below the gene's range, for the smallest move"},
      {"clip", "1", 1.0, 0.0, 1.0, Scale::linear, "Moves beyond a bound: 1: end at the bound; 0: are reflected there"}};
}

Genome ResetOrNudge::vary(std::span<const Genome> parents, const GenomeLayout& layout,
                          std::span<const double> parameters, RandomStream& random) const {
  if (parameters[kCoarsest] > parameters[kFinest])
    throw Error("coarsest must be at most finest: both count decades below the gene's range");
  if (parameters[kClip] != std::floor(parameters[kClip])) throw Error("clip must be 0 or 1");
  Genome child = parents.front();
  const std::size_t place = random.index(child.size());
  const Gene& gene = layout.genes[place];
  if (random.chance(parameters[kReset])) {
    child[place] = uniform_value(gene, random);
  } else {
    const double delta = random.uniform(parameters[kCoarsest], parameters[kFinest]);
    const double size = (gene.upper - gene.lower) * std::pow(10.0, -delta);
    child[place] = nudged(gene, child[place], random.chance(0.5) ? size : -size, parameters[kClip] == 1.0);
  }
  return child;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::MutationOperator, lacuna::ResetOrNudge>("reset_or_nudge"))
