#include "conformance/search_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>

/// What holds for every search.
namespace lacuna {
namespace {

constexpr double kInvalid = std::numeric_limits<double>::infinity();
constexpr double kNanOfSearch = std::numeric_limits<double>::quiet_NaN();

class SearchConformance : public testing::Test {
 protected:
  SearchTask task(std::uint64_t key = 1) const { return {layout_, breeder_, {key, 2, 3}, {}}; }
  double score(const Genome& genome) const { return distance(layout_, genome); }

  const GenomeLayout layout_ = layout_in_rows();
  const PlainBreeder breeder_{layout_};
  const ScoreOf score_ = [this](const Genome& genome) { return score(genome); };
  /// A third of all genomes cannot be evaluated.
  const ScoreOf often_invalid_ = [this](const Genome& genome) { return genome[0] > 5.0 ? kInvalid : score(genome); };
};

TEST_F(SearchConformance, AsksForGenomesOfTheLayoutAndNumbersThem) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    std::uint64_t next = 0;
    while (!search->finished()) {
      const std::vector<Individual> asked = search->ask();
      ASSERT_FALSE(asked.empty());
      EXPECT_EQ(search->ask(), asked) << "asking twice is asking once";
      for (const Individual& one : asked) {
        EXPECT_EQ(one.number, next++);
        EXPECT_TRUE(fits(layout_, one.genome));
        for (const std::uint64_t parent : one.parents) EXPECT_LT(parent, asked.front().number);
      }
      search->tell(scores_of(asked, score_));
    }
  });
}

/// A generation is asked at once or in parts; none is left out.
TEST_F(SearchConformance, EndsAfterItsGenerations) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    const int generations = search->generations();
    EXPECT_GT(generations, 0);
    int generation = 0;
    while (!search->finished()) {
      ASSERT_EQ(search->generation(), generation);
      ASSERT_LT(generation, generations);
      search->tell(scores_of(search->ask(), score_));
      if (search->generation() != generation) ++generation;
      ASSERT_EQ(search->generations(), generations);
    }
    EXPECT_EQ(search->generation(), generations);
    EXPECT_EQ(generation, generations);
  });
}

TEST_F(SearchConformance, RemembersTheBestOfAllItWasTold) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    EXPECT_TRUE(search->best().empty());
    double least = kInvalid;
    while (!search->finished()) {
      const std::vector<double> scores = scores_of(search->ask(), often_invalid_);
      search->tell(scores);
      least = std::min(least, *std::min_element(scores.begin(), scores.end()));
      const std::vector<ScoredIndividual> best = search->best();
      ASSERT_FALSE(best.empty());
      EXPECT_EQ(best.front().score, least);
      for (const ScoredIndividual& one : best) EXPECT_EQ(one.score, often_invalid_(one.individual.genome));
      EXPECT_TRUE(
          std::is_sorted(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.score < b.score; }));
    }
  });
}

/// At least half as far from the optimum as the best of the first generation.
TEST_F(SearchConformance, FindsBetterOnes) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    search->tell(scores_of(search->ask(), score_));
    const double first = search->best().front().score;
    run_to_end(*search, score_);
    EXPECT_LT(search->best().front().score, 0.5 * first);
  });
}

TEST_F(SearchConformance, GoesOnFromAnySavedStateWithTheSameDigits) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto whole = strategy.begin(task(), parameters);
    const std::vector<Generation> generations = run_to_end(*whole, often_invalid_);
    for (std::size_t start = 0; start < generations.size(); ++start) {
      const auto resumed = strategy.begin(task(), parameters);
      resumed->load(generations[start].state);
      EXPECT_EQ(resumed->generation(), generations[start].number);
      const std::vector<Generation> rest = run_to_end(*resumed, often_invalid_);
      ASSERT_EQ(rest.size(), generations.size() - start);
      for (std::size_t i = 0; i < rest.size(); ++i) ASSERT_EQ(rest[i].asked, generations[start + i].asked);
      ASSERT_EQ(resumed->save(), whole->save());
      EXPECT_EQ(resumed->best(), whole->best());
    }
  });
}

