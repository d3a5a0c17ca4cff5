#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/generational_search.h>
#include <lacuna/plugin.h>
#include <lacuna/search_strategy.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {

/// Differential evolution, rand/1/bin (Storn and Price, 1997): each individual is challenged by a mix of itself with
/// another one that is moved along the difference of two more. Makes its own children: the breeder only draws the first
/// generation.
class DifferentialEvolution : public SearchStrategy {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a population below 4.
  std::unique_ptr<Search> begin(const SearchTask& task, std::span<const double> parameters) const override;
};

namespace {

enum Parameter : std::size_t { kPopulation, kGenerations, kWeight, kCrossover };

struct Settings {
  std::size_t population;
  std::size_t generations;
  double weight;
  double crossover;
};

class DifferentialEvolutionSearch : public GenerationalSearch {
 public:
  DifferentialEvolutionSearch(const SearchTask& task, const Settings& settings)
      : GenerationalSearch(task, settings.generations), settings_(settings) {}

  /// A challenger with a score above the worst of all is also above its own target.
  std::optional<double> abandon_above() const override {
    if (kept().empty()) return std::nullopt;
    const double worst = std::max_element(kept().begin(), kept().end(), better)->score;
    return std::isinf(worst) ? std::nullopt : std::optional(worst);
  }

 private:
  std::vector<Individual> do_ask() override {
    std::vector<Individual> challengers;
    for (std::size_t i = 0; i < settings_.population; ++i)
      challengers.push_back(generation() == 0 ? Individual{0, first_genome(i), {}} : challenger(i));
    return challengers;
  }

  void do_tell(std::vector<ScoredIndividual> told) override {
    if (generation() == 0) {
      kept() = std::move(told);
      return;
    }
    for (std::size_t i = 0; i < told.size(); ++i)
      if (told[i].score <= kept()[i].score) kept()[i] = std::move(told[i]);
  }

  /// Base and the two whose difference moves it: all different, and not the target.
  std::array<std::size_t, 3> partners(std::size_t target, RandomStream& random) const {
    std::array<std::size_t, 3> chosen{target, target, target};
    for (std::size_t k = 0; k < chosen.size();) {
      const std::size_t candidate = random.index(settings_.population);
      const auto taken = chosen.begin() + static_cast<std::ptrdiff_t>(k);
      if (candidate != target && std::find(chosen.begin(), taken, candidate) == taken) chosen[k++] = candidate;
    }
    return chosen;
  }

  Individual challenger(std::size_t target) const {
    RandomStream random = stream(target);
    const std::array<std::size_t, 3> partner = partners(target, random);
    const auto genome = [&](std::size_t index) -> const Genome& { return kept()[index].individual.genome; };
    Genome child = genome(target);
    const std::size_t row = std::max<std::size_t>(task().layout.row, 1);  // crosses over as a whole
    const std::size_t certain = random.index(child.size() / row);
    bool crosses = false;
    for (std::size_t i = 0; i < child.size(); ++i) {
      if (i % row == 0) crosses = random.chance(settings_.crossover) || i / row == certain;
      const double step = settings_.weight * (genome(partner[1])[i] - genome(partner[2])[i]);
      if (crosses) child[i] = reflected_value(task().layout.genes[i], genome(partner[0])[i] + step);
    }
    const auto number = [&](std::size_t index) { return kept()[index].individual.number; };
    return {0, std::move(child), {number(target), number(partner[0])}};
  }

  Settings settings_;
};

}  // namespace

std::string DifferentialEvolution::summary() const {
  return "Differential evolution, rand/1/bin: moves individuals along differences of others";
}

ParameterDeclarations DifferentialEvolution::parameters() const {
  return {{"population", "1", 50.0, 4.0, 1e6, Scale::linear, "Individuals, and evaluations per generation"},
          {"generations", "1", 30.0, 1.0, 1e6, Scale::linear, "Generations, including the random one"},
          {"weight", "1", 0.5, 0.0, 2.0, Scale::linear, "F, the share of a difference that is added"},
          {"crossover", "1", 0.9, 0.0, 1.0, Scale::linear, "CR, the probability that a gene comes from the mutant"}};
}

std::unique_ptr<Search> DifferentialEvolution::begin(const SearchTask& task, std::span<const double> parameters) const {
  const ParameterDeclarations declared = this->parameters();
  const Settings settings{count_parameter(declared[kPopulation], parameters[kPopulation]),
                          count_parameter(declared[kGenerations], parameters[kGenerations]), parameters[kWeight],
                          parameters[kCrossover]};
  if (settings.population < 4) throw Error("differential evolution needs a population of at least 4");
  return std::make_unique<DifferentialEvolutionSearch>(task, settings);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::SearchStrategy, lacuna::DifferentialEvolution>("differential_evolution"))
