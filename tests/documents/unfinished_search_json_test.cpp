#include "documents/unfinished_search_json.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

UnfinishedSearch small_search() {
  UnfinishedSearch search;
  search.fits["coulomb_friction @ joint.hinge"] = {{0.1, 1.0 / 3.0}, {0.2, 5e-324}, {Eigen::Vector2d(1.5, -2.5), {}}};
  search.fits["cogging @ joint.hinge"] = {};  // no fit of it was valid
  return search;
}

TEST(UnfinishedSearchJson, IsReadBackDigitForDigit) {
  const std::optional<UnfinishedSearch> read = read_unfinished_search(unfinished_search_json(small_search()));
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->likelihoods);
  ASSERT_EQ(read->fits.size(), 2U);
  const std::string name = "coulomb_friction @ joint.hinge";
  const KeptFit fit = read->fits.at(name), wanted = small_search().fits.at(name);
  EXPECT_EQ(fit.rough, wanted.rough);
  EXPECT_EQ(fit.values, wanted.values);
  ASSERT_EQ(fit.states.size(), 2U);
  EXPECT_EQ(fit.states[0], wanted.states[0]);
  EXPECT_EQ(fit.states[1].size(), 0);
  EXPECT_TRUE(read->fits.at("cogging @ joint.hinge").rough.empty());
}

TEST(UnfinishedSearchJson, OfAnotherVersionIsNone) {
  EXPECT_FALSE(read_unfinished_search("{}"));
  EXPECT_FALSE(read_unfinished_search("not JSON"));
  EXPECT_FALSE(read_unfinished_search(R"({"format": 5, "added": [], "so_far": {}})"));
  EXPECT_FALSE(read_unfinished_search(R"({"format": 1, "fits": {"a": {"rough": [null]}}, "likelihoods": null})"));
}

TEST(UnfinishedSearchJson, ThatNestsTooDeepIsNone) {
  const std::string deep = std::string(80'000, '[') + std::string(80'000, ']');
  EXPECT_FALSE(read_unfinished_search(R"({"format": 1, "fits": {}, "likelihoods": )" + deep + "}"));
}

}  // namespace
}  // namespace lacuna
