#include "config/experiment_reader.h"
#include "criterion/value_errors.h"
#include "data_checks/recorded_pendulum.h"
#include "search/effect_search.h"
#include "plugins/built_catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Members = std::set<std::string>;

constexpr double kFriction = 0.04;  ///< N·m

/// The servo pendulum of the first steps as its owner believes it to be: without friction.
class EffectSearchTest : public testing::Test {
 protected:
  EffectSearchTest() : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")) {
    experiment_.noise = {};
    experiment_.model.effects = {};
  }

  SearchResult search(const std::vector<Trial>& trials, int threads = 2,
                      std::vector<std::string> among = {"joint_spring", "coulomb_friction", "viscous_friction",
                                                        "joint_offset_torque", "torque_gain"}) const {
    const ModelDefinition definition = define_model(experiment_, built_catalog());
    return search_effects({.experiment = experiment_,
                           .catalog = built_catalog(),
                           .trials = trials,
                           .values = definition.start_values(),
                           .among = std::move(among),
                           .work = {threads}});
  }

  static std::vector<Trial> two_recordings(double friction) {
    return {recorded({.friction = friction}, "one.csv", multisine, 5.0, 3),
            recorded({.friction = friction}, "two.csv", multisine, 5.0, 4)};
  }

  Experiment experiment_;
};

const FittedModel& answer_of(const SearchResult& found) { return found.sets[found.decision.answer]; }

TEST_F(EffectSearchTest, NamesTheFrictionThatIsMissingWithItsSize) {
  const SearchResult found = search(two_recordings(kFriction));
  EXPECT_EQ(answer_of(found).judged.members, Members{"coulomb_friction @ joint.hinge"});
  EXPECT_LT(found.decision.p, 0.05);
  EXPECT_NEAR(answer_of(found).values.at("coulomb_friction @ joint.hinge.torque"), kFriction, 0.1 * kFriction);
}

TEST_F(EffectSearchTest, NamesNothingWhereNothingIsMissing) {
  const SearchResult found = search(two_recordings(0.0));
  EXPECT_EQ(found.decision.answer, 0U);
  EXPECT_TRUE(found.by_all_lengths) << "the shorter lengths show nothing, so all were asked";
}

TEST_F(EffectSearchTest, NamesBothOfTwoEffectsAndFitsNoSetWorseThanItsParts) {
  const SearchResult found = search({recorded({.friction = kFriction, .spring = 0.2}, "one.csv", multisine, 5.0, 3)});
  EXPECT_EQ(answer_of(found).judged.members, (Members{"coulomb_friction @ joint.hinge", "joint_spring @ joint.hinge"}));
  int nested = 0;
  for (const FittedModel& set : found.sets)
    for (const FittedModel& part : found.sets) {
      const Members &whole = set.judged.members, &some = part.judged.members;
      if (some.size() >= whole.size() || !std::includes(whole.begin(), whole.end(), some.begin(), some.end())) continue;
      ++nested;
      EXPECT_LE(set.fit.cost, part.fit.cost + 1e-3) << testing::PrintToString(whole);
    }
  EXPECT_GE(nested, 4);
}

/// Readings tell the product of area and density alone. The model's own damping, which is too little, stays as it is.
TEST_F(EffectSearchTest, HoldsTheDensityOfADragAndTellsItsArea) {
  std::erase_if(experiment_.model.free, [](const FreeRange& one) { return one.pattern == "joint.hinge.damping"; });
  const SearchResult found = search({recorded({.damping = 0.2}, "one.csv", multisine, 5.0, 3)}, 2, {"quadratic_drag"});
  const auto drag = std::find_if(found.sets.begin(), found.sets.end(), [](const FittedModel& set) {
    return set.judged.members == Members{"quadratic_drag @ body.arm"};
  });
  ASSERT_NE(drag, found.sets.end());
  EXPECT_EQ(drag->model.added.front().fixed, std::vector<std::string>{"density"});
  EXPECT_EQ(drag->judged.told, 1);
  EXPECT_EQ(drag->judged.values, 1);
  const double area = drag->values.at("quadratic_drag @ body.arm.area");
  EXPECT_GT(area, 0.0);
  const LinearCost least = least_cost(found.layout, drag->fit.products, drag->fit.bounds);
  EXPECT_LT(std::abs(least.step(0)), 0.05 * area) << "it stands at its least cost";
  EXPECT_LT(value_errors(found.layout, drag->fit.products, least).standard()(0), 0.3 * area);
}

