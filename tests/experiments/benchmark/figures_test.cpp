#include "figures/baseline_table.h"
#include "figures/figure_values.h"
#include "figures/matrix_picture.h"
#include "figures/tables.h"
#include "runs/case_store.h"

#include "experiments/benchmark/small_results.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace hidden_effects {
namespace {

using testing::HasSubstr;

class Figures : public testing::Test {
 protected:
  Figures() : database_(folder_ / "benchmark.db") { keep_version(database_, "v", "0.1.0"); }

  void keep(const CaseResult& result) { keep_case(database_, result); }

  Estimate figure(const std::string& name) {
    const FigureValues all = read_figures(database_, {"v"}, "tuning");
    for (const FigureKind& kind : all.figures)
      if (kind.name == name) return estimate_of(all, kind, [](const FigureValue&) { return true; });
    ADD_FAILURE() << "no figure " << name;
    return {};
  }

  /// A one-joint case that hides Coulomb friction, and what is answered.
  CaseResult answered(int number, const DiagnosisRecord& diagnosis, double strength = 3.0) {
    CaseResult result = small_case(number, "one_joint", {kCoulomb}, strength);
    result.diagnoses.push_back(diagnosis);
    return result;
  }

  lacuna::TestFolder folder_;
  Database database_;
};

/// 1 for the truth alone, 1/2 with one more, 1 with one more that the oracle does not tell from it, 0 without the truth
/// and for another verdict: 2.5 of 5.
TEST_F(Figures, ClassScoreCountsMembersThatTheOracleTellsApart) {
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  keep(answered(1, small_diagnosis(1, "effect_found", 0.9, {kStribeck}, {kCoulomb})));
  CaseResult alike = answered(2, small_diagnosis(1, "effect_found", 0.9, {kStribeck}, {kCoulomb}));
  alike.oracle.rivals = {{0, kStribeck, 0.5, false}};
  keep(alike);
  keep(answered(3, small_diagnosis(1, "effect_found", 0.9, {kSpring})));
  keep(answered(4, small_diagnosis(1, "cannot_tell", 0.9, {kCoulomb})));
  EXPECT_EQ(figure("top1_3").n, 5U);
  EXPECT_DOUBLE_EQ(figure("top1_3").value, 0.5);
  EXPECT_EQ(figure("top1_1.5").n, 0U);
  EXPECT_DOUBLE_EQ(figure("top3").value, 0.8);
}

/// `run --diagnoses 1` goes on with no answer; a case that found nothing would be the loop's only one, a failure.
TEST_F(Figures, SayNothingOfALoopThatWasCutShortEverywhere) {
  keep(answered(0, small_diagnosis(1, "cannot_tell", 0.9)));
  EXPECT_EQ(figure("true_set").n, 1U);
  keep(answered(1, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  EXPECT_EQ(figure("true_set").n, 0U);
}

TEST_F(Figures, AnEffectAtAnotherPlaceIsWrong) {
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {{"coulomb_friction", "joint.elbow"}})));
  EXPECT_DOUBLE_EQ(figure("top1_3").value, 0.0);
}

TEST_F(Figures, AbsorbedCasesCountAsNothingHidden) {
  CaseResult absorbed = answered(0, small_diagnosis(1, "nothing_missing", 0.9));
  absorbed.about.absorbed = true;
  keep(absorbed);
  CaseResult alarm = small_case(1, "nothing", {}, 1.0);
  alarm.diagnoses = {small_diagnosis(1, "not_in_library", 0.6)};
  keep(alarm);
  EXPECT_EQ(figure("top1_3").n, 0U);
  EXPECT_EQ(figure("false_positive").n, 2U);
  EXPECT_DOUBLE_EQ(figure("false_positive").value, 0.5);
  EXPECT_DOUBLE_EQ(figure("nothing_missing").value, 0.5);
}

