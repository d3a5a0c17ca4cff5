#include "report/text/prediction_text.h"

#include "report/figures/prediction_picture.h"
#include "report/json/prediction_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace lacuna {
namespace {

/// One channel, two samples, and trials that had a twentieth of their readings at `ratio` and more.
PredictionReport report_with(std::size_t trials, double ratio) {
  PredictionReport report;
  report.experiment = "bench";
  report.run = 3;
  report.pass = 4;
  report.test = "test 17";
  report.duration = 0.5;
  report.structures = {{"", 8}};
  report.noise = {0.001};
  report.prediction.times = Eigen::Vector2d(0.0, 0.5);
  report.prediction.channels = {{"angle", "rad"}};
  report.prediction.models = 8;
  report.prediction.band = {TimeSeries::Samples::Constant(2, 1, 1.0), TimeSeries::Samples(2, 1)};
  report.prediction.band.half_width << 0.003, 0.004;
  std::vector<HeldOutTrial> held_out;
  for (std::size_t i = 0; i < trials; ++i) {
    held_out.push_back({static_cast<int>(i + 1), static_cast<int>(i + 1), {std::vector<double>(20, 0.5)}});
    held_out.back().ratios[0][0] = held_out.back().ratios[0][1] = ratio;
  }
  report.support = support_of(std::move(held_out));
  widen(report.prediction.band, report.support);
  return report;
}

TEST(PredictionText, SaysThatModelsAgreeMoreThanTheyAreRight) {
  EXPECT_EQ(prediction_text(report_with(4, 2.0)),
            "bench · run 3, pass 4 · 8 models · test 17\n"
            "channel  95 % band ±  at most ±      at  new trials inside  × spread\n"
            "angle      7.07 mrad  8.00 mrad  0.50 s               90 %         2\n"
            "4 trials were predicted before a model was fitted to them: 90 % of the readings lie within the 95 % band\n"
            "the models are less accurate than their spread suggests: the band is widened to 2 × the spread. "
            "Cross-validated (factor from the other trials): the band contains 100 % of the readings of a trial\n");
}

TEST(PredictionText, LeavesABandThatHolds) {
  const std::string text = prediction_text(report_with(4, 0.9));
  EXPECT_THAT(text, testing::HasSubstr("3.54 mrad  4.00 mrad"));
  EXPECT_THAT(text, testing::HasSubstr("the spread of the models matches their errors"));
}

TEST(PredictionText, DoesNotSpeakOfAgreementOfOneModel) {
  PredictionReport report = report_with(4, 2.0);
  report.prediction.models = 1;
  EXPECT_THAT(
      prediction_text(report),
      testing::HasSubstr(
          "the model is less accurate than the sensor noise suggests: the band is widened to 2 × the noise. Cross"));
}

TEST(PredictionText, SaysWhereTooFewTrialsSupportASpread) {
  const std::string text = prediction_text(report_with(2, 2.0));
  EXPECT_THAT(
      text, testing::HasSubstr(
                "uncalibrated: 2 trials were predicted before a model was fitted to them, and a calibration takes 3"));
  EXPECT_THAT(text, testing::HasSubstr("4.00 mrad")) << "not widened";
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("new trials inside")));
}

TEST(PredictionText, NamesStructuresLostModelsAndWhatWasNotMeasured) {
  PredictionReport report = report_with(4, 0.9);
  report.structures = {{"dry friction", 5}, {"", 3}};
  report.prediction.models = 1;
  report.copies = 3;
  report.prediction.lost = {{12, "it exploded"}};
  report.noise = {std::numeric_limits<double>::infinity()};
  report.measured = MeasuredTest{2, false, {}};
  const std::string text = prediction_text(report);
  EXPECT_THAT(text, testing::HasSubstr("carried out as trial 2, to which the models were not fitted"));
  EXPECT_THAT(text, testing::HasSubstr("dry friction       5\n-                  3\n"));
  EXPECT_THAT(text, testing::HasSubstr("1 of 2 models cannot simulate the test and is left out: it exploded"));
  EXPECT_THAT(text, testing::HasSubstr("3 of 5 models are copies of another and do not count"));
  EXPECT_THAT(text, testing::HasSubstr("a single model has no spread"));
  EXPECT_THAT(text, testing::HasSubstr("no trial measured angle"));
}

TEST(PredictionData, HasUnitsAndTheBandThatIsTold) {
  EXPECT_EQ(prediction_csv(report_with(4, 2.0).prediction),
            "t [s],angle mean [rad],angle lower [rad],angle upper [rad]\n0,1,0.994,1.006\n0.5,1,0.992,1.008\n");
  const nlohmann::json json = nlohmann::json::parse(prediction_json(report_with(4, 2.0)));
  EXPECT_EQ(json["channels"][0]["held_out"]["factor"], 2.0);
  EXPECT_EQ(json["channels"][0]["half_width"][1], 0.008);
  EXPECT_EQ(json["held_out"]["calibrated"], true);
  EXPECT_EQ(json["held_out"]["by_trial"].size(), 4U);
  EXPECT_EQ(json["models"], 8);
}

TEST(PredictionPicture, DrawsBandMeanAndReadings) {
  PredictionReport report = report_with(2, 2.0);
  report.measured = MeasuredTest{2, false, {{{"angle", "rad"}}, report.prediction.times, report.prediction.band.mean}};
  const Figure figure = prediction_figure(report);
  ASSERT_EQ(figure.panels.size(), 1U);
  ASSERT_EQ(figure.panels[0].series.size(), 3U);
  EXPECT_EQ(figure.panels[0].series[0].label, "95 % band, uncalibrated");
  EXPECT_EQ(figure.panels[0].series[0].y2[1], 1.004);
  EXPECT_EQ(figure.panels[0].series[1].label, "measured");
}

TEST(PredictionPicture, LeavesABandOutThatCannotBeSeen) {
  PredictionReport report = report_with(4, 2.0);
  report.prediction.band.half_width.setConstant(1e-9);
  EXPECT_EQ(prediction_figure(report).panels[0].series.size(), 1U);
}

TEST(PredictionPicture, PutsManyChannelsSideBySide) {
  PredictionReport report = report_with(4, 2.0);
  report.prediction.channels.assign(5, {"angle", "rad"});
  report.prediction.band = {TimeSeries::Samples::Zero(2, 5), TimeSeries::Samples::Ones(2, 5)};
  const Figure figure = prediction_figure(report);
  EXPECT_EQ(figure.columns, 2);
  EXPECT_EQ(figure.panels[1].x_label, "angle [rad], time [s]");
  EXPECT_EQ(figure.panels[0].series[0].label, "95 % band");
  EXPECT_EQ(figure.panels[1].series[0].label, "");
}

}  // namespace
}  // namespace lacuna
