#pragma once

#include "conformance/every_plugin.h"

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace lacuna {

/// Breeds as an experiment would: now and then a crossover, always one gene anew.
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

using ScoreOf = std::function<double(const Genome&)>;

/// Squared distance from a genome of the layout, each gene in its range, some counting more than others; 0 at best.
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

inline std::vector<double> scores_of(const std::vector<Individual>& individuals, const ScoreOf& score) {
  std::vector<double> scores;
  scores.reserve(individuals.size());
  for (const Individual& one : individuals) scores.push_back(score(one.genome));
  return scores;
}

/// What a search asked for in one generation, or a part of it, and the state before it.
struct Generation {
  int number = 0;
  std::vector<double> state;
  std::vector<Individual> asked;
};

inline bool operator==(const Individual& a, const Individual& b) {
  return a.number == b.number && a.genome == b.genome && a.parents == b.parents;
}
inline bool operator==(const ScoredIndividual& a, const ScoredIndividual& b) {
  return a.individual == b.individual && a.score == b.score;
}

/// Runs a search to its end.
inline std::vector<Generation> run_to_end(Search& search, const ScoreOf& score) {
  std::vector<Generation> generations;
  while (!search.finished()) {
    generations.push_back({search.generation(), search.save(), search.ask()});
    search.tell(scores_of(generations.back().asked, score));
  }
  return generations;
}

}  // namespace lacuna
