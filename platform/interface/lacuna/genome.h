#pragma once

#include <lacuna/random_stream.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace lacuna {

enum class GeneKind {
  real,     ///< any number within the bounds
  integer,  ///< a whole number within the bounds
};

/// The allowed values of one number of a genome.
struct Gene {
  std::string name;  ///< an address such as "body.torso.mass", or a name from the encoding
  std::string unit;  ///< "1" for no unit
  GeneKind kind = GeneKind::real;
  double lower = 0.0;
  double upper = 1.0;
};

/// The genes of every genome of one encoding. Mutations and searches know only this, not the meaning of a genome.
struct GenomeLayout {
  std::vector<Gene> genes;
  /// Genes that belong together, such as those of one body part: `row` genes each; 0: no rows. A crossover does not
  /// cut inside a row.
  std::size_t row = 0;

  std::size_t size() const { return genes.size(); }
};

/// One value per gene, in the layout's order.
using Genome = std::vector<double>;

/// Uniformly distributed within a gene's bounds; a whole number for a whole-number gene.
inline double uniform_value(const Gene& gene, RandomStream& random) {
  if (gene.kind == GeneKind::real) return random.uniform(gene.lower, gene.upper);
  return gene.lower + static_cast<double>(random.index(static_cast<std::size_t>(gene.upper - gene.lower) + 1));
}

/// A value that may have left a gene's bounds, brought back: reflected at the bounds as often as needed, then rounded
/// for a whole-number gene. NaN stays NaN.
inline double reflected_value(const Gene& gene, double value) {
  const double range = gene.upper - gene.lower;
  if (!(range > 0.0)) return gene.lower;
  double beyond = std::fmod(value - gene.lower, 2.0 * range);
  if (beyond < 0.0) beyond += 2.0 * range;
  if (beyond > range) beyond = 2.0 * range - beyond;
  const double inside = std::clamp(gene.lower + beyond, gene.lower, gene.upper);
  return gene.kind == GeneKind::integer ? std::round(inside) : inside;
}

inline Genome uniform_genome(const GenomeLayout& layout, RandomStream& random) {
  Genome genome;
  for (const Gene& gene : layout.genes) genome.push_back(uniform_value(gene, random));
  return genome;
}

}  // namespace lacuna