TEST_F(Figures, AWithheldEffectIsRecognisedByTheVerdict) {
  for (int number = 0; number < 4; ++number) {
    CaseResult result = small_case(number, "withheld", {kCoulomb});
    result.diagnoses = {small_diagnosis(1, number == 0 ? "effect_found" : "not_in_library", 0.9)};
    const double left = number < 2 ? 2000.0 : 20.0;
    result.oracle.rivals = {{0, kStribeck, 0.5, false}, {0, kSpring, left, true}, {0, {"", ""}, 5000.0, true}};
    keep(result);
  }
  EXPECT_DOUBLE_EQ(figure("not_in_library").value, 0.75);
  EXPECT_EQ(figure("not_in_library_left").n, 2U);
  EXPECT_DOUBLE_EQ(figure("not_in_library_left").value, 0.5);
  EXPECT_EQ(figure("top3").n, 0U);
  CaseResult whole = small_case(4, "withheld", {kCoulomb});
  whole.diagnoses = {small_diagnosis(1, "effect_found", 0.9, {kStribeck})};
  whole.oracle.rivals = {{0, kStribeck, 0.5, false}, {0, kSpring, 2000.0, true}, {0, {"", ""}, 5000.0, true}};
  keep(whole);
  EXPECT_EQ(figure("not_in_library").n, 4U) << "the answer is like the hidden law: it was not withheld";
  EXPECT_EQ(figure("brier").n, 4U);
  EXPECT_EQ(figure("seconds").n, figure("failed").n);
  EXPECT_EQ(figure("failed").n, 4U);
  CaseResult beside = small_case(5, "withheld", {kCoulomb});
  beside.diagnoses = {small_diagnosis(1, "not_in_library", 0.9, {kStribeck})};
  beside.oracle.rivals = whole.oracle.rivals;
  keep(beside);
  EXPECT_EQ(figure("not_in_library").n, 5U) << "what is ranked first beside another verdict is no answer";
}

/// Case 0 finds both, one after the other; case 1 one of them and something else that the oracle takes for the other.
TEST_F(Figures, TheLoopEndsAtTheTrueSetUpToTheOraclesClass) {
  CaseResult both = small_case(0, "two_effects", {kCoulomb, kSpring});
  both.diagnoses = {small_diagnosis(1, "effect_found", 0.9, {kSpring}),
                    small_diagnosis(2, "effect_found", 0.9, {kCoulomb}), small_diagnosis(3, "nothing_missing", 0.9)};
  both.diagnoses[0].added = {kSpring};
  both.diagnoses[1].added = {kCoulomb};
  keep(both);
  CaseResult alike = small_case(1, "two_effects", {kCoulomb, kSpring});
  alike.diagnoses = {small_diagnosis(1, "effect_found", 0.9, {kStribeck, kSpring}),
                     small_diagnosis(2, "nothing_missing", 0.9)};
  alike.diagnoses[0].added = {kStribeck, kSpring};
  alike.oracle.rivals = {{0, kStribeck, 0.5, false}};
  keep(alike);
  CaseResult half = small_case(2, "two_effects", {kCoulomb, kSpring});
  half.diagnoses = {small_diagnosis(1, "effect_found", 0.9, {kSpring}), small_diagnosis(2, "nothing_missing", 0.9)};
  half.diagnoses[0].added = {kSpring};
  keep(half);
  EXPECT_NEAR(figure("both_found").value, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(figure("true_set").value, 2.0 / 3.0, 1e-12);
  EXPECT_EQ(figure("second_nothing").n, 1U) << "the first diagnosis of the others left something hidden";
  EXPECT_EQ(figure("second_nothing").value, 1.0);
  CaseResult further = alike;
  further.about.number = 3;
  further.diagnoses[1] = small_diagnosis(2, "effect_found", 0.9, {kCoulomb});
  keep(further);
  EXPECT_EQ(figure("second_nothing").value, 0.5);
  EXPECT_EQ(figure("true_set").n, 3U) << "where nobody went on, nothing is known of the loop";
}

/// The oracle does not tell the spring from nothing in its place, and so not from anything else. Right is the friction
/// alone, or both; with something else beside it the set is no true one, and without the friction neither.
TEST_F(Figures, OfTwoLawsOneThatIsNotToldNeedNotBeFound) {
  const EffectAt kOther{"mount_tilt", "world"};
  const std::vector<std::vector<EffectAt>> added = {{kCoulomb}, {kCoulomb, kSpring}, {kCoulomb, kOther}, {kSpring}};
  for (int number = 0; number < 4; ++number) {
    CaseResult result = small_case(number, "two_effects", {kCoulomb, kSpring});
    const std::vector<EffectAt>& found = added[static_cast<std::size_t>(number)];
    result.diagnoses = {small_diagnosis(1, "effect_found", 0.9, found), small_diagnosis(2, "nothing_missing", 0.9)};
    result.diagnoses[0].added = found;
    result.oracle.rivals = {
        {0, {"", ""}, 500.0, true}, {0, kOther, 400.0, true}, {1, {"", ""}, 0.5, false}, {1, kOther, 0.4, false}};
    keep(result);
  }
  EXPECT_EQ(figure("both_found").n, 0U) << "nobody can find both";
  EXPECT_EQ(figure("true_set").n, 4U);
  EXPECT_DOUBLE_EQ(figure("true_set").value, 0.5);
  EXPECT_EQ(figure("second_nothing").n, 2U);
}

/// Ratios √((1.0² + 1.1²)/2) = 1.051 and √((1.0² + 1.3²)/2) = 1.160; a found model that could not be simulated.
TEST_F(Figures, HeldOutErrorIsMeanedOverChannels) {
  for (int number = 0; number < 3; ++number) {
    CaseResult result = answered(number, small_diagnosis(1, "nothing_missing", 0.9));
    result.held_out = {{"truth", "angle", 2.0},
                       {"truth", "speed", 1.0},
                       {"found", "angle", 2.0},
                       {"found", "speed",
                        number == 0   ? 1.1
                        : number == 1 ? 1.3
                                      : kUnknown}};
    keep(result);
  }
  EXPECT_EQ(figure("held_out").n, 3U);
  EXPECT_NEAR(figure("held_out").value, 1.0 / 3.0, 1e-12);
}

/// The interval [1, 3] holds the true 2, and is four times as wide as the oracle's; one without ends says nothing.
TEST_F(Figures, IntervalsAreThoseOfRightAnswers) {
  CaseResult right = answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb, kSpring}));
  right.oracle.widths = {{"coulomb_friction.size", 0.5}};
  keep(right);
  CaseResult off = answered(1, small_diagnosis(1, "effect_found", 0.9, {kCoulomb}));
  off.diagnoses[0].ranking[0].effects[0].parameters = {{"size", 1.2, 1.0, 1.5}};
  keep(off);
  CaseResult open = answered(2, small_diagnosis(1, "effect_found", 0.9, {kCoulomb}));
  open.diagnoses[0].ranking[0].effects[0].parameters = {{"size", 1.2, kUnknown, kUnknown}};
  keep(open);
  EXPECT_EQ(figure("coverage").n, 2U);
  EXPECT_DOUBLE_EQ(figure("coverage").value, 0.5);
  EXPECT_EQ(figure("width").n, 1U);
  EXPECT_DOUBLE_EQ(figure("width").value, 4.0);
}

