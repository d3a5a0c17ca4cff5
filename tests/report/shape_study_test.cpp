#include "report/shape_study.h"

#include "report/robot_drawing.h"
#include "report/trilateration.h"
#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace lacuna {
namespace {

using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kPlaceOfBody = 1e-12;  // m

/// Two bodies whose ranges to some of four beacons on the ground were measured.
class TrilaterationTest : public testing::Test {
 protected:
  TrilaterationTest() {
    for (const Vector3d& centre : centres_) robot_.bodies.emplace_back().position = centre;
    robot_.bodies[0].name = "low";
    robot_.bodies[1].name = "high";
  }
  void add_beacon(const Vector3d& beacon) {
    for (const BodySpec& body : robot_.bodies) {
      SensorSpec& sensor = robot_.sensors.emplace_back();
      sensor.kind = SensorKind::beacon_range;
      sensor.name = body.name + std::to_string(robot_.sensors.size());
      sensor.element = body.name;
      sensor.beacon = beacon;
    }
  }
  /// `error` is added to every range at the start, m.
  Trial trial(double error = 0.0) const {
    Trial trial;
    const auto sensors = static_cast<Eigen::Index>(robot_.sensors.size());
    trial.measured.times = Eigen::VectorXd::LinSpaced(2, 0.0, 0.1);
    trial.measured.samples.setConstant(2, sensors, 99.0);
    for (Eigen::Index s = 0; s < sensors; ++s) {
      const SensorSpec& sensor = robot_.sensors[static_cast<std::size_t>(s)];
      const Vector3d& centre = sensor.element == "low" ? centres_[0] : centres_[1];
      trial.measured.channels.push_back({sensor.name, "m"});
      trial.measured.samples(0, s) = (centre - sensor.beacon).norm() + error;
    }
    return trial;
  }

  const std::array<Vector3d, 2> centres_ = {Vector3d(0.5, 0.4, 0.1), Vector3d(-1.5, 0.2, 0.7)};
  RobotSpec robot_;
};

TEST_F(TrilaterationTest, ThreeRangesGiveEachCentre) {
  for (const Vector3d& beacon : {Vector3d(-1, -1, 0), Vector3d(1, -1, 0), Vector3d(-1, 1, 0)}) add_beacon(beacon);
  const auto centres = trilaterated_centres(robot_, {trial()});
  ASSERT_TRUE(centres.has_value());
  EXPECT_LT((centres->row(0).transpose() - centres_[0]).norm(), kPlaceOfBody);
  EXPECT_LT((centres->row(1).transpose() - centres_[1]).norm(), kPlaceOfBody);
}

TEST_F(TrilaterationTest, TrialsAreAveraged) {
  for (const Vector3d& beacon : {Vector3d(-1, -1, 0), Vector3d(1, -1, 0), Vector3d(-1, 1, 0)}) add_beacon(beacon);
  const auto centres = trilaterated_centres(robot_, {trial(0.01), trial(-0.01)});
  EXPECT_LT((centres->row(1).transpose() - centres_[1]).norm(), kPlaceOfBody);
}

TEST_F(TrilaterationTest, BeaconsOnALineOrTooFewGiveNothing) {
  EXPECT_FALSE(trilaterated_centres(robot_, {trial()}).has_value());
  for (const double x : {-1.0, 0.0, 1.0}) add_beacon({x, -1, 0});
  EXPECT_FALSE(trilaterated_centres(robot_, {trial()}).has_value());
}

PassRow pass_with(double distance, double wrong) {
  PassRow pass;
  pass.objective = {{kPartDistance, "m", distance}, {kTopologyWrong, "1", wrong}};
  return pass;
}

TEST(ShapeStudy, TheTableHasMeansAndHowOftenTheTopologyIsRight) {
  ShapeStudy study;
  study.experiment = "found";
  study.random_distance = 0.8;
  study.below_ground = 0.25;
  study.runs = {{pass_with(0.3, 1.0), pass_with(0.1, 0.0)}, {pass_with(0.5, 1.0), pass_with(0.3, 1.0)}};
  const std::string table = shape_table({study});
  // Student's t with one degree of freedom: 12.706 times the standard error of 0.1.
  EXPECT_THAT(table, HasSubstr("0.400 ± 1.271"));
  EXPECT_THAT(table, HasSubstr("0.200 ± 1.271"));
  EXPECT_THAT(table, HasSubstr("0.250"));
  EXPECT_THAT(table, HasSubstr("1 of 2"));
  EXPECT_THAT(table, HasSubstr("25 %"));
}

TEST(ShapeStudy, OneRunHasNoIntervalHoweverSmall) {
  ShapeStudy study;
  study.random_distance = 0.8;
  study.runs = {{pass_with(0.3, 1.0), pass_with(0.0012, 0.0)}};
  EXPECT_THAT(shape_table({study}), AllOf(HasSubstr("0.0012"), Not(HasSubstr("±"))));
}

TEST(ShapeStudy, TheTypicalRunHasTheMedianAtItsEnd) {
  const auto run_of = [](double first, double last) {
    return std::vector{pass_with(first, 1.0), pass_with(last, 1.0)};
  };
  EXPECT_EQ(typical_run({run_of(0.1, 0.9), run_of(0.9, 0.1), run_of(0.5, 0.4)}), 2U);
  EXPECT_EQ(typical_run({run_of(0.1, 0.9), run_of(0.1, 0.2)}), 1U) << "of two the better";
  EXPECT_EQ(typical_run({{}, {pass_with(kNotKnown, 1.0)}, run_of(0.1, 0.9)}), 0U) << "what is not known is worst";
}

/// The target starts a little in the ground, and so do all models that lie as it does.
TEST(ShapeStudy, StartsBelowIsDeeperThanTheTarget) {
  BodySpec lying;
  lying.name = "lying";
  lying.position.z() = 0.1 - 1e-5;
  lying.orientation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitY());
  lying.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, 1.0, 0.0}}};
  RobotSpec target;
  target.bodies = {lying};
  EXPECT_FALSE(starts_below(target, target));
  RobotSpec model = target;
  model.bodies.push_back(lying);
  model.bodies.back().position.z() += 0.3;
  EXPECT_FALSE(starts_below(model, target));
  model.bodies.back().orientation = Eigen::Quaterniond::Identity();  // upright: half a metre down from 0.4 m
  EXPECT_TRUE(starts_below(model, target));
  model.bodies.back().position.z() = 0.5;
  EXPECT_FALSE(starts_below(model, target)) << "it stands on the ground";
  target.bodies[0].position.z() = 2.0;
  model.bodies[0].position.z() = 1.0;
  EXPECT_FALSE(starts_below(model, target)) << "above the ground nothing is below it";
}

