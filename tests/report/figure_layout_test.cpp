#include "report/figures/comparison_pictures.h"
#include "report/figures/diagnosis_pictures.h"
#include "report/figures/figure.h"
#include "report/figures/text_lines.h"
#include "report/figures/log_axis.h"
#include "report/figures/run_pictures.h"

#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNarrowLetter = 6.0;  // px, narrower than any font draws a letter of 13 px on average

struct DrawnText {
  double x = 0.0, y = 0.0;
  std::string anchor, text;
  double width() const { return kNarrowLetter * static_cast<double>(letters_of(text)); }
  double left() const { return anchor == "end" ? x - width() : anchor == "middle" ? x - width() / 2.0 : x; }
  double right() const { return left() + width(); }
};

/// Texts that lie level, as the picture places them.
std::vector<DrawnText> texts_of(const std::string& svg) {
  static const std::regex kText(
      "<g transform=\"translate\\(([-0-9.]+),([-0-9.]+)\\)\"[^>]*text-anchor=\"(\\w+)\">\\s*<text>(.*?)</text>");
  static const std::regex kMark("<[^>]*>");
  std::vector<DrawnText> texts;
  for (std::sregex_iterator it(svg.begin(), svg.end(), kText), end; it != end; ++it) {
    const std::string text = std::regex_replace((*it)[4].str(), kMark, "");
    if (text.find_first_not_of(" \t\n") == std::string::npos) continue;
    texts.push_back({std::stod((*it)[1]), std::stod((*it)[2]), (*it)[3], text});
  }
  return texts;
}

struct FrameSize {
  double width = 0.0, height = 0.0;
};

FrameSize frame_of(const std::string& svg) {
  static const std::regex kSize("<svg[^>]*width=\"([0-9.]+)\" height=\"([0-9.]+)\"");
  std::smatch found;
  EXPECT_TRUE(std::regex_search(svg, found, kSize)) << svg.substr(0, 300);
  return {std::stod(found[1]), std::stod(found[2])};
}

void expect_within_frame(const std::string& svg) {
  const FrameSize frame = frame_of(svg);
  for (const DrawnText& one : texts_of(svg)) {
    EXPECT_GE(one.left(), 0.0) << one.text;
    EXPECT_LE(one.right(), frame.width) << one.text;
    EXPECT_GE(one.y, 0.0) << one.text;
    EXPECT_LE(one.y, frame.height) << one.text;
  }
}

/// All that is written, without spaces, for lines may break at any of them.
std::string written_in(const std::string& svg) {
  std::string all;
  for (const DrawnText& one : texts_of(svg)) all += one.text;
  std::erase(all, ' ');
  return all;
}

RankedModel three_effects(const std::string& side, double gain) {
  RankedModel model;
  model.effects = {{"coulomb_friction", "joint." + side + "_hip_flexion_extension", {}},
                   {"cogging_torque", "joint." + side + "_hip_flexion_extension", {}},
                   {"joint_compliance", "joint." + side + "_knee_flexion_extension", {}}};
  model.gain = {gain, 0.1, gain - 0.2, gain + 0.2};
  return model;
}

Diagnosis three_found() {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::effect_found;
  diagnosis.probability = 0.93;
  diagnosis.ranking = {three_effects("left", 1.8), three_effects("right", 0.9)};
  diagnosis.horizons = {{0.1, "angle", "rad", 1e-3, 12e-3, 1e-3, std::nan(""), std::nan("")}};
  return diagnosis;
}

std::string ranking_of(const Diagnosis& diagnosis, const std::string& title) {
  const TestFolder folder;
  draw_diagnosis(diagnosis, title, folder.path());
  return read_bytes(folder / "ranking.svg");
}

TEST(FigureLayout, HoldsSetsOfThreeEffectsWhole) {
  const std::string svg = ranking_of(three_found(), "a rig with a long name · revision 12");
  expect_within_frame(svg);
  for (const char* side : {"left", "right"})
    EXPECT_THAT(
        written_in(svg),
        HasSubstr(std::string("coulomb_friction@joint.") + side + "_hip_flexion_extension+cogging_torque@joint." +
                  side + "_hip_flexion_extension+joint_compliance@joint." + side + "_knee_flexion_extension"));
  EXPECT_THAT(written_in(svg), HasSubstr("cross-validatedgainoverthethreeshortesthorizons"));
}

