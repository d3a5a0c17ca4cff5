#include "answer/settling_test.h"

#include "answer/found_pendulum.h"
#include "answer/search_findings.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

/// Friction and a spring of which a test would tell one from the other.
const FoundPendulum& two_answers() {
  static const FoundPendulum one(two_recordings({.damping = 0.02, .friction = 0.05}),
                                 {"coulomb_friction", "joint_spring"});
  return one;
}

Diagnosis proposed(const SearchResult& found) {
  const PendulumData& data = two_answers().data;
  Diagnosis result;
  propose_settling_test({.experiment = data.experiment(),
                         .catalog = built_catalog(),
                         .definition = data.data().plain().definition,
                         .model = *data.data().plain().model,
                         .trials = data.trials()},
                        found, result);
  return result;
}

void expect_nothing_proposed(const Diagnosis& result) {
  EXPECT_EQ(result.next_test, "");
  EXPECT_TRUE(result.findings.empty());
}

TEST(SettlingTest, IsNotProposedWithoutAnAnswer) { expect_nothing_proposed(proposed(two_answers().decided(0))); }

/// The model as it is is no other answer.
TEST(SettlingTest, IsNotProposedWithoutAnotherAnswer) {
  SearchResult found = two_answers().decided(1);
  found.sets.resize(2);
  expect_nothing_proposed(proposed(found));
}

/// Friction leads by more than three standard errors.
TEST(SettlingTest, IsNotProposedWhereTheAnswerIsSure) { expect_nothing_proposed(proposed(two_answers().decided(1))); }

/// A torque of 50 mN·m against the way moves the joint by far more than its encoder's noise.
TEST(SettlingTest, TellsTheAnswerFromTheOneThatIsAlike) {
  SearchResult found = two_answers().decided(1);
  found.decision.alike = {2};
  const Diagnosis result = proposed(found);
  ASSERT_NE(result.next_test, "") << testing::PrintToString(result.findings);
  EXPECT_THAT(result.next_test, testing::HasSubstr("motor"));
  EXPECT_THAT(result.next_test_worth, testing::HasSubstr("1 trial for odds of 150 to 1, 5 nats"));
  EXPECT_TRUE(result.findings.empty());
}

/// A model and itself: nothing tells them apart.
TEST(SettlingTest, SaysThatNoTestTellsTwoOfOnePrediction) {
  SearchResult found = two_answers().decided(1);
  found.sets.push_back(found.sets[1]);
  found.decision.alike = {3};
  const Diagnosis result = proposed(found);
  EXPECT_EQ(result.next_test, "");
  EXPECT_THAT(result.findings,
              testing::ElementsAre(testing::HasSubstr("no test within the limits of the actuators separates")));
}

}  // namespace
}  // namespace lacuna
