// Files that a recording format reads, not the host.

#include "measurement/guesses/file_sample.h"
#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <cmath>
#include <limits>
#include <map>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Tables that a test has made, as if ".bag" files had them.
class MadeTables : public RecordingFormats {
 public:
  struct Made {
    RecordedTable table;
    std::map<std::string, std::vector<double>> columns;
    double time_origin = 0.0;
  };
  std::vector<Made> tables;
  std::vector<RecordingSentence> problems;  ///< of reading rows

  bool reads(const std::filesystem::path& file) const override { return file.extension() == ".bag"; }
  RecordingContents contents(const std::filesystem::path&) const override {
    RecordingContents contents;
    for (const Made& made : tables) contents.tables.push_back(made.table);
    return contents;
  }
  ReadRows read(const std::filesystem::path&, const std::vector<TableQuery>& queries) const override {
    ReadRows read;
    read.problems = problems;
    if (!problems.empty()) return read;
    for (const TableQuery& query : queries) {
      RecordedRows& rows = read.tables.emplace_back();
      for (const Made& made : tables)
        for (const std::string& column : query.columns) {
          if (made.table.name != query.table) continue;
          rows.columns.push_back(made.columns.at(column));
          rows.origins.push_back(column == "t" ? made.time_origin : 0.0);
        }
    }
    return read;
  }
};

class ForeignRecordings : public testing::Test {
 protected:
  ForeignRecordings() { file_ = folder_.write("run.bag", "not looked at"); }

  /// A table of joint states and one of commands, whose clock is the same.
  void make_topics() {
    formats_.tables = {{{"/states", {{"t", "s"}, {"position[hinge]", kSomeSiUnit}}, "t"},
                        {{"t", {0.0, 0.1, 0.2, 0.3}}, {"position[hinge]", {1, 2, 3, 4}}},
                        1.7e9},
                       {{"/command", {{"t", "s"}, {"effort", "N*m"}}, "t"},
                        {{"t", {0.05, 0.15, 0.25}}, {"effort", {5, 6, 7}}},
                        1.7e9}};
  }
  RecordingSource topics_source() const {
    RecordingSource source = pendulum_source(file_);
    source.sensors[0].column = "/states.position[hinge]";
    source.commands[0].column = "/command.effort";
    return source;
  }
  Recording read(const RecordingSource& source) const {
    return read_recording(source, kPendulumChannels, kPendulumActuators, {"joint.hinge"}, &formats_);
  }
  std::string complaint(const RecordingSource& source) const {
    try {
      read(source);
    } catch (const BadInput& error) {
      return error.what();
    }
    return {};
  }

  const TestFolder folder_;
  std::filesystem::path file_;
  MadeTables formats_;
};

TEST_F(ForeignRecordings, AreReadLikeCsv) {
  formats_.tables = {{{"", {{"t", ""}, {"q", ""}, {"u", ""}}, ""},
                      {{"t", {10, 10.1, 10.2}}, {"q", {1, kNothing, 3}}, {"u", {4, 5, 6}}}}};
  const Recording recording = read(pendulum_source(file_));
  const Trial& trial = recording.trials.front();
  ASSERT_EQ(trial.measured.times.size(), 3);
  EXPECT_NEAR(trial.measured.times[1], 0.1, 1e-9);
  EXPECT_TRUE(std::isnan(trial.measured.samples(1, 0)));
  EXPECT_EQ(trial.commands.series.samples(2, 0), 6.0);
  EXPECT_THAT(notes_of(recording), HasSubstr("run.bag: column `q` has no value in 1 of 3 rows, the first is row 2"));
}

/// As ROS writes times, in seconds and nanoseconds.
TEST_F(ForeignRecordings, HaveTimesInTwoColumns) {
  formats_.tables = {{{"", {{"sec", ""}, {"nanosec", ""}, {"q", ""}, {"u", ""}}, ""},
                      {{"sec", {1, 1, 2}}, {"nanosec", {0, 5e8, 0}}, {"q", {1, 2, 3}}, {"u", {4, 5, 6}}}}};
  RecordingSource source = pendulum_source(file_);
  source.time_column = "sec";
  EXPECT_EQ(read(source).trials.front().measured.times[1], 0.5);
}

TEST_F(ForeignRecordings, JoinTheTablesThatColumnsAreOf) {
  make_topics();
  const Trial trial = read(topics_source()).trials.front();
  ASSERT_EQ(trial.measured.times.size(), 5) << "rows of both from 0.05 s, when the command is known, to 0.25 s";
  EXPECT_NEAR(trial.measured.times[1], 0.05, 1e-9);
  EXPECT_EQ(trial.measured.samples(1, 0), 2.0);
  EXPECT_EQ(trial.commands.series.samples(1, 0), 5.0);
}

