#include "documents/search_state_json.h"

#include <gtest/gtest.h>

#include <limits>

namespace lacuna {
namespace {

EffectEntry friction_entry() {
  return {"friction", "coulomb_friction", {"joint.hinge"}, {{"torque", 0.1}}, {"shape"}, {{"torque", {0.0, 0.2}}}};
}

/// Every field filled; figures that no short text has.
SearchState state() {
  SearchState state;
  state.added = {friction_entry()};
  state.values = {1.0 / 3.0, 2e-17};
  KeptRival rival{friction_entry(), {0.3}, {11.0, 1.5, 8.0, 14.0 / 3.0}};
  state.last = SearchStep{{}, {rival, rival}, 1};
  state.tried = {{}, {"coulomb_friction @ joint.hinge"}, {"a @ world", "b @ joint.hinge"}};
  state.gains[{"coulomb_friction @ joint.hinge"}] = {11.0, 1.5, 8.0, 14.0};
  state.enough[{"coulomb_friction @ joint.hinge"}] = "coulomb_friction @ joint.hinge alone gains 97 %";
  state.base_values = {0.25};
  state.law_leads = true;
  RankedModel model;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  model.effects = {{"coulomb_friction", "joint.hinge", {{"torque", "N*m", 0.1, unknown, unknown}}}};
  model.look_alikes = {"viscous_friction @ joint.hinge"};
  state.so_far.base = model.errors = {{"angle", "rad", 1e-3, 2e-3, 3e-3}};
  state.so_far.ranking = {model};
  state.so_far.formulas = {{"hinge", "N*m", {{"v", "rad/s", 0.1, 0.01}}, {5.0, 1.0, 3.0, 7.0}, {}}};
  return state;
}

TEST(SearchStateJson, IsReadDigitForDigit) {
  const std::string written = search_state_json(state());
  const std::optional<SearchState> read = read_search_state(written);
  ASSERT_TRUE(read);
  EXPECT_EQ(search_state_json(*read), written);
  EXPECT_EQ(read->values, state().values);
  EXPECT_EQ(read->tried, state().tried);
  ASSERT_TRUE(read->last);
  EXPECT_EQ(read->last->chosen, 1U);
  EXPECT_EQ(read->last->rivals.front().entry.range, friction_entry().range);
  EXPECT_TRUE(read->law_leads);
  EXPECT_EQ(read->enough, state().enough);
}

/// A model that does with fewer effects is ranked before its errors are told.
TEST(SearchStateJson, MayRankAModelWithoutErrors) {
  SearchState early = state();
  early.so_far.ranking.front().errors.clear();
  const std::optional<SearchState> read = read_search_state(search_state_json(early));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->so_far.ranking.front().errors.empty());
  EXPECT_EQ(read->so_far.base.size(), 1U);
}

TEST(SearchStateJson, MayHaveNoChoiceToTakeBack) {
  SearchState without = state();
  without.last.reset();
  const std::optional<SearchState> read = read_search_state(search_state_json(without));
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->last);
}

TEST(SearchStateJson, OfAnotherFormatOrWithoutAFigureIsNotGoneOnFrom) {
  EXPECT_FALSE(read_search_state(R"({"format": 0})"));
  SearchState broken = state();
  broken.values.front() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(read_search_state(search_state_json(broken)));
}

}  // namespace
}  // namespace lacuna
