#pragma once

#include "plugins/built_catalog.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Textbook problems of ten genes in [0, 1], whose optimum is 0.
inline constexpr std::size_t kProblemGenes = 10;

/// Where the optimum is: somewhere inside, each gene somewhere else.
inline double optimum_of(std::size_t gene) { return 0.35 + 0.03 * static_cast<double>(gene); }

using Objective = std::function<double(std::span<const double>)>;

inline double sphere(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += 100.0 * std::pow(x[i] - optimum_of(i), 2);
  return sum;
}

/// Some axes a thousand times as long as others.
inline double ellipsoid(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += std::pow(1e6, static_cast<double>(i) / static_cast<double>(x.size() - 1)) * 100.0 *
           std::pow(x[i] - optimum_of(i), 2);
  return sum;
}

/// The same, mirrored across a slanted plane, so that no gene lies along an axis.
inline double turned_ellipsoid(std::span<const double> x) {
  const auto normal = [](std::size_t i) { return 1.0 + static_cast<double>(i % 3); };
  double along = 0.0, length = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    along += normal(i) * (x[i] - optimum_of(i));
    length += normal(i) * normal(i);
  }
  std::vector<double> mirrored;
  for (std::size_t i = 0; i < x.size(); ++i) mirrored.push_back(x[i] - 2.0 * normal(i) * along / length);
  return ellipsoid(mirrored);
}

/// Rosenbrock's curved valley in [-2, 2].
inline double rosenbrock(std::span<const double> x) {
  const auto y = [&](std::size_t i) { return 4.0 * x[i] - 2.0; };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    sum += 100.0 * std::pow(y(i + 1) - y(i) * y(i), 2) + std::pow(1.0 - y(i), 2);
  return sum;
}

inline GenomeLayout problem_layout() {
  GenomeLayout layout;
  for (std::size_t i = 0; i < kProblemGenes; ++i)
    layout.genes.push_back({"x" + std::to_string(i), "1", GeneKind::real, 0.0, 1.0});
  return layout;
}

/// For searches that make their own children.
class RandomBreeder : public Breeder {
 public:
  explicit RandomBreeder(const GenomeLayout& layout) : layout_(layout) {}
  Genome random(RandomStream& random) const override { return uniform_genome(layout_, random); }
  Genome child(std::span<const Genome>, RandomStream&, std::vector<std::size_t>&) const override {
    throw Error("this search makes its own children");
  }

 private:
  const GenomeLayout& layout_;
};

/// Evaluations until a search has found a score of at most `target`; infinite where it ends before.
inline double evaluations_to(double target, Search& search, const Objective& objective) {
  double evaluations = 0.0;
  while (!search.finished()) {
    std::vector<double> scores;
    for (const Individual& one : search.ask()) {
      scores.push_back(objective(one.genome));
      ++evaluations;
      if (scores.back() <= target) return evaluations;
    }
    search.tell(scores);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace lacuna
