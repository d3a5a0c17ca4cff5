#include "niched_evolution.h"

#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/generational_search.h>
#include <lacuna/plugin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kNiches, kMembers, kLeft, kEvery, kGenerations, kPull, kCrossover };

constexpr std::size_t kFewestMembers = 4;
constexpr double kLeastWeight = 0.4, kMostWeight = 0.9;  // of a difference: drawn anew for each challenger

struct Settings {
  std::size_t niches, members, left, every, generations;
  double pull, crossover;
};

/// `kept()` holds the niches one after the other, `members` each. Their whole-number genes say which they are, so that
/// nothing else is to be remembered.
class NichedEvolutionSearch : public GenerationalSearch {
 public:
  NichedEvolutionSearch(const SearchTask& task, const Settings& settings)
      : GenerationalSearch(task, settings.generations), settings_(settings) {}

  /// A challenger above the worst of all is above its own target, too.
  std::optional<double> abandon_above() const override {
    if (kept().empty()) return std::nullopt;
    const double worst = std::max_element(kept().begin(), kept().end(), better)->score;
    return std::isinf(worst) ? std::nullopt : std::optional(worst);
  }

 private:
  std::vector<Individual> do_ask() override {
    std::vector<Individual> asked;
    if (generation() == 0) {
      const std::vector<Genome> founders = first_founders();
      for (std::size_t i = 0; i < settings_.niches * settings_.members; ++i)
        asked.push_back({0, first_member(founders[i / settings_.members], i), {}});
      return asked;
    }
    for (std::size_t i = 0; i < kept().size(); ++i) asked.push_back(challenger(i));
    return asked;
  }

  void do_tell(std::vector<ScoredIndividual> told) override {
    if (generation() == 0) {
      kept() = std::move(told);
      return;
    }
    for (std::size_t i = 0; i < told.size(); ++i)
      if (told[i].score <= kept()[i].score) kept()[i] = std::move(told[i]);
    if ((generation() + 1) % static_cast<int>(settings_.every) == 0) give_up_half();
  }

  bool is_whole(std::size_t gene) const { return task().layout.genes[gene].kind == GeneKind::integer; }

  std::vector<double> structure_of(const Genome& genome) const {
    std::vector<double> structure;
    for (std::size_t i = 0; i < genome.size(); ++i)
      if (is_whole(i)) structure.push_back(genome[i]);
    return structure;
  }

  /// The seeds, then random ones, of structures that differ as far as a few draws find such.
  std::vector<Genome> first_founders() const {
    constexpr std::size_t kDraws = 20;
    std::vector<Genome> founders;
    std::set<std::vector<double>> taken;
    for (std::size_t niche = 0; niche < settings_.niches; ++niche) {
      RandomStream random = stream(settings_.niches * settings_.members + niche);
      Genome founder = niche < task().seeds.size() ? task().seeds[niche] : task().breeder.random(random);
      for (std::size_t draw = 1; draw < kDraws && taken.contains(structure_of(founder)); ++draw)
        founder = task().breeder.random(random);
      taken.insert(structure_of(founder));
      founders.push_back(std::move(founder));
    }
    return founders;
  }

  /// The founder itself, then others of its structure.
  Genome first_member(const Genome& founder, std::size_t index) const {
    if (index % settings_.members == 0) return founder;
    RandomStream random = stream(index);
    Genome member = task().breeder.random(random);
    for (std::size_t i = 0; i < member.size(); ++i)
      if (is_whole(i)) member[i] = founder[i];
    return member;
  }

  /// Two others of the niche, neither the target.
  std::array<std::size_t, 2> partners(std::size_t target, RandomStream& random) const {
    const std::size_t begin = target - target % settings_.members;
    std::array<std::size_t, 2> chosen{target, target};
    while (chosen[0] == target) chosen[0] = begin + random.index(settings_.members);
    while (chosen[1] == target || chosen[1] == chosen[0]) chosen[1] = begin + random.index(settings_.members);
    return chosen;
  }