TEST(FigureLayout, GivesALongNameLinesThatDoNotRunIntoTheNext) {
  const std::vector<DrawnText> texts = texts_of(ranking_of(three_found(), "rig"));
  std::vector<double> rows;
  for (const DrawnText& one : texts)
    if (one.anchor == "end" && one.text.find("joint") != std::string::npos) rows.push_back(one.y);
  std::sort(rows.begin(), rows.end());
  ASSERT_GT(rows.size(), 4U);
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GE(rows[i] - rows[i - 1], 13.0) << "px, a line of letters";
}

TEST(FigureLayout, BreaksALongTitleAndPutsItsLinesAboveEverything) {
  std::string title;
  for (int i = 0; i < 30; ++i) title += "a-long-name ";
  const std::string svg = ranking_of(three_found(), title);
  expect_within_frame(svg);
  std::vector<DrawnText> lines;
  double next = std::numeric_limits<double>::infinity();
  for (const DrawnText& one : texts_of(svg))
    if (one.text.find("a-long-name") != std::string::npos)
      lines.push_back(one);
    else
      next = std::min(next, one.y);
  ASSERT_GE(lines.size(), 3U);
  for (const DrawnText& line : lines) EXPECT_LT(line.y, next + 25.0) << "the verdict is the end of the title";
}

TEST(FigureLayout, HoldsNamesOfRevisionsBelowTheAxis) {
  Panel panel{"RMSE [rad]", {{"fit", Mark::line_points, kBlue, {}, {}, {}}}, 1.0, {}};
  for (int i = 0; i < 8; ++i) {
    panel.x_names.push_back(std::to_string(i) + " + coulomb_friction @ joint.left_hip_flexion_extension");
    panel.series[0].x.push_back(i);
    panel.series[0].y.push_back(9.0 - i);
  }
  const std::string svg = svg_of({"rig", "", {panel}});
  static const std::regex kTurned("translate\\(([-0-9.]+),([-0-9.]+)\\) rotate\\(40");
  const FrameSize frame = frame_of(svg);
  int turned = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), kTurned), end; it != end; ++it, ++turned) {
    const double length = kNarrowLetter * static_cast<double>(letters_of(panel.x_names[0]));
    EXPECT_LE(std::stod((*it)[1]) + 0.766 * length, frame.width);
    EXPECT_LE(std::stod((*it)[2]) + 0.643 * length, frame.height);
  }
  EXPECT_EQ(turned, 8);
}

TEST(RankingPicture, NamesNoAnswerWhereNothingIsMissing) {
  Diagnosis diagnosis = three_found();
  diagnosis.verdict = Verdict::nothing_missing;
  EXPECT_THAT(ranking_of(diagnosis, "bench"), Not(HasSubstr(">answer<")));
}

TEST(FigureLegend, LeavesOutWhatIsNotToBeSeen) {
  const double none = std::nan("");
  Figure figure{"a failed trial",
                "time [s]",
                {{"angle [rad]",
                  {{"measured", Mark::line, kInk, {0, 1}, {0.1, 0.2}, {}},
                   {"predicted", Mark::line, kBlue, {0, 1}, {none, none}, {}},
                   {"noise floor", Mark::level, kGrey, {}, {none}, {}}},
                  1.0,
                  {}}}};
  const std::string svg = svg_of(figure);
  EXPECT_THAT(svg, HasSubstr(">measured<"));
  EXPECT_THAT(svg, Not(HasSubstr("predicted")));
  EXPECT_THAT(svg, Not(HasSubstr("noise floor")));
  figure.panels[0].series.erase(figure.panels[0].series.begin());
  EXPECT_THAT(svg_of(figure), HasSubstr("angle [rad]")) << "axes alone";
}

std::vector<int> decades_of(const std::vector<double>& ticks) {
  std::vector<int> decades;
  for (const double tick : ticks) decades.push_back(static_cast<int>(std::lround(std::log10(tick))));
  return decades;
}

