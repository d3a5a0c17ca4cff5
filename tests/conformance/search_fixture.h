#pragma once

#include "conformance/every_plugin.h"

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace lacuna {

using ScoreOf = std::function<double(const Genome&)>;

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