/// Stamps since 1970 are no numbers that anybody would write.
TEST_F(ForeignRecordings, CountTimesOfUseFromTheFilesFirst) {
  make_topics();
  RecordingSource source = topics_source();
  source.use = {{0.09, 0.21}};
  const Trial trial = read(source).trials.front();
  EXPECT_EQ(trial.measured.times.size(), 3);
  EXPECT_EQ(trial.measured.samples(0, 0), 2.0);
}

TEST_F(ForeignRecordings, HaveColumnsOfTheNamedTableWithoutItsName) {
  make_topics();
  RecordingSource source = topics_source();
  source.files[0].table = "/states";
  source.sensors[0].column = "position[hinge]";
  EXPECT_EQ(read(source).trials.front().measured.samples(1, 0), 2.0);
  source.files[0].table = "/state";
  EXPECT_THAT(complaint(source), HasSubstr("no table `/state` (did you mean \"/states\"?)"));
}

/// Another file's clock may be off; the offset holds for that table alone.
TEST_F(ForeignRecordings, ATableOfAnotherFileIsJoinedByItsName) {
  make_topics();
  RecordingSource source = topics_source();
  FurtherFile with;
  with.path = folder_.write("other.bag", "not looked at");
  with.table = "/command";
  with.columns = {"/command.effort"};
  with.offset = 0.01;
  with.location = {"rig.toml", 5, 9};
  source.files[0].with = {with};
  const Trial trial = read(source).trials.front();
  EXPECT_NEAR(trial.measured.times[1], 0.04, 1e-9) << "the state at 0.1 s, after the first command at 0.06 s";
  source.files[0].with[0].table.clear();
  EXPECT_THAT(complaint(source), HasSubstr("has several tables; give table = \"...\", one of `/states`, `/command`"));
}

TEST_F(ForeignRecordings, NameTheColumnsThatThereAre) {
  make_topics();
  RecordingSource source = topics_source();
  source.commands[0].column = "/command.efort";
  EXPECT_THAT(complaint(source), HasSubstr("no column `/command.efort` (did you mean \"/command.effort\"?)"));
  source.commands[0].column = "/command.effort";
  source.time_column = "stamp";
  EXPECT_EQ(complaint(source), "") << "a format that knows its time needs no name for it";
  source.trial_column = "t";
  EXPECT_THAT(complaint(source), HasSubstr("/states and /command, which are joined; this excludes trial_column"));
}

TEST_F(ForeignRecordings, WithValuesThatCannotBeAreRefused) {
  formats_.tables = {{{"", {{"t", ""}, {"q", ""}, {"u", ""}}, ""},
                      {{"t", {0, kNothing, kNothing, 0.3}},
                       {"q", {1, 2, kNothing, 4}},
                       {"u", {1, kNothing, kNothing, std::numeric_limits<double>::infinity()}}}}};
  EXPECT_THAT(complaint(pendulum_source(file_)),
              AllOf(HasSubstr("column `t` has no value in row 2"), HasSubstr("column `u` is infinite in row 4")));
  std::filesystem::remove(file_);
  EXPECT_THAT(complaint(pendulum_source(file_)), HasSubstr("there is no such file"));
}

TEST_F(ForeignRecordings, OfAPluginThatBreaksItsWordAreRefused) {
  formats_.tables = {{{"", {{"t", ""}, {"q", ""}, {"u", ""}}, ""}, {{"t", {0, 1}}, {"q", {1}}, {"u", {1, 2}}}}};
  EXPECT_THAT(complaint(pendulum_source(file_)), HasSubstr("repair the plugin"));
}

TEST_F(ForeignRecordings, ThatAreDamagedSayNothingElse) {
  make_topics();
  formats_.problems = {{0, "is damaged"}};
  EXPECT_EQ(complaint(topics_source()), file_.string() + ": is damaged");
}

TEST_F(ForeignRecordings, AreGuessedWithTheUnitsOfTheirFormat) {
  make_topics();
  const RigGuess guess = guess_rig({sample_file(file_, &formats_)}, {});
  EXPECT_EQ(guess.time.name, "t");
  ASSERT_EQ(guess.sensors.size(), 1U);
  EXPECT_EQ(guess.sensors[0].column.name, "/states.position[hinge]");
  EXPECT_EQ(guess.sensors[0].column.unit, "rad");
  ASSERT_EQ(guess.commands.size(), 1U);
  EXPECT_EQ(guess.commands[0].column.name, "/command.effort");
}

}  // namespace
}  // namespace lacuna
