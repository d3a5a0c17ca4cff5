#include "shapes/shape_study.h"

#include "report/figures/robot_drawing.h"
#include "shapes/trilateration.h"
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

/// Runs of one pass each, whose e_o are these.
ShapeStudy study_of(const std::vector<double>& distances) {
  ShapeStudy study;
  study.experiment = "found";
  for (const double distance : distances) study.runs.push_back({pass_with(distance, 1.0)});
  return study;
}

TEST(ShapeStudy, ErrorsByPassHaveBarsWhereThereAreSeveralRuns) {
  ShapeStudy study = study_of({0.25, 0.5, 0.75});
  study.runs[0].push_back(pass_with(0.125, 0.0));
  study.runs[1].push_back(pass_with(0.375, 1.0));
  const Figure figure = shape_errors({study});
  ASSERT_EQ(figure.panels.size(), 2U);
  ASSERT_EQ(figure.panels[0].series.size(), 2U);
  EXPECT_EQ(figure.panels[0].series[0].y, (std::vector{0.5, 0.25}));
  EXPECT_EQ(figure.panels[0].series[1].x.size(), 1U) << "two runs do not say how far runs differ";
  EXPECT_EQ(figure.panels[1].series[0].y, (std::vector{0.0, 0.5}));
}

TEST(ShapeStudy, BarsOfADistanceEndAtZero) {
  const Figure figure = shape_errors({study_of({0.001, 0.001, 1.0})});
  const Panel& panel = figure.panels[0];
  EXPECT_FALSE(panel.log_y);
  EXPECT_EQ(panel.series[1].y, (std::vector{0.0}));
  ASSERT_TRUE(panel.y_range.has_value());
  EXPECT_EQ((*panel.y_range)[0], 0.0);
  EXPECT_GT((*panel.y_range)[1], panel.series[1].y2[0]);
}

/// One micrometre beside a metre: bars are geometric, and the points the same as on a linear axis.
TEST(ShapeStudy, MeansThatDifferFarHaveALogarithmicAxis) {
  const Figure figure = shape_errors({study_of({1e-6, 2e-6, 9e-6}), study_of({0.9, 1.0, 1.1})});
  const Panel& panel = figure.panels[0];
  EXPECT_TRUE(panel.log_y);
  EXPECT_DOUBLE_EQ(panel.series[0].y[0], 4e-6);
  const double low = panel.series[1].y[0], high = panel.series[1].y2[0];
  EXPECT_GT(low, 0.0);
  EXPECT_NEAR(low * high, 16e-12, 1e-20) << "as many times below the mean as above it";
  EXPECT_THAT(figure.title, HasSubstr("of the logarithms"));
  ASSERT_TRUE(panel.y_range.has_value());
  EXPECT_LT((*panel.y_range)[0], low);
  EXPECT_GT((*panel.y_range)[1], panel.series[3].y2[0]);
}

TEST(ShapeStudy, AnErrorOfExactlyZeroHasALinearAxis) {
  EXPECT_FALSE(shape_errors({study_of({0.0, 0.0, 0.0}), study_of({1.0, 1.0, 1.0})}).panels[0].log_y);
}

TEST(ShapeStudy, SharesOfRightTopologiesAreDrawnFromNoneToAll) {
  const Panel panel = shape_errors({study_of({0.3})}).panels[1];
  ASSERT_TRUE(panel.y_range.has_value());
  EXPECT_LT((*panel.y_range)[0], 0.0) << "what is at an end does not lie on the axis";
  EXPECT_GT((*panel.y_range)[1], 1.0);
}

TEST(ShapeStudy, ExperimentsStandAboutTheirPass) {
  const Figure figure = shape_errors({study_of({0.3}), study_of({0.3})});
  EXPECT_DOUBLE_EQ(0.5 * (figure.panels[1].series[0].x[0] + figure.panels[1].series[1].x[0]), 1.0);
}