TEST(ShapeStudy, ErrorsByPassHaveBarsWhereThereAreSeveralRuns) {
  ShapeStudy study;
  study.experiment = "found";
  study.runs = {{pass_with(0.3, 1.0), pass_with(0.1, 0.0)}, {pass_with(0.5, 1.0)}};
  const Figure figure = shape_errors({study});
  ASSERT_EQ(figure.panels.size(), 2U);
  ASSERT_EQ(figure.panels[0].series.size(), 2U);
  EXPECT_EQ(figure.panels[0].series[0].y, (std::vector{0.4, 0.1}));
  EXPECT_EQ(figure.panels[0].series[1].x.size(), 1U) << "one run alone has no interval";
  EXPECT_EQ(figure.panels[1].series[0].y, (std::vector{0.0, 1.0}));
}

/// A part that passes through the ground is two lines, the lower one pale.
TEST(RobotDrawing, WhatIsBelowTheGroundIsPale) {
  BodySpec body;
  body.name = "part";
  body.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, 1.0, 0.0}}};
  RobotSpec through;
  through.bodies = {body};
  RobotSpec above = through;
  above.bodies[0].position.z() = 2.0;
  const TestFolder folder;
  const auto drawn = [&](const RobotSpec& robot) {
    write_robots_svg("a < b", {{"row", {{"caption", robot}}}}, folder / "robots.svg");
    return read_bytes(folder / "robots.svg");
  };
  EXPECT_THAT(drawn(through), HasSubstr("stroke-opacity=\"0.3\""));
  EXPECT_THAT(drawn(above), Not(HasSubstr("stroke-opacity=\"0.3\"")));
  EXPECT_THAT(drawn(above), HasSubstr("a &lt; b"));
  EXPECT_THROW(write_robots_svg("", {}, folder.path() / "no such folder" / "robots.svg"), Error);
}

}  // namespace
}  // namespace lacuna
