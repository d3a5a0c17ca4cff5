#include "search/nesting.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

SearchResult fitted(const std::vector<std::pair<std::set<std::string>, double>>& sets) {
  SearchResult result;
  for (const auto& [members, cost] : sets) {
    FittedModel& set = result.sets.emplace_back();
    set.judged.members = members;
    set.fit.cost = cost;
  }
  return result;
}

/// {a, b} holds {}, {a} and {b}; {a} and {b} hold {}.
TEST(CountNesting, CountsEveryPairOfASetAndItsPart) {
  SearchResult result = fitted({{{}, 3.0}, {{"a"}, 2.0}, {{"b"}, 2.5}, {{"a", "b"}, 1.0}});
  count_nesting(result);
  EXPECT_EQ(result.nested, 5);
  EXPECT_EQ(result.unnested, 0);
}

TEST(CountNesting, CountsTheSetsThatCostMoreThanTheirPart) {
  SearchResult result = fitted({{{}, 3.0}, {{"a"}, 2.0}, {{"b"}, 1.0}, {{"a", "b"}, 1.5}});
  count_nesting(result);
  EXPECT_EQ(result.unnested, 1) << "{a, b} costs more than {b}";
}

/// A thousandth of a nat is the precision of a fit.
TEST(CountNesting, AllowsWhatAFitMayBeOff) {
  SearchResult result = fitted({{{}, 3.0}, {{"a"}, 3.0 + 0.5 * kNested}});
  count_nesting(result);
  EXPECT_EQ(result.nested, 1);
  EXPECT_EQ(result.unnested, 0);
  result.sets[1].fit.cost = 3.0 + 2.0 * kNested;
  count_nesting(result);
  EXPECT_EQ(result.nested, 1) << "counted anew";
  EXPECT_EQ(result.unnested, 1);
}

TEST(CountNesting, CountsNoPairOfSetsThatOnlyShareAMember) {
  SearchResult result = fitted({{{"a", "b"}, 1.0}, {{"b", "c"}, 2.0}, {{"d"}, 3.0}});
  count_nesting(result);
  EXPECT_EQ(result.nested, 0);
}

}  // namespace
}  // namespace lacuna
