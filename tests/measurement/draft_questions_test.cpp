#include "app/workspace/draft_questions.h"

#include "new_command_fixture.h"

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(NewCommand, DraftsARecordingForEachRunOfAnExport) {
  std::string text = "\"Time (s) Run #1\";\"Position (m) Run #1\";\"Time (s) Run #2\";\"Position (m) Run #2\"\r\n";
  for (int i = 0; i < 100; ++i)
    text += fmt::format("0,{0:03};0,{1:03};{2}\r\n", 10 * i, 400 + i % 7,
                        i < 80 ? fmt::format("0,{:03};0,{:03}", 10 * i, 300 + i % 5) : ";");
  const Outcome outcome = run_new({folder_.write("run.csv", text)});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  runs               run.csv[Run #1]: 100 samples, 0.99 s\n"
                                     "                     run.csv[Run #2]: 80 samples, 0.79 s\n"
                                     "  held out           run.csv[Run #2] (the last run)\n"));
  EXPECT_THAT(text_of(rig()),
              HasSubstr("[[target.recording]]\nfile = \"run.csv\"\ntable = \"Run #2\"\nrole = \"holdout\""));
  const Recording recording = expect_a_draft_that_works();
  ASSERT_EQ(recording.trials.size(), 2u);
  EXPECT_EQ(recording.trials[1].measured.times.size(), 80);
}

/// A pendulum of 0.3 m in a video; every second point is `off` too far from the pivot, the others too near, m.
std::string tracked_mass(double off) {
  std::string text = "mass_A\t\t\nt\tx\ty\n";
  for (int i = 0; i < 150; ++i) {
    const double q = 0.6 * std::cos(5.5 * i / 30.0), radius = 0.3 + (i % 2 == 0 ? off : -off);
    text += fmt::format("{:.6f}\t{:.6f}\t{:.6f}\n", i / 30.0, radius * std::sin(q), -radius * std::cos(q));
  }
  return text;
}

TEST_F(NewCommand, MakesAnAngleOfATrackedMass) {
  const Outcome outcome = run_new({folder_.write("run.txt", tracked_mass(0.0))});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("angle            column x and y in m (x and y move on a circle)"));
  EXPECT_THAT(outcome.out, HasSubstr("track              points on a circle of radius 0.3 m about ("));
  EXPECT_THAT(text_of(rig()), HasSubstr("angle = { column = \"x\", y = \"y\", unit = \"m\", pivot = ["));
  const Recording recording = expect_a_draft_that_works();
  EXPECT_NEAR(recording.trials.front().measured.samples(0, 0), 0.6, 1e-3);
}

TEST_F(NewCommand, TakesTheNoiseOfATrackedMassFromItsCircle) {
  const Outcome outcome = run_new({folder_.write("run.txt", tracked_mass(0.003))});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(text_of(rig()), HasSubstr("zero = \"-90 deg\", noise = \"0.01 rad\" }"));
  expect_a_draft_that_works();
}

class DraftQuestions : public NewCommand {
 protected:
  /// What becomes of a draft's text with a blank in each line, answered so.
  static std::string answered(const std::string& text, const std::string& typed, std::string& asked) {
    RigDraft draft;
    GuessedColumn column;
    column.name = "q1";
    draft.guess.sensors.push_back({{"angle", "rad"}, column});
    std::istringstream in(typed);
    std::ostringstream out;
    std::string result = with_answers(draft, "rig.toml", text, in, out);
    asked = out.str();
    return result;
  }
  std::string asked_;
};

TEST_F(DraftQuestions, TakeTheDefaultInBrackets) {
  const std::string text = "[target.sensors]\nangle = { column = \"q1\", unit = \"FILL IN\" }\n";
  EXPECT_EQ(answered(text, "\n", asked_), "[target.sensors]\nangle = { column = \"q1\", unit = \"rad\" }\n");
  EXPECT_EQ(
      asked_,
      "rig.toml: press Enter to take the value in brackets\n[target.sensors] angle: the unit of column q1 [rad]: ");
  EXPECT_THAT(answered(text, "deg\n", asked_), HasSubstr("unit = \"deg\""));
}

TEST_F(DraftQuestions, AreAskedAgainWithTheReason) {
  const std::string text = "[target.sensors]\nangle = { column = \"q1\", unit = \"FILL IN\" }\n";
  EXPECT_THAT(answered(text, "N*m\ndegrees\ndeg\n", asked_), HasSubstr("unit = \"deg\""));
  EXPECT_THAT(asked_, HasSubstr("the channel is in rad"));
  EXPECT_THAT(asked_, HasSubstr("known units are"));
}

TEST_F(DraftQuestions, LeaveBlankWhatNobodyAnswers) {
  const std::string text = "[body.arm]\nmass = \"FILL IN kg\"  # all that moves\ncom = [0.0, 0.0, \"FILL IN m\"]\n";
  EXPECT_EQ(answered(text, "0.5\n\n", asked_),
            "[body.arm]\nmass = \"0.5 kg\"  # all that moves\ncom = [0.0, 0.0, \"FILL IN m\"]\n");
  EXPECT_THAT(asked_, HasSubstr("[body.arm] mass: a number in kg (all that moves) [leave blank]: "));
  EXPECT_THAT(asked_, HasSubstr("[body.arm] com[2]: a number in m [leave blank]: "));
  EXPECT_EQ(answered(text, "", asked_), text) << "the input has ended";
  EXPECT_THAT(asked_, Not(HasSubstr("com"))) << "nobody is there to ask";
  EXPECT_THAT(answered(text, "500 g\n-20 cm\n", asked_), HasSubstr("com = [0.0, 0.0, \"-20 cm\"]"));
}

TEST_F(NewCommand, CallsADraftedSetPointSo) {
  std::string text = "t,q_des_rad,q_rad,tau_Nm\n";
  for (int i = 0; i < 100; ++i)
    text += fmt::format("{:.2f},{:.5f},{:.5f},{:.5f}\n", 0.01 * i, std::sin(0.1 * i), 0.9 * std::sin(0.1 * i - 0.2),
                        5.0 * (std::sin(0.1 * i) - 0.9 * std::sin(0.1 * i - 0.2)));
  const Outcome outcome = run_new({folder_.write("run.csv", text)});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("set point          column q_des_rad in rad"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("not used")));
  EXPECT_THAT(text_of(rig()), Not(HasSubstr("# not used")));
  EXPECT_THAT(text_of(rig()), HasSubstr("# motor = { reads = \"angle\", reference = { column = \"q_des_rad\""));
}

TEST_F(NewCommand, DraftsBoundsAboutTheRobotsOwnValues) {
  folder_.write("mine.toml", kPivot);
  ASSERT_EQ(run_new_of(folder_.write("run.csv", "t,theta_deg,tau_Nm\n0,1,2\n0.1,2,3\n0.2,1,2\n"), "mine.toml").code, 0);
  EXPECT_THAT(text_of(rig()), HasSubstr("# \"body.rod.mass\" = [\"0.25 kg\", \"1 kg\"]"));
}

}  // namespace
}  // namespace lacuna