  std::size_t best_of_niche(std::size_t target) const {
    const auto begin = kept().begin() + static_cast<std::ptrdiff_t>(target - target % settings_.members);
    return static_cast<std::size_t>(
        std::min_element(begin, begin + static_cast<std::ptrdiff_t>(settings_.members), better) - kept().begin());
  }

  /// current-to-best/1/bin: towards the niche's best, and along a difference of two others.
  Individual challenger(std::size_t target) const {
    RandomStream random = stream(target);
    const std::size_t best = best_of_niche(target);
    const std::array<std::size_t, 2> partner = partners(target, random);
    const double weight = random.uniform(kLeastWeight, kMostWeight);
    const auto genome = [&](std::size_t index) -> const Genome& { return kept()[index].individual.genome; };
    Genome child = genome(target);
    const std::size_t certain = random.index(child.size());
    for (std::size_t i = 0; i < child.size(); ++i) {
      const bool crosses = random.chance(settings_.crossover) || i == certain;
      if (is_whole(i) || !crosses) continue;
      const Gene& gene = task().layout.genes[i];
      const double moved = child[i] + settings_.pull * weight * (genome(best)[i] - child[i]) +
                           weight * (genome(partner[0])[i] - genome(partner[1])[i]);
      child[i] = std::clamp(moved, gene.lower, gene.upper);  // the best may lie on a bound
    }
    const auto number = [&](std::size_t index) { return kept()[index].individual.number; };
    return {0, std::move(child), {number(target), number(best)}};
  }

  void give_up_half() {
    const std::size_t niches = kept().size() / settings_.members;
    const std::size_t left = std::max(settings_.left, (niches + 1) / 2);
    if (left >= niches) return;
    std::vector<std::size_t> bests;
    for (std::size_t niche = 0; niche < niches; ++niche) bests.push_back(best_of_niche(niche * settings_.members));
    std::sort(bests.begin(), bests.end(), [&](std::size_t a, std::size_t b) { return better(kept()[a], kept()[b]); });
    std::vector<ScoredIndividual> survivors;
    for (std::size_t i = 0; i < left; ++i) {
      const auto begin = kept().begin() + static_cast<std::ptrdiff_t>(bests[i] - bests[i] % settings_.members);
      std::move(begin, begin + static_cast<std::ptrdiff_t>(settings_.members), std::back_inserter(survivors));
    }
    kept() = std::move(survivors);
  }

  Settings settings_;
};

}  // namespace

std::string NichedEvolution::summary() const {
  return "Differential evolution inside each structure (whole-number genes); the worse structures give up";
}

ParameterDeclarations NichedEvolution::parameters() const {
  return {{"niches", "1", 16.0, 1.0, 1e6, Scale::linear, "Structures to begin with"},
          {"members", "1", 16.0, 4.0, 1e6, Scale::linear, "Individuals of each structure"},
          {"left", "1", 2.0, 1.0, 1e6, Scale::linear, "Structures that are never given up"},
          {"every", "1", 6.0, 1.0, 1e6, Scale::linear, "Generations until the worse half of the structures gives up"},
          {"generations", "1", 80.0, 1.0, 1e6, Scale::linear, "Generations, the random one included"},
          {"pull", "1", 0.5, 0.0, 2.0, Scale::linear,
           "How much of the way towards the niche's best a challenger goes, over that along a difference"},
          {"crossover", "1", 0.9, 0.0, 1.0, Scale::linear, "CR, the probability that a gene comes from the mutant"}};
}

std::unique_ptr<Search> NichedEvolution::begin(const SearchTask& task, std::span<const double> parameters) const {
  const ParameterDeclarations declared = this->parameters();
  const auto count = [&](Parameter which) { return count_parameter(declared[which], parameters[which]); };
  const Settings settings{count(kNiches),      count(kMembers),   count(kLeft),          count(kEvery),
                          count(kGenerations), parameters[kPull], parameters[kCrossover]};
  if (settings.members < kFewestMembers) throw Error("a niche needs at least 4 members");
  if (settings.left > settings.niches) throw Error("left is to be at most niches: it says how many of them stay");
  return std::make_unique<NichedEvolutionSearch>(task, settings);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::SearchStrategy, lacuna::NichedEvolution>("niched_evolution"))