/// (0.1² + 0.8²)/2 = 0.325; cannot_tell states nothing.
TEST_F(Figures, ProbabilitiesAreThoseOfVerdicts) {
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  keep(answered(1, small_diagnosis(1, "nothing_missing", 0.8)));
  CaseResult silent = answered(2, small_diagnosis(1, "cannot_tell", 0.5));
  silent.oracle.rivals = {{0, {"", ""}, 50.0, true}};
  keep(silent);
  EXPECT_EQ(figure("brier").n, 2U);
  EXPECT_NEAR(figure("brier").value, 0.325, 1e-12);
  EXPECT_NEAR(figure("calibration").value, (0.1 + 0.8) / 2.0, 1e-12);
  EXPECT_EQ(figure("cannot_tell").n, 1U);
  EXPECT_DOUBLE_EQ(figure("cannot_tell").value, 1.0);
}

/// Chosen tests: two, which leave the truth; six in vain; one, which leaves what only looks like it. Random ones: five,
/// which leave the truth; a failure, which leaves the whole case out; six in vain. The fourth case needs no test, the
/// fifth is left out.
TEST_F(Figures, TestsAreCountedUntilOneOfTheTwoIsLeft) {
  const auto tests = [](std::size_t count) { return std::vector<SettlingTest>(count, {"line", "effect_found", 1.0}); };
  const std::vector<std::vector<SettlingRun>> runs = {
      {{"none", {}, {}, ""}, {"chosen", tests(2), kCoulomb, ""}, {"random", tests(5), kCoulomb, ""}},
      {{"chosen", tests(6), {}, ""}, {"random", tests(1), {}, "lacuna trial crashed with signal 11"}},
      {{"chosen", tests(1), kStribeck, ""}, {"random", tests(6), {}, ""}},
      {{"none", {}, kCoulomb, ""}},
      {}};
  for (int number = 0; number < 5; ++number) {
    CaseResult result = answered(number, small_diagnosis(1, "effect_found", 0.9, {kCoulomb}, {kStribeck}));
    result.settling = {kCoulomb, kStribeck, number == 4 ? "both are one effect" : "",
                       runs[static_cast<std::size_t>(number)]};
    keep(result);
  }
  EXPECT_EQ(figure("tests_chosen").n, 2U);
  EXPECT_DOUBLE_EQ(figure("tests_chosen").value, 1.5);
  EXPECT_EQ(figure("tests_random").n, 2U);
  EXPECT_DOUBLE_EQ(figure("tests_random").value, 6.0);
  EXPECT_DOUBLE_EQ(figure("settled_chosen").value, 1.0);
  EXPECT_NEAR(figure("settled_random").value, 0.5, 1e-12);
  EXPECT_EQ(figure("settled_none").n, 2U);
  EXPECT_DOUBLE_EQ(figure("settled_none").value, 0.5);
  EXPECT_EQ(figure("left_chosen").n, 2U);
  EXPECT_DOUBLE_EQ(figure("left_chosen").value, 0.5);
  EXPECT_DOUBLE_EQ(figure("left_random").value, 1.0);
}

