#include "report/figures/figure.h"

#include <lacuna/error.h>

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace lacuna {
namespace {

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Figure measured_and_residual() {
  Series measured{"measured", Mark::line, kInk, {}, {}, {}}, residual{"resid_ual", Mark::line, kOrange, {}, {}, {}};
  for (int i = 0; i < 5000; ++i) {
    const double t = 1e-3 * i;
    measured.x.push_back(t);
    residual.x.push_back(t);
    measured.y.push_back(i > 2000 && i < 2500 ? std::numeric_limits<double>::quiet_NaN() : std::sin(3.0 * t));
    residual.y.push_back(0.1 * std::cos(3.0 * t));
  }
  Series floor{"noise floor", Mark::band, kGrey, {0.0, 5.0}, {-0.05, -0.05}, {0.05, 0.05}};
  return {"sine.csv \"1\"",
          "time [s]",
          {{"angle [rad]", {measured}, 2.0, {}}, {"residual [rad]", {floor, residual}, 1.0, {}}}};
}

TEST(WriteSvg, DrawsEverySeriesWithItsLabels) {
  const TestFolder folder;
  const auto file = folder / "figure.svg";
  write_svg(measured_and_residual(), file);
  const std::string svg = content(file);
  for (const char* text :
       {"<svg", "measured", "resid_ual", "noise floor", "angle [rad]", "time [s]", "sine.csv", "rgb(213,  94,   0)"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "nothing but the picture";
}

TEST(WriteSvg, DrawsNamedBarsAndPanelsInColumns) {
  Panel bars{"", {{"of squares", Mark::bars, kOrange, {60.0, 40.0}, {0.0, 1.0}, {0.4, 0.4}}}, 1.0, {}};
  bars.y_names = {"within 0.2 s after a reversal", "elsewhere"};
  const TestFolder folder;
  write_svg({"shares", "share [%]", {bars}}, folder / "bars.svg");
  for (const char* text : {"within 0.2 s after a reversal", "elsewhere", "of squares", "share [%]"})
    EXPECT_NE(content(folder / "bars.svg").find(text), std::string::npos) << text;

  Figure grid{"against features", "", {}};
  grid.columns = 2;
  for (const char* name : {"position [rad]", "velocity [rad/s]", "time [s]"}) {
    Panel panel{"residual", {{"", Mark::points, kGrey, {0.0, 1.0, 2.0}, {1.0, 3.0, 2.0}, {}}}, 1.0, {}};
    panel.x_label = name;
    grid.panels.push_back(panel);
  }
  write_svg(grid, folder / "grid.svg");
  for (const char* text : {"position [rad]", "velocity [rad/s]", "time [s]"})
    EXPECT_NE(content(folder / "grid.svg").find(text), std::string::npos) << text;
}

TEST(WriteSvg, DrawsNamedTicks) {
  Figure figure{"error by revision",
                "",
                {{"RMSE [mrad]",
                  {{"fit", Mark::line_points, kBlue, {0, 1}, {9.1, 0.9}, {}}},
                  1.0,
                  {"rigid", "coulomb_friction"}}}};
  const TestFolder folder;
  const auto file = folder / "revisions.svg";
  write_svg(figure, file);
  EXPECT_NE(content(file).find("coulomb_friction"), std::string::npos);
}

TEST(WriteSvg, GivesEachMapItsOwnAxes) {
  Figure figure{"paths",
                "x (m)",
                {{"y (m), far", {{"target", Mark::path, kBlue, {0, 700}, {0, 50}, {}}}, 1.0, {}},
                 {"y (m), near", {{"target", Mark::path, kBlue, {0, 0.7}, {0, 0.1}, {}}}, 1.0, {}}}};
  figure.maps = true;
  const TestFolder folder;
  const auto file = folder / "paths.svg";
  write_svg(figure, file);
  const std::string svg = content(file);
  EXPECT_NE(svg.find(">600<"), std::string::npos) << "x ticks of the first";
  EXPECT_NE(svg.find(">0.6<"), std::string::npos) << "x ticks of the second";
  EXPECT_NE(svg.find("x (m)"), svg.rfind("x (m)"));
}

/// Where text that is turned beside the y axis begins, px from the figure's left edge.
double label_place(const std::string& svg) {
  const std::size_t turned = svg.find("rotate(-90)"), open = svg.rfind("translate(", turned);
  return std::stod(svg.substr(open + 10));
}

TEST(WriteSvg, LeavesRoomForLongNumbersAndLabels) {
  Figure figure{"error by pass",
                "pass",
                {{"a label that is much longer than its low panel is high, in letters of the usual size",
                  {{"", Mark::line_points, kBlue, {1, 2}, {-0.0001053, 0.0001051}, {}}},
                  1.0,
                  {}}}};
  figure.height = 380;
  const TestFolder folder;
  write_svg(figure, folder / "long.svg");
  const std::string svg = content(folder / "long.svg");
  EXPECT_GT(label_place(svg), 10.0);
  EXPECT_NE(svg.find("font-size=\"7"), std::string::npos) << "the label is written smaller";
}

TEST(WriteSvg, RefusesColumnsOfDifferentLength) {
  Figure figure{"t", "x", {{"y", {{"s", Mark::line, kBlue, {0, 1}, {1}, {}}}, 1.0, {}}}};
  EXPECT_THROW(write_svg(figure, TestFolder() / "bad.svg"), Error);
}

TEST(WriteSvg, SaysWhenTheFolderCannotBeWritten) {
  EXPECT_THROW(write_svg(measured_and_residual(), "/proc/no/figure.svg"), std::exception);
}

}  // namespace
}  // namespace lacuna
