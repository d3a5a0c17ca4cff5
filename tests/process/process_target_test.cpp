#include "process/process_target.h"

#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <thread>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr const char* kRig = LACUNA_SOURCE_DIRECTORY "/tests/process/rig.py";

/// Asks for its last reading of the angle as a torque, but for more than the motor can give where that is 0.
class Echo : public Controller {
 public:
  int state_size() const override { return 1; }
  void act(double, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    commands[0] = state[0]++ == 0.0 ? 1.0 : sensors[0];
  }
};

class OutsideTarget : public testing::Test {
 protected:
  OutsideTarget() { setting_.source.start_limit = 60.0; }  // s; the machine may be busy
  ProcessTarget& rig(const std::string& fault) {
    setting_.source.command = {"python3", kRig, fault};
    setting_.source.folder = folder_.path();
    setting_.location = {"rig.toml", 3, 1};
    setting_.space = space_of_rig();
    setting_.coordinates = {"hinge"};
    setting_.note = [this](const std::string& note) { notes_ += note + "\n"; };
    target_ = std::make_unique<ProcessTarget>(setting_);
    return *target_;
  }

  static TestSpace space_of_rig() { return {{{"angle", "rad"}}, {{"motor", "N*m"}}, {-0.6}, {0.6}, 0.01, 0.0}; }
  /// A constant torque for 0.1 s.
  static lacuna::Test series(double torque) {
    lacuna::Test test;
    test.duration = 0.1;
    CommandSeries commands;
    commands.series = {{{"motor", "N*m"}}, Eigen::Vector2d(0.0, 0.05), TimeSeries::Samples::Constant(2, 1, torque)};
    test.drive = commands;
    return test;
  }
  /// One whose message is longer than a pipe takes at once.
  static lacuna::Test long_series() {
    lacuna::Test test = series(0.2);
    std::get<CommandSeries>(test.drive).series = {{{"motor", "N*m"}},
                                                  Eigen::VectorXd::LinSpaced(20'000, 0.0, test.duration),
                                                  TimeSeries::Samples::Constant(20'000, 1, 0.2)};
    return test;
  }
  static lacuna::Test controlled() {
    lacuna::Test test;
    test.duration = 0.1;
    test.drive = std::make_shared<const Echo>();
    return test;
  }

  /// What a trial of a rig with that fault fails with.
  std::string complaint(const std::string& fault, const lacuna::Test& test = series(0.2)) {
    try {
      rig(fault).carry_out(test);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing failed";
  }

  TestFolder folder_;
  ProcessTargetSetting setting_;
  std::string notes_;
  std::unique_ptr<ProcessTarget> target_;
};

TEST_F(OutsideTarget, TakesAWholeSeriesInItsUnitsAndAnswersInThem) {
  ProcessTarget& target = rig("none");
  EXPECT_EQ(target.hello().name, "test rig");
  const Trial trial = target.carry_out(series(0.2));
  ASSERT_EQ(trial.measured.channels, (std::vector<Channel>{{"angle", "rad"}})) << "the model has no heat";
  ASSERT_EQ(trial.measured.times.size(), 11);
  EXPECT_DOUBLE_EQ(trial.measured.times[10], 0.1);
  EXPECT_NEAR(trial.measured.samples(10, 0), 100.0 * kDegree, 1e-12) << "half of 200 mN*m, in degrees";
  EXPECT_NEAR(trial.sensor_noise[0], 0.1 * kDegree, 1e-12);
  EXPECT_EQ(trial.commands.series.channels, (std::vector<Channel>{{"motor", "N*m"}}));
  EXPECT_EQ(trial.commands.series.samples(0, 0), 0.2);
  EXPECT_TRUE(trial.initial.empty()) << "it says nothing of its start";
}

TEST_F(OutsideTarget, ExchangesCommandsForReadingsEveryPeriod) {
  const Trial trial = rig("only exchange").carry_out(controlled());
  ASSERT_EQ(trial.measured.times.size(), 11);
  EXPECT_EQ(trial.measured.samples(0, 0), 0.0);
  EXPECT_EQ(trial.commands.series.samples(0, 0), 0.6) << "1 N*m was asked for";
  EXPECT_NEAR(trial.measured.samples(1, 0), 300.0 * kDegree, 1e-12);
  EXPECT_THAT(notes_, HasSubstr("commands of \"motor\" were beyond the target's limits"));
}

TEST_F(OutsideTarget, GetsASeriesPeriodByPeriodWhereItTakesItSo) {
  const Trial whole = rig("only series").carry_out(series(0.2));
  const Trial pieces = rig("only exchange").carry_out(series(0.2));
  EXPECT_EQ(pieces.commands.series.samples(9, 0), 0.2);
  EXPECT_EQ(pieces.measured.samples(10, 0), whole.measured.samples(10, 0));
}

TEST_F(OutsideTarget, GetsTheCommandsThatAreDueThoughItsClockWavers) {
  lacuna::Test test = series(0.0);
  CommandSeries& commands = std::get<CommandSeries>(test.drive);
  commands.series.times = Eigen::VectorXd::LinSpaced(10, 0.0, 0.09);
  commands.series.samples = Eigen::VectorXd::LinSpaced(10, 0.0, 0.45);
  const Trial trial = rig("wavers").carry_out(test);
  ASSERT_EQ(trial.commands.series.samples.rows(), 10);
  for (Eigen::Index k = 0; k < 10; ++k)
    EXPECT_NEAR(trial.commands.series.samples(k, 0), 0.05 * static_cast<double>(k), 1e-12) << "period " << k;
  EXPECT_NEAR(trial.commands.series.times[1], 0.006, 1e-12) << "as it was applied";
}

TEST_F(OutsideTarget, IsToldTheTrialAndASeedThatDependsOnItAlone) {
  const auto told = [this](std::uint64_t number) {
    rig("echoes").begin_trial(number);
    try {
      target_->carry_out(series(0.2));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string fourth = told(4);
  EXPECT_THAT(fourth,
              AllOf(HasSubstr("\"trial\": 4"), HasSubstr("\"duration\": 0.1, \"period\": 0.01, \"periods\": 10")));
  EXPECT_EQ(told(4), fourth);
  const auto seed_in = [](const std::string& text) { return text.substr(text.find("\"seed\""), 24); };
  EXPECT_NE(seed_in(told(5)), seed_in(fourth));
}

TEST_F(OutsideTarget, StatesItsStartWhereItKnowsIt) {
  const Trial trial = rig("knows its start").carry_out(series(0.2));
  ASSERT_EQ(trial.initial.size(), 1U);
  EXPECT_EQ(trial.initial[0].knowledge, InitialKnowledge::given);
  EXPECT_EQ(trial.initial[0].position, 0.25);
  EXPECT_THAT(complaint("other joint"), HasSubstr("\"knee\", which is not a joint of the model"));
  const Trial late = rig("measures late").carry_out(series(0.2));
  EXPECT_EQ(late.initial[0].position, 0.25);
  ASSERT_EQ(late.measured.times.size(), 11);
  EXPECT_EQ(late.measured.times[0], 0.0) << "the start is that at 0 s";
  EXPECT_TRUE(std::isnan(late.measured.samples(0, 0)));
  EXPECT_DOUBLE_EQ(late.measured.times[1], 0.01);
  EXPECT_FALSE(std::isnan(late.measured.samples(1, 0)));
  EXPECT_THAT(complaint("begins early", controlled()),
              HasSubstr("stated its initial state at 0 s, but its readings begin at -0.004 s"));
}

TEST_F(OutsideTarget, ThatDoesNotFitTheModelIsWrongInputWithAllOfIt) {
  const auto problems = [this](const std::string& fault) {
    std::string all;
    try {
      rig(fault).hello();
    } catch (const BadInput& bad) {
      for (const Problem& problem : bad.problems()) all += to_string(problem.location) + " " + problem.message + "\n";
    }
    return all;
  };
  EXPECT_THAT(problems("wrong units"),
              HasSubstr("rig.toml:3:1 the target's sensor \"angle\" is in m, the model's in rad"));
  EXPECT_THAT(problems("wrong names"), AllOf(HasSubstr("which the target does not have (did you mean \"angel\"?)"),
                                             HasSubstr("the actuator \"brake\", which the model does not have")));
  EXPECT_THAT(problems("narrow"), HasSubstr("from -0.6 to 0.6 N*m, the target takes -0.1 to 0.1 N*m"));
  setting_.source.command = {"no-such-program"};
  EXPECT_THROW(ProcessTarget(setting_).hello(), BadInput);
}

TEST_F(OutsideTarget, SaysHowAHelloFails) {
  EXPECT_THAT(complaint("crashes in hello"),
              AllOf(HasSubstr("ended with exit code 3"), HasSubstr("no rig at /dev/ttyUSB0"), HasSubstr(kRig)));
  EXPECT_THAT(complaint("prints"),
              AllOf(HasSubstr("\"Rig driver 1.2 ready\""), HasSubstr("may contain only messages")));
  EXPECT_THAT(complaint("huge line"), HasSubstr("a line of more than 64 MiB"));
  EXPECT_THAT(complaint("closes its output"), HasSubstr("closed its standard output"));
  EXPECT_THAT(complaint("is sick"), HasSubstr("says: the motor's power is off"));
  const std::string wrong = complaint("wrong hello");
  EXPECT_THAT(wrong, AllOf(HasSubstr("lacuna-process/9"), HasSubstr("\"modes\""), HasSubstr("furlong"),
                           HasSubstr("sensors[1] has no text \"unit\""),
                           HasSubstr("sensors[1] repeats the name \"angle\""), HasSubstr("not below its \"upper\"")));
}

TEST_F(OutsideTarget, SaysHowATrialFails) {
  EXPECT_THAT(complaint("dies"), AllOf(HasSubstr("ended with exit code 3"), HasSubstr("over-current")));
  EXPECT_THAT(complaint("leaves a helper"), AllOf(HasSubstr("ended with exit code 3"), HasSubstr("over-current")));
  EXPECT_THAT(complaint("is killed"), HasSubstr("was ended by signal 11 (Segmentation fault)"));
  EXPECT_THAT(complaint("refuses"), HasSubstr("says: the arm is not at rest"));
  EXPECT_THAT(complaint("refuses in colour"), AllOf(HasSubstr("says: .[31mzu heiß.[0m!!"), testing::EndsWith("!!...")));
  EXPECT_THAT(complaint("half an answer"), HasSubstr("ended with exit code 0 in the middle of a line"));
  EXPECT_THAT(complaint("other type"), HasSubstr("of type \"banana\" instead of type \"samples\""));
  EXPECT_THAT(complaint("nan"), HasSubstr("NaN or Infinity"));
  EXPECT_THAT(complaint("huge"), HasSubstr("a number that is too large for a double"));
  EXPECT_THAT(complaint("absurd"),
              HasSubstr("sent 1e+308 deg for \"angle\" at 0.01 s, outside the range of this sensor"));
  EXPECT_THAT(complaint("absurd", controlled()), HasSubstr("sent 1e+308 deg for \"angle\""));
  EXPECT_THAT(complaint("beyond its range"),
              HasSubstr("sent -181 deg for \"angle\" at 0.01 s, outside the range of this sensor: its least is -180"));
  EXPECT_EQ(complaint("cold"), "nothing failed") << "the model has no heat";
  EXPECT_THAT(complaint("nothing measured"), HasSubstr("no reading of \"angle\""));
  EXPECT_THAT(complaint("too few"),
              HasSubstr("too few samples: they cover 0 s to 0.02 s, but the test lasts from 0 to 0.1 s"));
  EXPECT_THAT(complaint("short rows"), HasSubstr("\"samples\"[0] is not a list of 2 numbers"));
  EXPECT_THAT(complaint("times stand still"), HasSubstr("\"times\" do not increase"));
  EXPECT_THAT(complaint("out of step", controlled()),
              HasSubstr("is out of step: readings 2 of the test are due at 0.02 s"));
  EXPECT_THAT(complaint("only series", controlled()), HasSubstr("takes only whole command series"));
}

TEST_F(OutsideTarget, HasTimeLimits) {
  setting_.source.trial_limit = 2.0;  // s; the program runs by then
  EXPECT_THAT(complaint("hangs"),
              AllOf(HasSubstr("did not answer in time"), HasSubstr("target.trial_limit, 2 s beyond the test's 0.1 s")));
  EXPECT_THAT(complaint("half a line"), HasSubstr(R"(did not finish its line in time, "{"type": "sam" so far)"));
  setting_.source.start_limit = 0.5;
  EXPECT_THAT(complaint("hangs in hello"),
              AllOf(HasSubstr("did not answer in time"), HasSubstr("target.start_limit, 0.5 s")));
  EXPECT_THAT(complaint("reads nothing"), HasSubstr("did not answer in time"));
}

TEST_F(OutsideTarget, MayHaveAllTheTimeThereIs) {
  setting_.source.start_limit = setting_.source.trial_limit = 1e300;  // s
  EXPECT_EQ(rig("none").carry_out(series(0.2)).measured.times.size(), 11);
}

TEST_F(OutsideTarget, TakesASeriesLongerThanAPipeWhileItWritesItself) {
  EXPECT_EQ(rig("none").carry_out(long_series()).measured.times.size(), 11);
  EXPECT_EQ(rig("writes while it is sent").carry_out(long_series()).measured.times.size(), 11);
}

TEST_F(OutsideTarget, ThatReadsNoMoreFailsTheTrial) {
  setting_.source.trial_limit = 2.0;  // s; the program runs by then
  EXPECT_THAT(complaint("reads no more", long_series()), HasSubstr("does not read its standard input"));
  EXPECT_THAT(complaint("closes its input", long_series()), HasSubstr("closed its standard input"));
}

TEST_F(OutsideTarget, ThatTalksWithoutEndIsStopped) {
  EXPECT_THAT(complaint("talks without end", long_series()),
              testing::AnyOf(HasSubstr("an answer of more than 64 MiB, which begins with \"I am well."),
                             HasSubstr("an unexpected line, \"I am well\"")));
}

TEST_F(OutsideTarget, IsSentNothingBeyondItsLimits) {
  const std::string refused = complaint("none", series(0.7));
  EXPECT_THAT(refused, AllOf(HasSubstr("accepts -600 to 600 mN*m for \"motor\""), HasSubstr("nothing was sent")));
  EXPECT_EQ(target_->carry_out(series(0.6)).measured.times.size(), 11) << "the program is as it was";
}

TEST_F(OutsideTarget, AReadingThatIsMissingIsNone) {
  const Trial trial = rig("a gap").carry_out(series(0.2));
  EXPECT_TRUE(std::isnan(trial.measured.samples(1, 0)));
  EXPECT_FALSE(std::isnan(trial.measured.samples(2, 0)));
  EXPECT_THAT(complaint("a gap", controlled()), HasSubstr("sent null for \"angle\", which the controller of the test"));
}

TEST_F(OutsideTarget, SensorsThatTheModelHasNotNeedNotMeasure) {
  EXPECT_EQ(rig("no heat").carry_out(series(0.2)).measured.times.size(), 11);
  EXPECT_EQ(rig("no heat").carry_out(controlled()).measured.times.size(), 11);
}

TEST_F(OutsideTarget, IsStartedAgainAfterItFailed) {
  ProcessTarget& target = rig("dies once");
  EXPECT_THROW(target.carry_out(series(0.2)), Error);
  EXPECT_EQ(target.carry_out(series(0.2)).measured.times.size(), 11);
}

TEST_F(OutsideTarget, ThatCannotBeStartedAgainFailsATrialAndIsNoWrongInput) {
  setting_.source.folder = folder_.path() / "rig";
  std::filesystem::create_directory(setting_.source.folder);
  setting_.source.command = {"python3", kRig, "dies once"};
  setting_.space = space_of_rig();
  ProcessTarget target(setting_);
  EXPECT_THROW(target.carry_out(series(0.2)), Error);
  std::filesystem::remove_all(setting_.source.folder);
  try {
    target.carry_out(series(0.2));
    FAIL() << "it has no folder to work in";
  } catch (const BadInput&) {
    FAIL() << "a run would not try again";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("was started again and has changed"), HasSubstr("cannot be started")));
  }
}

TEST_F(OutsideTarget, ThatEndsBetweenTwoTrialsIsStartedAgain) {
  ProcessTarget& target = rig("dies afterwards");
  EXPECT_EQ(target.carry_out(series(0.2)).measured.times.size(), 11);
  for (int i = 0; i < 6000 && notes_.empty(); ++i) {  // until its end is seen
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    target.hello();
  }
  EXPECT_THAT(notes_, HasSubstr("has ended since its last trial; it is started again"));
  EXPECT_EQ(target.carry_out(series(0.2)).measured.times.size(), 11);
}

TEST_F(OutsideTarget, ALineThatNobodyAskedForFailsTheNextTrialAlone) {
  ProcessTarget& target = rig("talks on");
  target.carry_out(series(0.2));
  std::string said;
  for (int i = 0; i < 3 && said.empty(); ++i) try {
      target.carry_out(series(0.2));
    } catch (const Error& error) {
      said = error.what();
    }
  EXPECT_THAT(said, testing::AnyOf(HasSubstr("an unexpected line"), HasSubstr("of type \"by the way\"")));
  EXPECT_EQ(target.carry_out(series(0.2)).measured.times.size(), 11);
}

TEST_F(OutsideTarget, AnAnswerToAnEarlierTestIsNoDataOfTheNext) {
  const auto second = [this](const std::string& fault) {
    ProcessTarget& target = rig(fault);
    try {
      target.carry_out(series(0.2));
    } catch (const Error& refused) {
      EXPECT_THAT(refused.what(), HasSubstr("took too long")) << fault;
    }
    try {
      target.carry_out(series(-0.2));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing failed");
  };
  const auto is_told = AllOf(HasSubstr(kRig), HasSubstr("answered with \"id\" \"1\" instead of 2"));
  EXPECT_THAT(second("answers twice"), is_told);
  EXPECT_THAT(second("refuses, and answers late"), is_told) << "of the same trial";
  EXPECT_THAT(second("refuses late"), is_told) << "the second test was not refused";
  const Trial afterwards = target_->carry_out(series(0.2));
  EXPECT_NEAR(afterwards.measured.samples(10, 0), 100.0 * kDegree, 1e-12) << "half of 200 mN*m, in degrees";
}

TEST_F(OutsideTarget, ThatRepeatsNoIdIsToldToAddIt) {
  EXPECT_THAT(complaint("repeats no id"), HasSubstr("\"id\" is missing, the number of the test; repeat the \"id\""));
  EXPECT_THAT(complaint("is of before"),
              AllOf(HasSubstr("it speaks \"lacuna-process/1\", this program lacuna-process/2"),
                    HasSubstr("repeat the \"id\" of the test's message")));
}

TEST_F(OutsideTarget, MayWriteAnythingToStandardError) {
  EXPECT_EQ(rig("floods standard error").carry_out(series(0.2)).measured.times.size(), 11);
}

TEST_F(OutsideTarget, IsEndedWithThisObjectThoughItWouldStay) {
  rig("stays").hello();
  pid_t process = 0;
  std::ifstream(folder_.path() / "pid") >> process;
  ASSERT_GT(process, 0);
  EXPECT_EQ(kill(process, 0), 0) << "it runs";
  const auto begin = std::chrono::steady_clock::now();
  target_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_NE(kill(process, 0), 0) << "it is gone";
}

TEST_F(OutsideTarget, AnswersToATestThatStartsElsewhereWithANo) {
  lacuna::Test test = series(0.2);
  test.start.positions = {0.5};
  EXPECT_THAT(complaint("none", test), HasSubstr("has another initial state"));
}

}  // namespace
}  // namespace lacuna