/// What is left is not the hidden effect, but the oracle did not tell the two apart on the first data.
TEST_F(Figures, WhatIsLeftMayStandForTheTruth) {
  CaseResult result = answered(0, small_diagnosis(1, "effect_found", 0.9, {kStribeck}, {kSpring}));
  result.settling = {kStribeck, kSpring, "", {{"chosen", {}, kStribeck, ""}, {"random", {}, kSpring, ""}}};
  result.oracle.rivals = {{0, kStribeck, 0.5, false}};
  keep(result);
  const std::vector<Row> rows = database_.query("SELECT left_over FROM settled ORDER BY choice");
  EXPECT_EQ(text(rows.at(0)[0]), "stand-in");
  EXPECT_EQ(text(rows.at(1)[0]), "another");
  EXPECT_EQ(figure("left_chosen").n, 0U);
}

TEST_F(Figures, CasesThatEndedEarlyCountAsWrong) {
  CaseResult failed = small_case(0, "one_joint", {kCoulomb});
  failed.failure = "lacuna diagnose crashed with signal 11";
  keep(failed);
  CaseResult unmade = small_case(1, "one_joint", {kCoulomb});
  unmade.about.strength = kUnknown;
  unmade.failure = "the case cannot be made: it runs away";
  keep(unmade);
  EXPECT_EQ(figure("top1_3").n, 1U);
  EXPECT_DOUBLE_EQ(figure("top1_3").value, 0.0);
  EXPECT_DOUBLE_EQ(figure("failed").value, 1.0);
  EXPECT_EQ(figure("failed").n, 2U);
}

TEST_F(Figures, ThePageHasEstimateIntervalAndGoal) {
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  const std::string page = markdown(read_figures(database_, {}, "tuning"));
  EXPECT_THAT(page, HasSubstr("| first class right, strength 3 (score 1/(1 + k)) | ≥ 95 % | "
                              "100.0 % [20.7, 100.0] n 1 | yes | – | – | 100.0 % [20.7, 100.0] n 1 |"));
  EXPECT_THAT(page, HasSubstr("## By rig"));
  EXPECT_THAT(page, HasSubstr("| coulomb_friction |"));
}

TEST_F(Figures, FormsOfTheHiddenLawStandBesideEachOther) {
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  CaseResult bristles = answered(1, small_diagnosis(1, "effect_found", 0.9, {kSpring}));
  bristles.about.hidden.front().library_form = false;
  keep(bristles);
  const std::string page = markdown(read_figures(database_, {}, "tuning"));
  EXPECT_THAT(page,
              HasSubstr("## By form of the hidden law, all noise\n\n| figure | another form | the library's form |"));
  EXPECT_THAT(page, HasSubstr("| first class right, strength 3 (score 1/(1 + k)) | 0.0 % [0.0, 79.3] n 1 | "
                              "100.0 % [20.7, 100.0] n 1 |"));
}

/// Right first, right second, and with nothing chosen: one of three first, two of three among the first.
TEST_F(Figures, OtherMethodsAreScoredOnTheSameCases) {
  for (int number = 0; number < 3; ++number) {
    CaseResult result = answered(number, small_diagnosis(1, "nothing_missing", 0.9));
    result.baselines = {{"guess", number == 2 ? 0 : 1, 4.0, {kCoulomb, kSpring}, {2.0, 1.0}}};
    if (number == 1) result.baselines[0].ranking = {kSpring, kCoulomb};
    if (number == 2) result.baselines[0].ranking = {kSpring};
    keep(result);
  }
  const std::string table = baseline_table(database_, read_figures(database_, {"v"}, "tuning"));
  EXPECT_THAT(table, HasSubstr("| guess | first right | 33.3 % [6.1, 79.2] n 3 |"));
  EXPECT_THAT(table, HasSubstr("| guess | among the first three | 66.7 % [20.8, 93.9] n 3 |"));
  EXPECT_THAT(table, HasSubstr("| guess | processor seconds | 4 [4, 4] n 3 |"));
  EXPECT_THAT(table, HasSubstr("| lacuna | first right | 0.0 % [0.0, 56.1] n 3 |"));
}