TEST_F(SearchConformance, ALoadedSearchForgetsWhatItWasAsked) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    const std::vector<double> start = search->save();
    const std::vector<Individual> first = search->ask();
    EXPECT_EQ(search->save(), start) << "the state is the one between two generations";
    search->tell(scores_of(first, score_));
    search->ask();
    search->load(start);
    EXPECT_EQ(search->ask(), first);
  });
}

TEST_F(SearchConformance, RefusesAStateOfAnotherLength) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    search->tell(scores_of(search->ask(), score_));
    std::vector<double> state = search->save();
    state.push_back(0.0);
    EXPECT_THROW(strategy.begin(task(), parameters)->load(state), Error);
    state.resize(state.size() - 2);
    EXPECT_THROW(strategy.begin(task(), parameters)->load(state), Error);
    EXPECT_THROW(strategy.begin(task(), parameters)->load({}), Error);
  });
}

TEST_F(SearchConformance, TheKeyDecidesTheSearch) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto first = [&](std::uint64_t key) { return strategy.begin(task(key), parameters)->ask(); };
    EXPECT_EQ(first(1), first(1));
    EXPECT_NE(first(1), first(2));
  });
}

/// So that a search that begins with the best known never ends with less.
TEST_F(SearchConformance, TriesTheFirstSeed) {
  constexpr double kRounding = 1e-12;  // of genes of order one that were scaled and scaled back
  RandomStream random = stream_of(99);
  SearchTask seeded = task();
  seeded.seeds = {uniform_genome(layout_, random)};
  const auto is_the_seed = [&](const Individual& one) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < one.genome.size(); ++i)
      farthest = std::max(farthest, std::abs(one.genome[i] - seeded.seeds[0][i]));
    return farthest < kRounding;
  };
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(seeded, parameters);
    const std::vector<Individual> first = search->ask();
    EXPECT_EQ(std::count_if(first.begin(), first.end(), is_the_seed), 1);
  });
}

TEST_F(SearchConformance, SurvivesGenerationsOfInvalidScores) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    for (int i = 0; i < 2 && !search->finished(); ++i)
      search->tell(std::vector<double>(search->ask().size(), i == 0 ? kInvalid : kNanOfSearch));
    for (const ScoredIndividual& one : search->best()) EXPECT_EQ(one.score, kInvalid);
    while (!search->finished()) {
      for (const Individual& one : search->ask()) ASSERT_TRUE(fits(layout_, one.genome));
      search->tell(scores_of(search->ask(), often_invalid_));
    }
    EXPECT_TRUE(std::isfinite(search->best().front().score));
  });
}

/// Whatever is told for an evaluation that was abandoned, the search goes on as if it had been completed.
TEST_F(SearchConformance, AbandonedEvaluationsChangeNothing) {
  constexpr double kLittle = 1e-12;
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto full = strategy.begin(task(), parameters), hasty = strategy.begin(task(), parameters);
    int abandoned = 0;
    bool has_bar = false;
    while (!full->finished()) {
      ASSERT_EQ(hasty->ask(), full->ask()) << "generation " << full->generation();
      const std::optional<double> bar = hasty->abandon_above();
      std::vector<double> scores = scores_of(full->ask(), score_);
      full->tell(scores);
      for (double& score : scores) {
        if (!bar || score <= *bar) continue;
        score = ++abandoned % 2 == 0 ? kInvalid : *bar + kLittle;
      }
      has_bar = has_bar || bar.has_value();
      hasty->tell(scores);
      ASSERT_EQ(hasty->best().front(), full->best().front());
    }
    EXPECT_EQ(hasty->save(), full->save());
    EXPECT_EQ(abandoned > 0, has_bar);
  });
}

TEST_F(SearchConformance, WantsAScoreForEachGenomeAsked) {
  on_every<SearchStrategy>([&](const SearchStrategy& strategy, const std::vector<double>& parameters) {
    const auto search = strategy.begin(task(), parameters);
    EXPECT_THROW(search->tell(std::vector<double>{1.0}), Error) << "nothing was asked";
    const std::vector<Individual> asked = search->ask();
    EXPECT_THROW(search->tell(std::vector<double>(asked.size() + 1, 1.0)), Error);
    EXPECT_EQ(search->ask(), asked);
    EXPECT_NO_THROW(search->tell(std::vector<double>(asked.size(), 1.0)));
  });
}

}  // namespace
}  // namespace lacuna
