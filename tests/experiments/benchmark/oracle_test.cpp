#include "oracle/oracle.h"

#include "hand_made_case.h"
#include "oracle/kalman_whitener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 500;

std::vector<std::string> names(const std::vector<PlacedLaw>& laws) {
  std::vector<std::string> all;
  for (const PlacedLaw& law : laws) all.push_back(law.kind->name);
  return all;
}

CaseNoise scaled(CaseNoise noise, double factor) {
  noise.sensor_white[0] *= factor;
  return noise;
}

TEST(Oracle, ATruthOfTheLibraryLeavesNothing) {
  const MadeCase made = pendulum_case({{"coulomb_friction", 0, {0.02}}}, disturbed_noise(), kSamples);
  const OracleAnswer answer = ask_oracle(made, {.among = {"coulomb_friction"}});
  EXPECT_EQ(answer.non_centrality, 0.0);
  EXPECT_TRUE(answer.detectable);
  EXPECT_EQ(names(answer.representative), std::vector<std::string>{"coulomb_friction"});
  EXPECT_TRUE(answer.rivals.front().empty());
}

TEST(Oracle, LawsThatHoldTheTruthAsALimitAreAlike) {
  const MadeCase made = pendulum_case({{"coulomb_friction", 0, {0.02}}}, white_noise(), kSamples);
  const std::vector<std::string> limits = {"stribeck_friction", "directional_friction", "position_friction"};
  EXPECT_THAT(names(ask_oracle(made, {.among = limits}).alike(0)), testing::UnorderedElementsAreArray(limits));
}

/// Where the base's own damping is known, nothing of it stands in for viscous friction.
MadeCase with_known_damping(MadeCase made) {
  made.base.free.back().of(made.base.spec) = made.base_values[1];
  made.truth.spec = made.base.spec;
  made.base.free.pop_back();
  made.truth.free.pop_back();
  const Eigen::VectorXd of_laws = made.truth_values.tail(made.truth_values.size() - 2);
  made.base_values.conservativeResize(1);
  made.truth_values.resize(1 + of_laws.size());
  made.truth_values << made.base_values, of_laws;
  return made;
}

TEST(Oracle, BristlesWithAFilmOfLubricantHoldViscousFriction) {
  for (const char* hidden : {"viscous_friction", "linear_drag"}) {
    const MadeCase made = with_known_damping(pendulum_case({{hidden, 0, {0.02}}}, white_noise(), kSamples));
    const OracleAnswer answer = ask_oracle(made, {.among = {"viscous_friction", "lugre_friction"}});
    EXPECT_TRUE(answer.detectable);
    EXPECT_THAT(names(answer.alike(0)), testing::Contains("lugre_friction"));
  }
}

TEST(Oracle, DryAndViscousFrictionAreToldApartUnlessTheNoiseIsHuge) {
  for (const double noise : {1.0, 1000.0}) {
    const MadeCase made = pendulum_case({{"coulomb_friction", 0, {0.02}}}, scaled(white_noise(), noise), kSamples);
    const OracleAnswer answer = ask_oracle(made, {.among = {"viscous_friction"}});
    ASSERT_EQ(answer.rivals.front().size(), 1u);
    EXPECT_EQ(answer.rivals.front().front().told_apart, noise == 1.0);
    EXPECT_EQ(answer.detectable, noise == 1.0);  // the base's damping is viscous friction
  }
}

TEST(Oracle, NonCentralityFallsWithTheSquareOfTheNoise) {
  const std::vector<SizedPlacedLaw> hidden = {{"coulomb_friction", 0, {0.02}}};
  const OracleOptions alone{.among = {"coulomb_friction"}};
  const double quiet = ask_oracle(pendulum_case(hidden, white_noise(), kSamples), alone).base_non_centrality;
  const double loud =
      ask_oracle(pendulum_case(hidden, scaled(white_noise(), 4.0), kSamples), alone).base_non_centrality;
  EXPECT_NEAR(quiet / loud, 16.0, 0.1);
}

