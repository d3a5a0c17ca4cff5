#include "foundation/text/problem.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(ProblemList, ThrowsAllProblemsInFileOrder) {
  ProblemList problems;
  problems.add({"rig.toml", 7, 3}, "second");
  problems.add({"rig.toml", 2, 1}, "first");
  try {
    problems.throw_if_any();
    FAIL() << "nothing was thrown";
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(), "rig.toml:2:1: first\nrig.toml:7:3: second");
  }
}

TEST(ProblemList, IsSilentWhenEmpty) { EXPECT_NO_THROW(ProblemList().throw_if_any()); }

TEST(DidYouMean, NamesTheNearestCandidate) {
  EXPECT_EQ(did_you_mean("viscos_friction", {"coulomb_friction", "viscous_friction"}),
            " (did you mean \"viscous_friction\"?)");
}

TEST(DidYouMean, SeesSwappedLetters) { EXPECT_EQ(did_you_mean("angel", {"angle"}), " (did you mean \"angle\"?)"); }

TEST(DidYouMean, DoesNotGuessFromOneLetter) { EXPECT_EQ(did_you_mean("q", {"t"}), ""); }

TEST(DidYouMean, KnowsACandidateByItsPart) {
  EXPECT_EQ(did_you_mean("hinge", {"body.arm", "joint.hinge"}), " (did you mean \"joint.hinge\"?)");
  EXPECT_EQ(did_you_mean("coulomb", {"viscous_friction", "coulomb_friction"}), " (did you mean \"coulomb_friction\"?)");
  EXPECT_EQ(did_you_mean("inge", {"joint.hinge"}), "") << "not set off by a point";
}

TEST(DidYouMean, SaysNothingWhenNothingIsNear) { EXPECT_EQ(did_you_mean("banana", {"coulomb_friction"}), ""); }

TEST(NearestNames, AreAllOfAFew) {
  EXPECT_EQ(nearest_names("x", {"cma_es", "truncation"}), "cma_es, truncation");
  EXPECT_EQ(nearest_names("x", {}), "");
}

TEST(NearestNames, AreFiveOfManyTheNearestFirst) {
  EXPECT_EQ(nearest_names("slop", {"armature", "backlash", "slope", "stop", "shop", "slow", "wheel_slip"}),
            "shop, slope, slow, stop, backlash and 2 more");
}

TEST(NearestNames, BeginWithThoseOfTheSameKind) {
  EXPECT_EQ(nearest_names("joint.foo", {"body.foot", "body.fox", "joint.left_hip", "joint.left_knee", "joint.right_hip",
                                        "joint.right_knee", "world"}),
            "joint.left_hip, joint.left_knee, joint.right_hip, joint.right_knee, body.foot and 2 more");
}

TEST(ProblemList, SaysNothingTwice) {
  ProblemList problems;
  problems.add({"a.toml", 3, 1}, "is in deg");
  problems.add({"a.toml", 3, 1}, "is in deg");
  problems.add({"a.toml", 4, 1}, "is in deg");
  EXPECT_EQ(problems.all().size(), 2U);
}

/// A file of the wrong kind may have a problem a line.
TEST(ProblemList, TakesManyProblemsInShortTime) {
  constexpr int kMany = 50'000;
  ProblemList problems;
  for (int line = 1; line <= kMany; ++line) problems.add({"a.toml", line, 1}, "is in deg");
  EXPECT_EQ(problems.all().size(), kMany);
}

TEST(BadInput, HasOneLineForEachProblemWhateverAFileIsNamed) {
  EXPECT_STREQ(BadInput({{{"sine\nY.csv", 3, 1}, "no such file: a\x1B\nb"}, {{"x.toml"}, "is in deg"}}).what(),
               "sine Y.csv:3:1: no such file: a  b\nx.toml: is in deg");
}

TEST(ProblemList, KeepsTheKeyThatAMessageBeginsWith) {
  ProblemList problems;
  problems.add_of_key({"rig.toml", 3, 1}, "engine.step", "is not above 0");
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(problems.all()[0].key, "engine.step");
  EXPECT_EQ(problems.all()[0].message, "engine.step: is not above 0");
}

}  // namespace
}  // namespace lacuna
