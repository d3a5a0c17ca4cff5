#include "measurement/csv/csv_runs.h"
#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Three runs of 6, 4 and 5 samples side by side, the angle of run r at row i being r + i/100, as Capstone writes them.
std::string three_runs() {
  std::string text =
      "\xef\xbb\xbf\"Time (s) Run #1\";\"Angle (rad) Run #1\";\"Torque (N\xc2\xb7m) Run #1\";\"Time (s) Run "
      "#2\";\"Angle "
      "(rad) Run #2\";\"Torque (N\xc2\xb7m) Run #2\";\"Time (s) Run #3\";\"Angle (rad) Run #3\";\"Torque (N\xc2\xb7m) "
      "Run "
      "#3\"\r\n";
  constexpr int kRowsOfRun[] = {6, 4, 5};
  for (int row = 0; row < 6; ++row) {
    for (int run = 0; run < 3; ++run)
      text += (run == 0 ? "" : ";") +
              (row < kRowsOfRun[run] ? fmt::format("0,{}0;{},0{};0,5", row, run + 1, row) : std::string(";;"));
    text += "\r\n";
  }
  return text;
}

class CsvRuns : public testing::Test {
 protected:
  RecordingSource source(const std::string& text) const {
    RecordingSource source = pendulum_source(folder_.write("export.csv", text));
    source.time_column = "Time (s)";
    source.sensors[0].column = "Angle (rad)";
    source.commands[0].column = "Torque (N\xc2\xb7m)";
    return source;
  }
  RecordingSource source_of_runs(const std::vector<std::string>& runs) const {
    RecordingSource all = source(three_runs());
    const MeasuredFile file = all.files.front();
    all.files.clear();
    for (const std::string& run : runs) {
      all.files.push_back(file);
      all.files.back().table = run;
    }
    return all;
  }
  TestFolder folder_;
};

TEST_F(CsvRuns, AreTablesThatARecordingNames) {
  const Recording recording = read_pendulum(source_of_runs({"Run #3", "Run #2"}));
  ASSERT_EQ(recording.trials.size(), 2U);
  EXPECT_EQ(recording.trials[0].name, "export.csv[Run #3]");
  EXPECT_EQ(recording.trials[1].name, "export.csv[Run #2]");
  EXPECT_THAT(recording.trials[0].measured.samples.col(0), ElementsAre(3.0, 3.01, 3.02, 3.03, 3.04));
  EXPECT_THAT(recording.trials[1].measured.samples.col(0), ElementsAre(2.0, 2.01, 2.02, 2.03));
  EXPECT_THAT(notes_of(recording),
              HasSubstr("export.csv:1: the runs in this file are `Run #1`, `Run #2`, `Run #3`; not "
                        "read: `Run #1`. To read a run, write [[target.recording]] with this file "
                        "and table = \"Run #1\""));
}

TEST_F(CsvRuns, AreNotSpokenOfWhereAllAreRead) {
  EXPECT_THAT(notes_of(read_pendulum(source_of_runs({"Run #1", "Run #2", "Run #3"}))), Not(HasSubstr("not read")));
}

TEST_F(CsvRuns, HaveANoteOnTheirFileOnce) {
  const Recording recording = read_pendulum(source_of_runs({"Run #1", "Run #2", "Run #3"}));
  const auto of_commas = [](const ReadingNote& note) {
    return note.message.find("decimal commas") != std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(recording.notes, of_commas), 1);
}

TEST_F(CsvRuns, MayBeNamedInColumnsInstead) {
  RecordingSource whole = source(three_runs());
  whole.time_column = "Time (s) Run #1";
  whole.sensors[0].column = "Angle (rad) Run #1";
  whole.commands.clear();
  const Recording recording = read_pendulum(whole);
  EXPECT_EQ(recording.trials[0].measured.samples.rows(), 6);
  EXPECT_THAT(notes_of(recording), HasSubstr("not read: `Run #2`, `Run #3`"));
}