TEST(Oracle, ATruthOfAnotherFormIsRepresentedByTheLibrarysLawOfThatName) {
  const MadeCase made = pendulum_case({{"twofold_lag", 0, {0.05}}}, white_noise(), kSamples);
  const OracleAnswer answer = ask_oracle(made, {.among = {"command_delay"}});
  EXPECT_EQ(names(answer.representative), std::vector<std::string>{"actuator_lag"});
  EXPECT_GT(answer.non_centrality, kToldApart);
  EXPECT_NEAR(answer.widths.back().value, 0.05, 0.01);
  EXPECT_EQ(answer.widths.back().parameter, "actuator_lag.time");
}

/// A tilted pendulum feels a torque of one period a turn. With no patience for what the screening finds, nothing but a
/// known start is refined.
TEST(Oracle, ALawIsAlsoLookedForWhereItIsSaidToBe) {
  const MadeCase made = pendulum_case({{"mount_tilt", 0, {0.0, 0.1}}}, white_noise(), kSamples);
  OracleOptions options{.among = {"cogging"}, .refined_below = 0.0, .refined_share = 0.0};
  EXPECT_THAT(names(ask_oracle(made, options).alike(0)), testing::IsEmpty());
  options.known = {{{&law_kind("cogging"), 0}, {0.01, 0.05, 1.1}}};
  EXPECT_THAT(names(ask_oracle(made, options).alike(0)), testing::ElementsAre("cogging"));
}

/// Even where every fit is given up after one iteration, that of an answer's member is not.
TEST(Oracle, WhatIsSaidToExplainTheDataIsRefittedWithAllPatience) {
  const MadeCase made = pendulum_case({{"mount_tilt", 0, {0.0, 0.1}}}, white_noise(), kSamples);
  OracleOptions options{.among = {"cogging"}, .hopeless = 1.0, .refined_below = 0.0, .refined_share = 0.0};
  options.known = {{{&law_kind("cogging"), 0}, {0.01, 0.05, 1.1}}};
  EXPECT_THAT(names(ask_oracle(made, options).alike(0)), testing::ElementsAre("cogging"));
}

/// The screening's own shapes have many periods.
TEST(Oracle, WhatGravityDoesIsACoggingOfOnePeriod) {
  const MadeCase made = pendulum_case({{"buoyancy", 0, {0.02}}}, white_noise(), kSamples);
  EXPECT_THAT(names(ask_oracle(made, {.among = {"cogging"}}).alike(0)), testing::ElementsAre("cogging"));
}

/// Only one of the motors ever reaches the limit that both have, and both joints rub.
TEST(Oracle, AnEffectIsAlsoLookedForOnAllElementsAtOnce) {
  PlacedLaw everywhere{&law_kind("torque_saturation"), kEverywhere};
  MadeCase made = two_link_case({{"torque_saturation", 0, {0.5}}}, white_noise(2), kSamples);
  EXPECT_THAT(ask_oracle(made, {.among = {"torque_saturation"}}).alike(0), testing::ElementsAre(everywhere));
  made = two_link_case({{"coulomb_friction", 0, {0.05}}}, white_noise(2), kSamples);
  EXPECT_THAT(ask_oracle(made, {.among = {"coulomb_friction"}}).alike(0), testing::IsEmpty());
}

TEST(Oracle, OneOfTwoLawsIsReplacedWhileTheOtherStays) {
  const MadeCase made =
      pendulum_case({{"coulomb_friction", 0, {0.03}}, {"joint_offset_torque", 0, {0.05}}}, white_noise(), kSamples);
  const OracleAnswer answer =
      ask_oracle(made, {.among = {"directional_friction", "command_offset", "viscous_friction"}});
  ASSERT_EQ(answer.rivals.size(), 2u);
  EXPECT_THAT(names(answer.alike(0)), testing::ElementsAre("directional_friction"));
  EXPECT_THAT(names(answer.alike(1)), testing::ElementsAre("command_offset"));
}

