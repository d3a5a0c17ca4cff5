#include "report/figures/history_picture.h"
#include "report/json/history_json.h"
#include "report/text/history_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

HistoryRow row(int number, const std::string& change, double fit, double held_out, double times_floor) {
  HistoryRow row;
  row.number = number;
  row.change = change;
  row.channel = "angle";
  row.unit = "rad";
  row.fit_rmse = fit;
  row.held_out_rmse = held_out;
  row.floor = 1e-3;
  row.times_floor = times_floor;
  return row;
}

TEST(HistoryText, SaysWhichErrorsAreOfTheFitFilesAlone) {
  const std::string text =
      history_text({row(1, "rigid", 8e-3, kNotKnown, 8.0), row(2, "friction", 1e-3, 1e-3, 1.0)}, 1);
  EXPECT_THAT(text, HasSubstr("-               8.0  ████████████████████████ fit files\n"));
  EXPECT_THAT(text, HasSubstr("1.00 mrad               1.0  ███\n"));
  EXPECT_THAT(text, HasSubstr("held-out trials compared 1 time\n"));
}

TEST(HistoryText, TakesFitFilesForGrantedWhereNothingIsHeldOut) {
  EXPECT_THAT(history_text({row(1, "rigid", 8e-3, kNotKnown, 8.0)}, 0), Not(HasSubstr("fit files")));
}

TEST(HistoryText, ShowsRevisionsThatWereNeverComparedOrNeverFitted) {
  HistoryRow fitted = row(1, "rigid", kNotKnown, kNotKnown, kNotKnown);
  fitted.channel.clear();
  fitted.fitted = true;
  HistoryRow interrupted = fitted;
  interrupted.fitted = false;
  EXPECT_THAT(history_text({fitted}, 0), HasSubstr("not compared"));
  EXPECT_THAT(history_text({interrupted}, 0), HasSubstr("not fitted"));
  EXPECT_THAT(history_json({interrupted}, 0), HasSubstr("\"fitted\": false"));
}

TEST(HistoryText, SaysWhichRevisionFailedOnATrial) {
  HistoryRow failed = row(2, "friction", kNotKnown, 1e-3, 1.0);
  failed.failed_trials = 1;
  const std::vector<HistoryRow> rows = {row(1, "rigid", 8e-3, 8e-3, 8.0), failed};
  EXPECT_THAT(history_text(rows, 1), HasSubstr("1.0  1 trial failed\n"));
  EXPECT_THAT(history_json(rows, 1), HasSubstr("\"failed_trials\": 1"));
  EXPECT_THAT(history_csv(rows), HasSubstr(",1,1\n"));
}

TEST(HistoryText, SaysWhereTheFloorIsNotKnown) {
  EXPECT_THAT(history_text({row(1, "rigid", 8e-3, kNotKnown, kNotKnown)}, 0), HasSubstr("floor not known"));
}

TEST(HistoryText, ShowsErrorsOverEachLengthAndWhatTheyAreOfTheFirst) {
  HistoryRow rigid = row(1, "rigid", 8e-3, 9e-3, 9.0), friction = row(2, "friction", 1e-3, kNotKnown, 1.0);
  rigid.horizons = {{0.1, 2e-3, 3e-3}, {2.0, 8e-3, 9e-3}};
  friction.horizons = {{0.1, 1e-3, kNotKnown}, {2.0, 1e-3, kNotKnown}};
  const std::string text = history_text({rigid, friction}, 1);
  EXPECT_THAT(text, testing::ContainsRegex("rev +angle +0.1 s segments +2 s segments"));
  EXPECT_THAT(text, testing::ContainsRegex("1 +fit +2.00 mrad +8.00 mrad"));
  EXPECT_THAT(text, testing::ContainsRegex("2 +fit +1.00 mrad +−50 % +1.00 mrad +−88 %"));
  EXPECT_THAT(text, testing::ContainsRegex("1 +held out +3.00 mrad +9.00 mrad"));
  EXPECT_THAT(text, Not(testing::ContainsRegex("2 +held out")));
  EXPECT_THAT(history_json({rigid}, 0), HasSubstr("\"horizon_s\": 0.1"));
}

TEST(HistoryCsv, QuotesTextsThatWouldBreakTheTable) {
  EXPECT_THAT(history_csv({row(2, "friction, \"dry\"", 1e-3, 1e-3, 1.0)}),
              HasSubstr("\n2,,\"friction, \"\"dry\"\"\",0,angle,rad,"));
}

TEST(HistoryText, EndsWithTheSetupsOfTheRecordings) {
  const std::vector<KnownSetup> loads = {
      {.names = {"heavy"}, .settings = {{"body.load.mass", 0.49, "kg"}}, .recordings = {"heavy.csv"}}};
  EXPECT_THAT(history_text({row(1, "rigid", 8e-3, kNotKnown, 8.0)}, 0, loads),
              HasSubstr("held-out trials compared 0 times\nsetup heavy: body.load.mass = 0.49 kg · heavy.csv\n"));
}

}  // namespace
}  // namespace lacuna
