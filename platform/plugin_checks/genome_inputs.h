#pragma once

#include <lacuna/genome.h>
#include <lacuna/search_strategy.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// Genomes, layouts and a breeder to try encodings, mutations and searches, here and in the conformance tests.

/// A stream of one number as its key.
inline RandomStream stream_of(std::uint64_t key) { return RandomStream(std::vector<std::uint64_t>{key}); }

/// The fault of a genome against the layout: one value per gene, within its bounds, whole where required. Empty: none.
inline std::string genome_fault(const GenomeLayout& layout, const Genome& genome) {
  if (genome.size() != layout.size())
    return std::to_string(genome.size()) + " values for " + std::to_string(layout.size()) + " genes";
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const Gene& gene = layout.genes[i];
    const std::string value = gene.name + " = " + std::to_string(genome[i]);
    if (!(genome[i] >= gene.lower && genome[i] <= gene.upper)) return value + " is beyond its bounds";
    if (gene.kind == GeneKind::integer && genome[i] != std::floor(genome[i])) return value + " is not a whole number";
  }
  return {};
}

/// Real and whole-number genes of different ranges, one of them with a single value.
inline GenomeLayout mixed_layout() {
  GenomeLayout layout;
  layout.genes = {{"mass", "kg", GeneKind::real, 1.0, 7.0},     {"delay", "s", GeneKind::real, 0.0, 0.2},
                  {"parent", "1", GeneKind::integer, 0.0, 3.0}, {"offset", "rad", GeneKind::real, -2.0, 2.0},
                  {"teeth", "1", GeneKind::integer, -5, 20.0},  {"fixed", "m", GeneKind::real, 0.3, 0.3},
                  {"gain", "1", GeneKind::real, 0.5, 1.5},      {"kind", "1", GeneKind::integer, 0.0, 1.0}};
  return layout;
}

/// The same genes in rows of two.
inline GenomeLayout layout_in_rows() {
  GenomeLayout layout = mixed_layout();
  layout.row = 2;
  return layout;
}

/// Five rows of a length and five genes from 0 to 1, for operators made for robots' shapes.
inline GenomeLayout shape_layout() {
  GenomeLayout layout;
  for (int i = 0; i < 30; ++i) layout.genes.push_back({"gene" + std::to_string(i), "1", GeneKind::real, 0.0, 1.0});
  for (std::size_t i = 2; i < 30; i += 6) layout.genes[i] = {layout.genes[i].name, "m", GeneKind::real, 0.1, 2.0};
  layout.row = 6;
  return layout;
}

/// Breeds like an experiment: sometimes a crossover, always one new gene.
class PlainBreeder : public Breeder {
 public:
  explicit PlainBreeder(const GenomeLayout& layout) : layout_(layout) {}

  Genome random(RandomStream& random) const override { return uniform_genome(layout_, random); }

  Genome child(std::span<const Genome> parents, RandomStream& random, std::vector<std::size_t>& used) const override {
    used = {random.index(parents.size())};
    Genome child = parents[used[0]];
    if (random.chance(0.25)) {
      used.push_back(random.index(parents.size()));
      for (std::size_t i = child.size() / 2; i < child.size(); ++i) child[i] = parents[used[1]][i];
    }
    const std::size_t gene = random.index(child.size());
    child[gene] = uniform_value(layout_.genes[gene], random);
    return child;
  }

 private:
  const GenomeLayout& layout_;
};

/// Squared distance from a genome of the layout, each gene relative to its range, with different weights; 0 at best.
inline double distance(const GenomeLayout& layout, const Genome& genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const Gene& gene = layout.genes[i];
    const double range = gene.upper - gene.lower;
    if (range == 0.0) continue;
    const double optimum = gene.lower + 0.3 * range;
    const double offset = (genome[i] - (gene.kind == GeneKind::integer ? std::round(optimum) : optimum)) / range;
    sum += offset * offset * (1.0 + static_cast<double>(i));
  }
  return sum;
}

}  // namespace lacuna