/// What takes the place of a law is told of that law, also where a law of another form stands before it.
TEST(Oracle, LawsAreToldInTheCasesOrder) {
  const MadeCase made =
      pendulum_case({{"twofold_lag", 0, {0.05}}, {"coulomb_friction", 0, {0.03}}}, white_noise(), kSamples);
  const OracleAnswer answer = ask_oracle(made, {.among = {"directional_friction"}});
  ASSERT_EQ(answer.rivals.size(), 2u);
  EXPECT_EQ(names(answer.representative), (std::vector<std::string>{"coulomb_friction", "actuator_lag"}));
  EXPECT_THAT(names(answer.alike(0)), testing::IsEmpty());
  EXPECT_THAT(names(answer.alike(1)), testing::ElementsAre("directional_friction"));
}

/// Viscous friction is what the base's damping does; of two laws that one is there for nobody to find.
TEST(Oracle, OneOfTwoLawsMayBeAbsorbedByTheBase) {
  const MadeCase made =
      pendulum_case({{"viscous_friction", 0, {0.01}}, {"joint_offset_torque", 0, {0.05}}}, white_noise(), kSamples);
  const OracleAnswer answer = ask_oracle(made, {.among = {"command_offset"}});
  ASSERT_EQ(answer.absences.size(), 2u);
  EXPECT_FALSE(answer.absences[0].told_apart);
  EXPECT_TRUE(answer.absences[1].told_apart);
  EXPECT_GT(answer.absences[1].non_centrality, 100.0);
}

/// Which side of a sample a command is held on is a matter of recording: a delay of less than a sample is told from
/// nothing by nobody.
TEST(Oracle, ADelayWithinASampleIsNotToldFromAnyOtherLaw) {
  const std::vector<std::string> others = {"coulomb_friction", "sensor_delay"};
  for (const double delay : {0.002, 0.02}) {
    const MadeCase made = pendulum_case({{"command_delay", 0, {delay}}}, white_noise(), kSamples);
    const std::vector<std::string> alike = names(ask_oracle(made, {.among = others}).alike(0));
    EXPECT_EQ(std::count(alike.begin(), alike.end(), "coulomb_friction"), delay < 0.005 ? 1 : 0) << delay;
  }
}

TEST(Oracle, NothingHiddenHasWidthsAlone) {
  const OracleAnswer answer = ask_oracle(pendulum_case({}, white_noise(), kSamples));
  EXPECT_TRUE(answer.rivals.empty());
  ASSERT_EQ(answer.widths.size(), 2u);
  EXPECT_EQ(answer.widths[0].parameter, "body.arm.mass");
}

/// Refits of many noisy repeats scatter as the widths say: a chi-squared number of as many degrees of freedom, within
/// four of its deviations.
TEST(Oracle, RefitsScatterByTheWidths) {
  constexpr int kRepeats = 40;
  MadeCase made = pendulum_case({{"actuator_lag", 0, {0.05}}}, disturbed_noise(), 300);
  const OracleAnswer answer = ask_oracle(made, {.among = {"actuator_lag"}});
  std::vector<TrueTrial> true_trials;
  const std::vector<Start> starts(made.trials.size(), {Coordinates::Zero(1), Coordinates::Zero(1)});
  for (const MadeTrial& trial : made.trials) true_trials.push_back({trial.noise_free().excitation, starts.front()});
  const Whiten whiten = kalman_whitener(made.truth, made.truth_values, true_trials, made.noise, 1e-3);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(made.truth_values.size());
  for (int r = 0; r < kRepeats; ++r) {
    make_noisy(made, 500 + static_cast<std::uint64_t>(r));
    std::vector<FittedTrial> trials;
    for (const MadeTrial& trial : made.trials) trials.push_back(trial.fitted());
    const PlantFit fit = fit_plant(made.truth, trials, made.truth_values, starts, whiten,
                                   {.most_iterations = 4, .step = 1e-3, .wants_information = false});
    sums += (fit.values - made.truth_values).cwiseAbs2();
  }
  for (std::size_t i = 0; i < answer.widths.size(); ++i) {
    const double deviation = answer.widths[i].width / (2.0 * 1.959964);
    const double ratio = sums[static_cast<Eigen::Index>(i)] / kRepeats / (deviation * deviation);
    EXPECT_NEAR(ratio, 1.0, 4.0 * std::sqrt(2.0 / kRepeats)) << answer.widths[i].parameter;
  }
}

}  // namespace
}  // namespace hidden_effects