TEST(LogAxis, IsNumberedWhereNumbersStayApart) {
  EXPECT_THAT(log_ticks(0.95, 11.0, 0.06), ElementsAre(1, 2, 3, 5, 10));
  EXPECT_THAT(log_ticks(0.95, 11.0, 0.01), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_THAT(decades_of(log_ticks(1e-12, 1e12, 0.1)), ElementsAre(-12, -9, -6, -3, 0, 3, 6, 9, 12));
  EXPECT_THAT(decades_of(log_ticks(1e-300, 1e300, 0.2)), ElementsAre(-200, 0, 200));
  const std::vector<double> close = log_ticks(0.11, 0.18, 0.1);
  ASSERT_GE(close.size(), 2U) << "no power of ten lies within";
  for (std::size_t i = 1; i < close.size(); ++i)
    EXPECT_GE(std::log(close[i] / close[i - 1]), 0.0999 * std::log(0.18 / 0.11));
}

TEST(LogAxis, HasNoNumberTwiceAndNoneOverAnother) {
  Figure figure{"errors", "horizon [s]", {}};
  for (const double highest : {0.18, 1e12}) {
    Panel panel{"angle [rad]", {{"", Mark::line_points, kBlue, {0.1, 0.5, 2.0}, {0.11, 0.13, highest}, {}}}, 1.0, {}};
    panel.log_y = true;
    figure.panels.push_back(panel);
  }
  figure.log_x = true;
  figure.height = 460;
  const std::string svg = svg_of(figure);
  std::vector<DrawnText> numbers;
  for (const DrawnText& one : texts_of(svg))
    if (one.text.find_first_not_of("0123456789.e+-") == std::string::npos) numbers.push_back(one);
  ASSERT_GE(numbers.size(), 8U);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const bool level = std::abs(numbers[i].y - numbers[j].y) < 12.0;
      const bool beside = numbers[i].left() < numbers[j].right() && numbers[j].left() < numbers[i].right();
      EXPECT_FALSE(level && beside) << numbers[i].text << " and " << numbers[j].text;
    }
  std::set<std::string> below;
  for (const DrawnText& one : numbers)
    if (one.anchor == "middle") {
      EXPECT_TRUE(below.insert(one.text).second) << one.text << " twice";
    }
  EXPECT_GE(below.size(), 3U);
}

TEST(ComparisonPictures, DrawMeasuredBroadlyBelowPredicted) {
  TrialComparison trial;
  trial.trial = "sine";
  trial.times = Eigen::VectorXd::LinSpaced(50, 0.0, 1.0);
  trial.measured = trial.predicted = TimeSeries::Samples(trial.times.array().sin().matrix());
  trial.residuals = TimeSeries::Samples::Zero(50, 1);
  trial.channels.resize(1);
  trial.channels[0].channel = "angle";
  trial.channels[0].unit = "rad";
  Comparison comparison;
  comparison.trials = {trial};
  const TestFolder folder;
  FileNames names;
  const std::string svg = read_bytes(draw_comparison(comparison, "rig", folder.path(), names).at(0));
  const auto widest = [&](const char* from, const char* to) {
    double width = 0.0;
    const std::size_t end = svg.find(to, svg.find(from) + 1);
    for (std::size_t at = svg.find("stroke-width=\"", svg.find(from)); at < end;
         at = svg.find("stroke-width=\"", at + 1))
      width = std::max(width, std::stod(svg.substr(at + 14)));
    return width;
  };
  const double measured = widest("gnuplot_plot_1", "gnuplot_plot_2"),
               predicted = widest("gnuplot_plot_2", "gnuplot_plot_1");
  EXPECT_GE(measured, 2.0 * predicted) << "it is drawn first, and seen where both are the same";
}

TEST(RunPictures, WriteNoUnitWhereThereIsNone) {
  DrawnRun run;
  run.record.free = {{"effect.drag.exponent", "1", 1.0, 7.0, 1.0}};
  run.record.truth = {std::nan("")};
  run.passes.push_back({.number = 1, .best_model = 3, .best_score = 0.1, .best_values = {2.0}});
  for (const NamedFigure& named : run_figures({run}, "title"))
    for (const Panel& panel : named.figure.panels) {
      EXPECT_THAT(panel.y_label, Not(HasSubstr("(1)")));
      for (const Series& series : panel.series) EXPECT_NE(series.label, "truth") << "none is known";
    }
}

}  // namespace
}  // namespace lacuna
