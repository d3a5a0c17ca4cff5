#include "evolution/search_run.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Asks for 0, then 1, then 2; the bar is the generation.
class Counting : public Search {
 public:
  bool finished() const override { return told.size() == 3; }
  const std::vector<Individual>& ask() override {
    asked_ = {{told.size(), {static_cast<double>(told.size())}, {}}};
    return asked_;
  }
  std::optional<double> abandon_above() const override { return static_cast<double>(told.size()); }
  void tell(std::span<const double> scores) override {
    if (fails && told.size() == 1) throw Error("has lost count");
    told.push_back(scores[0]);
  }
  std::vector<ScoredIndividual> best() const override { return {}; }
  int generation() const override { return static_cast<int>(told.size()); }
  int generations() const override { return 3; }
  std::vector<double> save() const override { return told; }
  void load(std::span<const double> state) override { told.assign(state.begin(), state.end()); }

  std::vector<double> told;
  bool fails = false;

 private:
  std::vector<Individual> asked_;
};

const ComponentOrigin kOrigin{"search", "counting", "counting.so"};

TEST(SearchRun, AsksAndTellsUntilTheSearchIsFinished) {
  Counting search;
  std::vector<double> bars;
  int generations = 0;
  run_search(
      search, kOrigin,
      [&](const std::vector<Individual>& individuals, std::optional<double> bar) {
        bars.push_back(*bar);
        return std::vector<double>{individuals[0].genome[0] * 10.0};
      },
      [&] { ++generations; });
  EXPECT_THAT(search.told, ElementsAre(0.0, 10.0, 20.0));
  EXPECT_THAT(bars, ElementsAre(0.0, 1.0, 2.0));
  EXPECT_EQ(generations, 3);
}

TEST(SearchRun, GoesOnWhereItWasEnded) {
  Counting search;
  const auto score = [](const std::vector<Individual>& individuals, std::optional<double>) {
    return std::vector<double>{individuals[0].genome[0]};
  };
  EXPECT_THROW(run_search(search, kOrigin, score, [] { throw Interrupted("Ctrl-C"); }), Interrupted);
  EXPECT_THAT(search.told, ElementsAre(0.0));
  run_search(search, kOrigin, score, [] {});
  EXPECT_THAT(search.told, ElementsAre(0.0, 1.0, 2.0));
}

TEST(SearchRun, NamesASearchThatThrows) {
  Counting search;
  search.fails = true;
  const auto score = [](const std::vector<Individual>&, std::optional<double>) { return std::vector<double>{0.0}; };
  EXPECT_THAT([&] { run_search(search, kOrigin, score, [] {}); },
              ThrowsMessage<Error>(AllOf(HasSubstr("counting.so"), HasSubstr("has lost count"))));
}

}  // namespace
}  // namespace lacuna
