#include "answer/evidence.h"

#include "answer/found_pendulum.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Eigen::Index kBlocksOfTime = 12;

/// A set that gains `nats` over the model as it is, evenly over time but for a scatter of `uneven` from block to block.
FittedModel set_of(std::set<std::string> members, double nats, double uneven = 0.0) {
  FittedModel set;
  set.judged.members = std::move(members);
  set.judged.cost.by_length.resize(2, kBlocksOfTime);
  for (Eigen::Index block = 0; block < kBlocksOfTime; ++block)
    set.judged.cost.by_length.col(block).setConstant((3.0 - nats) / (2.0 * kBlocksOfTime) +
                                                     (block % 2 == 0 ? uneven : -uneven));
  set.judged.cost.cost = set.judged.cost.by_length.sum();
  return set;
}

/// A search of hand-made sets, the model as it is first, of which the second is the answer.
SearchResult found_of(std::vector<FittedModel> others, std::vector<std::size_t> alike = {}) {
  SearchResult found;
  found.sets = std::move(others);
  found.sets.insert(found.sets.begin(), set_of({}, 0.0));
  found.layout.folds = 3;
  for (std::size_t block = 0; block < kBlocksOfTime; ++block) found.layout.fold_of_block.push_back(block / 4);
  found.decision.answer = 1;
  found.decision.alike = std::move(alike);
  found.decision.p = 0.01;
  found.decision.gain = gain_of(found.sets[1].judged, found.sets[0].judged);
  found.decision.whole_gain = found.decision.gain.nats;
  return found;
}

TEST(LookAlikes, AreTheEffectsOfTheSetsThatDoAsWellWithoutTheAnswersOwn) {
  const SearchResult found = found_of(
      {set_of({"a", "b"}, 1.0), set_of({"a", "drag"}, 1.0), set_of({"spring", "b"}, 1.0), set_of({"other"}, 0.5)},
      {2, 3});
  EXPECT_THAT(look_alikes_of(found), ElementsAre("drag", "spring"));
}

TEST(LookAlikes, AreNoneWhereNoSetIsAlike) {
  EXPECT_THAT(look_alikes_of(found_of({set_of({"a"}, 1.0), set_of({"b"}, 0.9)})), IsEmpty());
}

TEST(NearestOther, IsTheClosestSetThatSaysAnotherThing) {
  const SearchResult found = found_of({set_of({"a"}, 1.0), set_of({"far"}, 0.2, 0.02), set_of({"near"}, 0.9, 0.02)});
  const OtherSet other = nearest_other(found);
  ASSERT_EQ(other.set, &found.sets[3]);
  const CostGain gain = gain_of(found.sets[1].judged, found.sets[3].judged);
  EXPECT_NEAR(gain.nats, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(other.lead, gain.nats / gain.error);
}

/// What holds the answer, or what cannot be told from it, says the same.
TEST(NearestOther, IsNoneThatHoldsTheAnswerOrOneAlike) {
  const SearchResult found = found_of({set_of({"a"}, 1.0), set_of({"alike"}, 1.0, 0.01), set_of({"a", "c"}, 1.0, 0.01),
                                       set_of({"alike", "c"}, 1.0, 0.01), set_of({"b"}, 0.8, 0.02)},
                                      {2});
  EXPECT_EQ(nearest_other(found).set, &found.sets[5]);
}

TEST(NearestOther, IsTheModelAsItIsWhereNothingElseWasFitted) {
  const SearchResult found = found_of({set_of({"a"}, 1.0)});
  EXPECT_EQ(nearest_other(found).set, &found.sets[0]);
  EXPECT_EQ(nearest_other(found).lead, 10.0) << "no scatter: as sure as a lead may be";
}

TEST(NearestOther, IsBehindByLessThanNothingWhereItGainsMore) {
  EXPECT_LT(nearest_other(found_of({set_of({"a"}, 1.0), set_of({"rich"}, 1.2, 0.02)})).lead, 0.0);
}

/// Evidence asks the data how many readings were fitted: twice 301, of two recordings of 3 s.
class EvidenceTest : public testing::Test {
 protected:
  static const PendulumData& data() {
    static const PendulumData one(two_recordings({}));
    return one;
  }
  static SearchResult with_data(SearchResult found) {
    found.data = data().shared();
    return found;
  }
};

TEST_F(EvidenceTest, CountsReadingsAndChance) {
  const Evidence evidence = evidence_of(with_data(found_of({set_of({"a"}, 1.0)})));
  EXPECT_NEAR(evidence.at("log_readings"), std::log10(602.0), 1e-12);
  EXPECT_NEAR(evidence.at("surprise"), 2.0, 1e-12);
  EXPECT_NEAR(evidence.at("base_cost"), 3.0, 1e-12);
}

TEST_F(EvidenceTest, SaysNothingOfAnAnswerWhereThereIsNone) {
  SearchResult found = with_data(found_of({set_of({"a"}, 1.0)}));
  found.decision.answer = 0;
  const Evidence evidence = evidence_of(found);
  EXPECT_TRUE(evidence.contains("base_cost"));
  EXPECT_FALSE(evidence.contains("log_gain"));
  EXPECT_FALSE(evidence.contains("lead"));
}

TEST_F(EvidenceTest, SaysWhatTheAnswerGainsAndLeaves) {
  SearchResult found = with_data(found_of({set_of({"a", "b"}, 2.0), set_of({"a"}, 1.5), set_of({"b"}, 0.5)}));
  found.decision.whole_gain = 2.5;
  const Evidence evidence = evidence_of(found);
  EXPECT_NEAR(evidence.at("log_gain"), std::log10(2.0), 1e-12);
  EXPECT_NEAR(evidence.at("left"), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(evidence.at("share"), 0.8, 1e-12);
  EXPECT_NEAR(evidence.at("least_part"), 0.25, 1e-12) << "b adds half a nat to the 1.5 of a";
  EXPECT_EQ(evidence.at("further_effects"), 1.0);
  EXPECT_EQ(evidence.at("all_lengths"), 0.0);
}

/// One length of the first fold gets worse: five of six cells gain.
TEST_F(EvidenceTest, CountsTheLengthsAndFoldsInWhichTheAnswerHelps) {
  SearchResult found = with_data(found_of({set_of({"a"}, 1.0)}));
  found.sets[1].judged.cost.by_length.row(1).head(4).array() += 1.0;
  EXPECT_NEAR(evidence_of(found).at("help"), 5.0 / 6.0, 1e-12);
}

TEST_F(EvidenceTest, CountsLookAlikes) {
  const SearchResult found = with_data(found_of({set_of({"a"}, 1.0), set_of({"b"}, 1.0), set_of({"c"}, 1.0)}, {2, 3}));
  EXPECT_EQ(evidence_of(found).at("look_alikes"), 2.0);
}

}  // namespace
}  // namespace lacuna
