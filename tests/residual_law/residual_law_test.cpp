#include "residual_law/residual_law.h"

#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "plugins/built_catalog.h"
#include "residual_law/missing_force.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

/// A pendulum whose library has friction alone, searched, and what its answer leaves.
class ResidualLawTest : public testing::Test {
 protected:
  ResidualLawTest() : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")) {
    experiment_.noise = {};
    experiment_.model.effects = {};
  }

  SearchResult search(const PendulumTruth& truth, double seconds = 6.0) {
    trials_ = {recorded(truth, "one.csv", multisine, seconds, 3), recorded(truth, "two.csv", steps, seconds, 4)};
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    return search_effects({.experiment = experiment_,
                           .catalog = built_catalog(),
                           .trials = trials_,
                           .values = definition.start_values(),
                           .among = {"coulomb_friction"},
                           .work = {2}});
  }

  ResidualLaw left_of(const PendulumTruth& truth, bool beside_answer = true, double seconds = 6.0) {
    const SearchResult found = search(truth, seconds);
    return ResidualLaws(found, found.sets[beside_answer ? found.decision.answer : 0]).best();
  }

 private:
  Experiment experiment_;
  std::vector<Trial> trials_;
};

TEST_F(ResidualLawTest, IsTheSpringThatNoEffectHas) {
  constexpr double kCubic = 0.5;  // N*m/rad^3
  const ResidualLaw law = left_of({.inertia = 0.03, .damping = 0.02, .cubic = kCubic}, false);
  ASSERT_TRUE(law.is_present) << law.p << " " << law.gain.nats << " " << law.gain.error;
  EXPECT_EQ(law.joint, "hinge");
  EXPECT_THAT(law.kind, testing::HasSubstr("position"));
  ASSERT_EQ(law.formulas.size(), 1U);
  ASSERT_FALSE(law.formulas[0].terms.empty());
  EXPECT_EQ(law.formulas[0].terms[0].text, "q^3") << law.formulas[0].text();
  EXPECT_NEAR(law.formulas[0].terms[0].coefficient, -kCubic, 0.2 * kCubic) << "to first order";
  EXPECT_EQ(law.formulas[0].unit, "N*m");
}

/// Over the position the force is the spring's, within its band.
TEST_F(ResidualLawTest, IsDrawnOverTheQuantityThatItGoesWith) {
  const ResidualLaw law = left_of({.inertia = 0.03, .damping = 0.02, .cubic = 0.5}, false);
  const auto curve = std::find_if(law.curves.begin(), law.curves.end(),
                                  [](const ForceCurve& one) { return one.of == "position" && !one.position; });
  ASSERT_NE(curve, law.curves.end());
  EXPECT_EQ(curve->unit, "rad");
  EXPECT_GT(curve->force.front(), curve->force.back());
  for (const double error : curve->standard_error) EXPECT_LT(error, curve->force.front() - curve->force.back());
}

/// In less than eight of the shortest length a law follows whatever lasts.
TEST_F(ResidualLawTest, IsNotLookedForInShortRecordings) {
  constexpr double kSeconds = 0.16;
  const ResidualLaw law = left_of({.inertia = 0.03, .damping = 0.02, .cubic = 5.0}, false, kSeconds);
  EXPECT_FALSE(law.is_present);
  EXPECT_EQ(law.p, 1.0);
}

TEST_F(ResidualLawTest, IsNotPresentWhereNothingIsMissing) {
  EXPECT_FALSE(left_of({.inertia = 0.03, .damping = 0.02}).is_present);
}

TEST_F(ResidualLawTest, TheMissingForceIsTheAnswersWhereThatIsRight) {
  constexpr double kFriction = 0.15;  // N*m
  const std::vector<ForceCurve> curves =
      missing_force(search({.inertia = 0.03, .damping = 0.02, .friction = kFriction}));
  const auto curve =
      std::find_if(curves.begin(), curves.end(), [](const ForceCurve& one) { return one.of == "velocity"; });
  ASSERT_NE(curve, curves.end());
  EXPECT_EQ(curve->joint, "hinge");
  ASSERT_EQ(curve->by_answer.size(), curve->at.size());
  for (std::size_t i = 0; i < curve->at.size(); ++i)
    EXPECT_NEAR(curve->by_answer[i], curve->force[i], 0.25 * kFriction) << curve->at[i];
  const auto [least, most] = std::minmax_element(curve->force.begin(), curve->force.end());
  EXPECT_GT(*most - *least, kFriction) << "it changes its sign with the velocity";
}

TEST_F(ResidualLawTest, NoForceIsMissingWhereNothingIs) {
  EXPECT_TRUE(missing_force(search({.inertia = 0.03, .damping = 0.02})).empty());
}

TEST_F(ResidualLawTest, IsNotPresentBesideARightAnswer) {
  EXPECT_FALSE(left_of({.inertia = 0.03, .damping = 0.02, .friction = 0.04}).is_present);
}

}  // namespace
}  // namespace lacuna