TEST_F(CsvRuns, AreToBeNamedWhereColumnsAreNot) {
  EXPECT_THAT(complaint_of(source(three_runs())),
              HasSubstr("export.csv:1: no column `Time (s)`, but one in each of the runs `Run #1`, `Run #2`, `Run #3`; "
                        "write [[target.recording]] with this file and table = \"Run #1\""));
}

TEST_F(CsvRuns, ThatAreNotThereAreNamedWithThoseThatAre) {
  EXPECT_THAT(complaint_of(source_of_runs({"Run #4"})), HasSubstr("export.csv:1: no table `Run #4`"));
  RecordingSource without = pendulum_source(folder_.write("run.csv", "t,q,u\n0,1,2\n0.1,1,2\n"));
  without.files[0].table = "Run #1";
  EXPECT_THAT(complaint_of(without), HasSubstr("no column name ends with the number of a run; leave table out"));
}

TEST_F(CsvRuns, AreReadOnceEach) {
  EXPECT_THAT(complaint_of(source_of_runs({"Run #1", "Run #1"})), HasSubstr("is named twice"));
}

TEST_F(CsvRuns, MayShareTheirTimes) {
  std::string text = "Time (s),Angle (rad) Run #1,Angle (rad) Run #2\n";
  for (int row = 0; row < 6; ++row)
    text += fmt::format("0.{0},1.0{0},{1}\n", row, row < 4 ? fmt::format("2.0{}", row) : "");
  RecordingSource shared = source(text);
  shared.commands.clear();
  shared.files[0].table = "Run #2";
  EXPECT_THAT(read_pendulum(shared).trials[0].measured.samples.col(0), ElementsAre(2.0, 2.01, 2.02, 2.03));
}

TEST_F(CsvRuns, BecomeRecordingsOfADraft) {
  const std::vector<FileSample> samples = samples_of_runs({sample_file(folder_.write("export.csv", three_runs()))});
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[1].label(), "export.csv[Run #2]");
  EXPECT_THAT(samples[1].format.names, ElementsAre("Time (s)", "Angle (rad)", "Torque (N\xc2\xb7m)"));
  EXPECT_THAT(samples[1].columns[1], ElementsAre(2.0, 2.01, 2.02, 2.03)) << "not as long as the longest run";
  const RigGuess guess = guess_rig(samples, {});
  EXPECT_EQ(guess.time.name, "Time (s)");
  const RecordingSource source = source_of(guess, {{"export.csv", "Run #1"}, {"export.csv", "Run #2"}});
  EXPECT_EQ(source.files[1].table, "Run #2");
}

TEST_F(CsvRuns, OfSeveralFilesNeedNotHaveOneName) {
  const auto file = [&](const std::string& name, const std::string& run) {
    return sample_file(folder_.write(name, "Time (s) " + run + ",Angle (rad) " + run + "\n0,1\n0.1,2\n0.2,1\n"));
  };
  const std::vector<FileSample> other = samples_of_runs({file("a.csv", "Run #1"), file("b.csv", "Run #2")});
  EXPECT_EQ(guess_rig(other, {}).sensors[0].column.name, "Angle (rad)");
  const std::vector<FileSample> same = samples_of_runs({file("c.csv", "Run #1"), file("d.csv", "Run #1")});
  EXPECT_EQ(guess_rig(same, {}).sensors[0].column.name, "Angle (rad) Run #1") << "as they are written";
}

TEST(RunsInNames, AreFoundAsProgramsWriteThem) {
  EXPECT_THAT(runs_in({"Latest: Time (s)", "Latest: Angle (rad)", "Run 1: Time (s)", "Run 1: Angle (rad)"}),
              ElementsAre("Latest", "Run 1"));
  EXPECT_THAT(runs_in({"Time (s) Run #1", "Time (s) Run #2", "note"}), ElementsAre("Run #1", "Run #2"));
  EXPECT_EQ(name_in_run("Angle (rad) Run #2", "Run #2"), "Angle (rad)");
  EXPECT_EQ(name_in_run("Angle (rad) Run #2", "Run #1"), "Angle (rad) Run #2");
}

}  // namespace
}  // namespace lacuna