/// The value is told with what the file has instead of it, and no effect stands in for it.
TEST_F(EffectSearchTest, NamesAFixedValueOfTheRobotFileThatIsWrong) {
  std::erase_if(experiment_.model.free, [](const FreeRange& one) { return one.pattern == "joint.hinge.armature"; });
  experiment_.model.set["joint.hinge.armature"] = 0.012;  // kg·m², of the one that was recorded less than half
  const SearchResult found = search({recorded({.inertia = 0.03}, "one.csv", multisine, 5.0, 3),
                                     recorded({.inertia = 0.03}, "two.csv", multisine, 5.0, 4)},
                                    2, {"wrong_value", "joint_spring", "coulomb_friction", "torque_gain"});
  const std::string name = "wrong_value @ joint.hinge.armature";
  EXPECT_EQ(answer_of(found).judged.members, Members{name});
  const double armature = answer_of(found).values.at(name + ".armature");
  EXPECT_NEAR(armature, 0.005, 0.0005);
}

/// No sensor's reading falls where the measured quantity rises: an error of an encoder that repeats is never that
/// large.
TEST_F(EffectSearchTest, RefusesAReadingThatRunsBackwards) {
  const SearchResult found = search(two_recordings(kFriction), 2, {"encoder_eccentricity", "coulomb_friction"});
  int of_encoder = 0;
  for (const FittedModel& set : found.sets) {
    const auto value = [&](const std::string& name) {
      return set.values.at("encoder_eccentricity @ sensor.angle." + name);
    };
    if (!set.judged.members.contains("encoder_eccentricity @ sensor.angle")) continue;
    ++of_encoder;
    EXPECT_LT(std::hypot(value("sine"), value("cosine")) * value("periods"), 1.1);
  }
  EXPECT_GT(of_encoder, 0);
}

TEST_F(EffectSearchTest, NeedsEightReadingsForAValue) {
  const std::vector<Trial> trials = {recorded({.friction = kFriction}, "one.csv", multisine, 0.4, 3)};
  const SearchResult found = search(trials);
  const auto readings = static_cast<std::size_t>(trials.front().measured.samples.size());
  for (const FittedModel& set : found.sets) {
    const std::size_t values = set.judged.members.empty() ? 0 : set.model.definition.free.size();
    EXPECT_LE(8 * values, readings);
  }
  EXPECT_LT(found.sets.size(), 30U);
}

TEST_F(EffectSearchTest, MoreRecordingsKeepTheAnswer) {
  std::vector<Trial> trials;
  for (const char* file : {"one.csv", "two.csv", "three.csv", "four.csv"}) {
    trials.push_back(recorded({.friction = kFriction}, file, multisine, 3.0, 11 + trials.size()));
    EXPECT_EQ(answer_of(search(trials)).judged.members, Members{"coulomb_friction @ joint.hinge"})
        << trials.size() << " recordings";
  }
}

TEST_F(EffectSearchTest, GivesTheSameDigitsWithAnyNumberOfThreads) {
  const std::vector<Trial> trials = {recorded({.friction = kFriction}, "one.csv", multisine, 3.0, 3)};
  const SearchResult once = search(trials, 1), again = search(trials, 2);
  ASSERT_EQ(once.sets.size(), again.sets.size());
  for (std::size_t i = 0; i < once.sets.size(); ++i) EXPECT_EQ(once.sets[i].fit.cost, again.sets[i].fit.cost);
}

}  // namespace
}  // namespace lacuna