TEST(ShapeStudy, ProgressHasALineWhereAPassBegins) {
  ShapeStudy study = study_of({0.3});
  study.progress = {{1, 0.5, 0.4, 1}, {2, 0.4, 0.4, 1}, {3, 0.9, 0.3, 2}, {4, 0.8, 0.3, 2}};
  const Figure figure = shape_progress({study});
  ASSERT_EQ(figure.panels.size(), 2U);
  for (const Panel& panel : figure.panels) {
    ASSERT_EQ(panel.series.size(), 2U);
    EXPECT_EQ(panel.series[0].mark, Mark::borders);
    EXPECT_EQ(panel.series[0].x, (std::vector{2.5}));
    EXPECT_EQ((std::array{panel.series[0].y[0], panel.series[0].y2[0]}), panel.y_range);
  }
  EXPECT_EQ(figure.panels[0].series[0].label, "start of a pass");
  EXPECT_EQ(figure.panels[1].series[0].label, "") << "one legend for all";
  const TestFolder folder;
  write_svg(figure, folder / "progress.svg");
  EXPECT_THAT(read_bytes(folder / "progress.svg"), HasSubstr("start of a pass"));
}

TEST(ShapeStudy, DistancesHaveAUnitThatSuitsThem) {
  EXPECT_EQ(distance_text(1.4), "1.4 m");
  EXPECT_EQ(distance_text(0.0043), "4.3 mm");
  EXPECT_EQ(distance_text(18e-6), "18 µm");
  EXPECT_EQ(distance_text(427e-6), "430 µm") << "two digits";
  EXPECT_EQ(distance_text(kNotKnown), "unknown");
}

const std::string kPaleStroke = "stroke-opacity=\"0.3\"";

int times_in(const std::string& text, const std::string& word) {
  int times = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++times;
  return times;
}

/// The number behind the first such word from a place on.
double number_behind(const std::string& text, const std::string& word, std::size_t from) {
  return std::stod(text.substr(text.find(word, from) + word.size()));
}

/// A tower of so many metres.
RobotSpec tower(double height) {
  RobotSpec robot;
  BodySpec& body = robot.bodies.emplace_back();
  body.name = "tower";
  body.position.z() = 0.5 * height;
  body.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, height, 0.0}}};
  return robot;
}

/// Each line belongs to the last place before it to which a drawing, or a sign of the legend, is moved.
TEST(RobotDrawing, NothingReachesBeyondThePicture) {
  const TestFolder folder;
  write_robots_svg("towers", {{"high", {{"a", tower(3.0)}, {"b", tower(40.0)}}}, {"low", {{"c", tower(0.5)}}}},
                   folder / "robots.svg");
  const std::string svg = read_bytes(folder / "robots.svg");
  const double width = number_behind(svg, "width=\"", 0), height = number_behind(svg, "height=\"", 0);
  EXPECT_EQ(times_in(svg, "<svg"), 1) << "nothing is cut off";
  for (std::size_t line = svg.find("<line"); line != std::string::npos; line = svg.find("<line", line + 1)) {
    const std::size_t moved = svg.rfind("translate(", line);
    const double left = number_behind(svg, "translate(", moved), top = number_behind(svg, " ", moved);
    for (const char* x : {"x1=\"", "x2=\""}) {
      EXPECT_GE(left + number_behind(svg, x, line), 0.0);
      EXPECT_LE(left + number_behind(svg, x, line), width);
    }
    for (const char* y : {"y1=\"", "y2=\""}) {
      EXPECT_GE(top + number_behind(svg, y, line), 0.0);
      EXPECT_LE(top + number_behind(svg, y, line), height);
    }
  }
  EXPECT_THAT(svg, AllOf(HasSubstr(">a<"), HasSubstr(">b (scale 0."), HasSubstr(">c<")));
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
  EXPECT_EQ(times_in(drawn(through), kPaleStroke), 2) << "in the legend, too";
  EXPECT_EQ(times_in(drawn(above), kPaleStroke), 1);
  EXPECT_THAT(drawn(above), HasSubstr("a &lt; b"));
  EXPECT_THAT(drawn(above), AllOf(HasSubstr(">row<"), HasSubstr(">caption<"), HasSubstr(">part<")));
  EXPECT_THAT(drawn(above), HasSubstr("pale: below the ground"));
  EXPECT_THROW(write_robots_svg("", {}, folder.path() / "no such folder" / "robots.svg"), Error);
}

}  // namespace
}  // namespace lacuna