TEST_F(Figures, OtherMethodsAreCountedOverSeveralVersions) {
  keep_version(database_, "w", "0.1.1");
  for (const char* version : {"v", "w"}) {
    CaseResult result = answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb}));
    result.about.version = version;
    result.baselines = {{"guess", 1, 4.0, {version == std::string("v") ? kCoulomb : kSpring}, {2.0}}};
    keep(result);
  }
  const std::string table = baseline_table(database_, read_figures(database_, {"v", "w"}, "tuning"));
  EXPECT_THAT(table, HasSubstr("| guess | first right | 50.0 % [9.5, 90.5] n 2 |"));
}

/// The oracle does not tell a spring from the hidden friction: as first choice it is wrong, and not told from what is
/// right. Of this program the first choice counts alone, too.
TEST_F(Figures, MethodsMayNameWhatCannotBeToldFromTheTruth) {
  CaseResult result = answered(0, small_diagnosis(1, "effect_found", 0.9, {kSpring}));
  result.baselines = {{"guess", 1, 4.0, {kSpring}, {2.0}}};
  result.oracle.rivals = {{0, kSpring, 0.5, false}};
  keep(result);
  const std::string table = baseline_table(database_, read_figures(database_, {"v"}, "tuning"));
  for (const std::string method : {"guess", "lacuna"}) {
    EXPECT_THAT(table, HasSubstr("| " + method + " | first right | 0.0 % [0.0, 79.3] n 1 |"));
    EXPECT_THAT(table, HasSubstr("| " + method + " | first right, or not told from it by the oracle | 100.0 %"));
  }
}

/// An answer of another version to the same case, and one to a case of its own: three together, one each apart.
TEST_F(Figures, VersionsAreCountedApartOrTogether) {
  keep_version(database_, "w", "0.1.1");
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  for (const int number : {0, 1}) {
    CaseResult later = answered(number, small_diagnosis(1, "effect_found", 0.9, {kSpring}));
    later.about.version = "w";
    keep(later);
  }
  const auto alike = [&](const std::vector<std::string>& versions) {
    const FigureValues all = read_figures(database_, versions, "tuning");
    const auto named = std::find_if(all.figures.begin(), all.figures.end(),
                                    [](const FigureKind& kind) { return kind.name == "named"; });
    return estimate_of(all, *named, [](const FigureValue&) { return true; });
  };
  EXPECT_EQ(versions_of(database_, "tuning"), (std::vector<std::string>{"v", "w"}));
  EXPECT_EQ(alike({"v", "w"}).n, 3U);
  EXPECT_NEAR(alike({"v", "w"}).value, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(alike({"v"}).value, 1.0);
  EXPECT_EQ(alike({}).n, 2U) << "the one begun last";
  EXPECT_EQ(version_text(read_figures(database_, {"w", "v", "w"}, "tuning")), "versions v and w");
  EXPECT_EQ(read_figures(database_, {"v", "w"}, "tuning").cases, 3U);
}

TEST_F(Figures, VersionsAndSetsWithoutCasesAreSaid) {
  keep(answered(0, small_diagnosis(1, "effect_found", 0.9, {kCoulomb})));
  EXPECT_THAT(
      [&] {
        read_figures(database_, {"x", "v", "y"}, "tuning");
      },
      testing::ThrowsMessage<std::invalid_argument>(
          HasSubstr("no case of --set tuning --version x or y; it has --set tuning of --version v")));
  EXPECT_THROW(read_figures(database_, {"v"}, "reporting"), std::invalid_argument);
}

TEST(MatrixPicture, ShadesByTheShareOfTheRow) {
  const std::string svg = matrix_svg({"title", "hidden", "named", {{"a", {{"a", 3}, {"b", 1}}}}});
  EXPECT_THAT(svg, HasSubstr("x=\"190\" y=\"248\" width=\"26\" height=\"26\" fill=\"#0072B2\" fill-opacity=\"0.750\""));
  EXPECT_THAT(svg, HasSubstr("x=\"191\" y=\"249\" width=\"24\" height=\"24\" fill=\"none\" stroke=\"#D55E00\""))
      << "its frame";
  EXPECT_THAT(svg, HasSubstr("fill-opacity=\"0.250\" stroke=\"#DDDDDD\""));
  EXPECT_THAT(svg, HasSubstr(">a (4)<"));
}

}  // namespace
}  // namespace hidden_effects
