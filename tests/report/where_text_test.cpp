#include "report/text/where_text.h"

#include "report/json/where_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using testing::HasSubstr;

FeatureTable table() {
  FeatureTable table;
  table.features = {{FeatureKind::position, "position", "", "rad"},
                    {FeatureKind::speed, "|velocity|", "", "rad/s"},
                    {FeatureKind::direction, "direction of motion", "", "1"},
                    {FeatureKind::since_reversal, "time since the last reversal", "", "s"},
                    {FeatureKind::command, "command", "", "N*m"},
                    {FeatureKind::contact, "contact", "body.foot", "1"},
                    {FeatureKind::time, "time", "", "s"}};
  table.trial = {0};
  return table;
}

Condition condition(std::size_t feature, double lower, double upper) { return {feature, lower, upper}; }

TEST(ConditionsText, SaysARegimeInTheUsersWords) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto text = [](const std::vector<Condition>& conditions) { return conditions_text(conditions, table()); };
  EXPECT_EQ(text({condition(1, -kNone, 0.05), condition(3, -kNone, 0.21)}),
            "|velocity| < 50 mrad/s, within 0.21 s after a reversal");
  EXPECT_EQ(text({condition(3, 0.5, kNone)}), "more than 0.50 s after a reversal");
  EXPECT_EQ(text({condition(0, 0.5, 1.5)}), "position from 0.50 rad to 1.5 rad");
  EXPECT_EQ(text({condition(2, 0.5, kNone)}), "moving in positive direction");
  EXPECT_EQ(text({condition(2, -kNone, 0.5)}), "at rest or moving in negative direction");
  EXPECT_EQ(text({condition(2, -0.5, 0.5)}), "at rest");
  EXPECT_EQ(text({condition(5, 0.0, kNone)}), "body.foot on the ground");
  EXPECT_EQ(text({condition(6, 12.0, kNone)}), "after 12 s");
}

TEST(FindingText, SaysShareAndRegime) {
  const Finding finding{.kind = FindingKind::regime,
                        .share = 0.614,
                        .share_of_samples = 0.11,
                        .conditions = {condition(1, -INFINITY, 0.05)}};
  EXPECT_EQ(finding_text(finding, table()),
            "61 % of the squared error is in 11 % of the samples: |velocity| < 50 mrad/s");
}

TEST(FindingText, SaysOnWhatAResidualDependsAndOnWhatNot) {
  const Finding finding{.kind = FindingKind::dependence,
                        .share = 0.4,
                        .view = ViewKind::acceleration,
                        .channel = "angle",
                        .features = {2, 1},
                        .not_on = {0, 4, 6},
                        .p = 1e-7};
  EXPECT_EQ(finding_text(finding, table()),
            "40 % of the squared residual acceleration of angle depends on direction of motion and |velocity| "
            "(p < 0.001), not on command, position or time");
}

TEST(FindingText, SaysSignsOfParts) {
  EXPECT_EQ(finding_text({.kind = FindingKind::offset, .share = 0.3, .channel = "angle", .size = -0.02, .unit = "rad"},
                         table()),
            "30 % of the squared error is an offset: angle is measured 20 mrad lower than predicted on average");
  EXPECT_EQ(finding_text({.kind = FindingKind::magnitude, .share = 0.3, .channel = "angle", .size = 0.06}, table()),
            "30 % of the squared error is an error of amplitude: the predicted angle is 6 % too large");
}

WhereItFails one_view() {
  WhereItFails where;
  where.table = table();
  where.views.resize(1);
  return where;
}

TEST(WhereText, NothingFoundIsSaid) {
  EXPECT_THAT(where_text(one_view()),
              HasSubstr("no significant dependence on input or state (99 % level, 7 features tested)"));
  EXPECT_EQ(where_text({}), "");
}

TEST(WhereJson, HasFindingsTestsAndTree) {
  WhereItFails where = one_view();
  ResidualView& view = where.views.front();
  view.family = 2;
  ChannelTests tests;
  tests.channel = "angle";
  tests.features.resize(7);
  IndependenceTest& speed = tests.features[1];
  speed.testable = true;
  speed.statistic = 40.0;
  speed.critical = 9.0;
  speed.p = 1e-4;
  view.channels = {tests};
  view.tree.nodes.resize(1);
  where.findings = {{.kind = FindingKind::regime, .share = 0.6, .conditions = {condition(1, -INFINITY, 0.05)}}};
  const nlohmann::ordered_json findings = findings_json(where), all = where_json(where);
  EXPECT_EQ(findings[0]["kind"], "regime");
  EXPECT_EQ(findings[0]["conditions"][0]["below"], 0.05);
  const auto& independence = all["views"][0]["channels"][0]["independence"];
  EXPECT_EQ(independence[1]["statistic"], 40.0);
  EXPECT_EQ(independence[1]["band99"], 9.0);
  EXPECT_EQ(independence[1]["p"], 2e-4);
  EXPECT_EQ(independence[1]["depends"], true);
  EXPECT_EQ(independence[0]["depends"], false);
  EXPECT_EQ(all["views"][0]["tree"].size(), 1u);
}

TEST(WhereDocument, HasTheStretchesOfTimeThatARegimeSpeaksOf) {
  WhereItFails where = one_view();
  Comparison comparison;
  for (const char* name : {"sine.csv", "chirp.csv"}) {
    TrialComparison& trial = comparison.trials.emplace_back();
    trial.trial = name;
    trial.times = Eigen::VectorXd::LinSpaced(101, 0.0, 1.0);
  }
  // Rows 0.1 s apart; slow from 0.2 s to 0.4 s of the first trial and in the last row before the second one's first.
  where.table.trial = {0, 0, 0, 0, 0, 0, 1, 1};
  where.table.sample = {0, 10, 20, 30, 40, 50, 0, 10};
  where.table.values = Eigen::MatrixXd::Ones(8, 7);
  for (const Eigen::Index slow : {2, 3, 5, 6}) where.table.values(slow, 1) = 0.01;
  where.findings = {{.kind = FindingKind::regime, .share = 0.6, .conditions = {condition(1, -INFINITY, 0.05)}},
                    {.kind = FindingKind::trial, .share = 0.3, .trial = "chirp.csv"}};
  const nlohmann::json document = nlohmann::json::parse(where_document(where, comparison, {}));
  const nlohmann::json& stretches = document["findings"][0]["stretches"];
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[0]["trial"], "sine.csv");
  ASSERT_EQ(stretches[0]["spans"].size(), 2U);
  EXPECT_NEAR(stretches[0]["spans"][0][0], 0.2, 1e-12);
  EXPECT_NEAR(stretches[0]["spans"][0][1], 0.4, 1e-12);
  EXPECT_NEAR(stretches[0]["spans"][1][0], 0.5, 1e-12);
  EXPECT_EQ(stretches[1]["trial"], "chirp.csv");
  EXPECT_NEAR(stretches[1]["spans"][0][1], 0.1, 1e-12);
  EXPECT_NEAR(document["findings"][1]["stretches"][0]["spans"][0][1], 1.0, 1e-12);
}

}  // namespace
}  // namespace lacuna
