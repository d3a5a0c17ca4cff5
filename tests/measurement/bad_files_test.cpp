// Files as people have them: each is refused with a sentence that says where and what to do, or
// read in a documented way that a note tells. docs/reference/measurements.md describes both.

#include "measurement/recording.h"

#include "measurement_fixture.h"

#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <ostream>
#include <string>

namespace lacuna {
namespace {

using namespace std::string_literals;

struct BadFile {
  std::string name;
  std::string content;
  std::string problem;  ///< what the complaint must hold; empty: the file can be read
  std::string note;     ///< what the notes must hold; empty: no note is expected
  std::function<void(RecordingSource&)> change = {};
};

void PrintTo(const BadFile& file, std::ostream* out) { *out << file.name; }

const std::string kSamples = "0,1,2\n0.1,1.5,2.5\n0.2,2,3\n";

std::string utf16(const std::string& text, bool with_mark) {
  std::string wide = with_mark ? "\xff\xfe" : "";
  for (const char c : text) wide += {c, '\0'};
  return wide;
}

std::vector<BadFile> refused_files() {
  return {
      {"empty", "", "run.csv: is empty", ""},
      {"only_blank_lines", "\n\n  \n", "run.csv: has no header", ""},
      {"only_comments", "# t,q,u\n# nothing\n", "run.csv: has no header", ""},
      {"only_header", "t,q,u\n", "run.csv: has a header but no samples", ""},
      {"one_sample", "t,q,u\n0,1,2\n", "run.csv:2: trial run.csv has only one sample", ""},
      {"no_header", kSamples, "run.csv:1: numbers instead of column names", ""},
      {"no_header_with_semicolons", "0;1;2\n0,1;1,5;2\n", "run.csv:1: numbers instead of column names", ""},
      {"missing_column", "t,p,u\n" + kSamples, "run.csv:1: no column `q`", ""},
      {"misspelt_column", "t,angl,u\n" + kSamples,
       "no column `angle` (did you mean \"angl\"?); the columns are `t`, `angl`, `u`", "",
       [](RecordingSource& source) { source.sensors[0].column = "angle"; }},
      {"missing_time", "time,q,u\n" + kSamples, "run.csv:1: no column `t`", ""},
      {"same_name_twice", "t,q,u,q\n0,1,2,3\n", "run.csv:1: 2 columns have the name `q`", ""},
      {"infinite", "t,q,u\n0,1,2\n0.1,inf,2\n", "run.csv:3: column `q` has `inf`; leave the cell empty", ""},
      {"overflow", "t,q,u\n0,1,2\n0.1,1e999,2\n", "run.csv:3: column `q` has `1e999`", ""},
      {"text", "t,q,u\n0,1,2\n0.1,error,2\n", "run.csv:3: column `q` has `error` instead of a number; empty the cell",
       ""},
      {"number_with_unit", "t,q,u\n0,1,2\n0.1,1.5 rad,2\n", "run.csv:3: column `q` has `1.5 rad`", ""},
      {"hexadecimal", "t,q,u\n0,1,2\n0.1,0x1F,2\n", "run.csv:3: column `q` has `0x1F`", ""},
      {"empty_time", "t,q,u\n0,1,2\n,1,2\n", "run.csv:3: column `t` has no value here", ""},
      {"nan_time", "t,q,u\n0,1,2\nnan,1,2\n", "run.csv:3: column `t` has no value here (`nan`)", ""},
      {"day_as_time", "t,q,u\n2024-05-01,1,2\n", "run.csv:2: column `t` has `2024-05-01`", ""},
      {"first_command_missing", "t,q,u\n0,1,\n0.1,1,2\n", "run.csv:2: command column `u` has no value in the trial's",
       ""},
      {"time_back", "t,q,u\n0,1,2\n0.2,1,2\n0.1,1,2\n", "run.csv:4: time goes back from 0.2 s to 0.1 s; sort", ""},
      {"two_trials_in_a_row", "t,q,u\n0,1,2\n0.1,1,2\n0,1,2\n0.1,1,2\n", "run.csv:4: time goes back from 0.1 s to 0 s",
       ""},
      {"same_time_other_values", "t,q,u\n0,1,2\n0.1,1,2\n0.1,5,2\n", "run.csv:4: the time of line 3 again, 0.1 s", ""},
      {"gap", "t,q,u\n0,1,2\n0.1,1,2\n0.2,1,2\n9,1,2\n9.1,1,2\n", "run.csv:5: a gap of 8.8 s before this sample", ""},
      {"short_row", "t,q,u\n0,1,2\n0.1,1\n0.2,1,2\n",
       "run.csv:3: 2 cells, but the header (line 1) has 3 names; complete the row", ""},
      {"long_row", "t,q,u\n0,1,2\n0.1,1,2,7\n0.2,1,2\n", "run.csv:3: 4 cells, but the header", ""},
      {"decimal_commas_between_commas", "t,q,u\n0,0,1,0,2,0\n0,1,1,5,2,5\n", "must be separated by semicolons or tabs",
       ""},
      {"thousands_separators", "t;q;u\n0,0;1.234,5;2\n0,1;1.234,5;2\n", "run.csv:2: column `q` has `1.234,5`", ""},
      {"decimal_commas_that_delimit", "t,q,u\n0,1,2\n0,1,1,5,2,5\n",
       "run.csv:3: 6 cells where the header (line 1) has 3 names, and all are whole numbers: commas seem to be decimal "
       "signs and delimiters at once",
       ""},
      {"whole_numbers_and_a_row_too_long", "t,q,u\n0,1,2\n0.1,1,2,5\n",
       "run.csv:3: 4 cells, but the header (line 1) has 3 names; with decimal commas", ""},
      {"comma_and_point_mixed", "t;q;u\n0.0;1,5;2\n0.1;1.5;2\n", "for a decimal comma, all numbers", ""},
      {"open_quote", "t,q,u\n0,1,2\n0.1,\"1,2\n0.2,1,2\n", "run.csv:3: a quoted cell is not closed", ""},
      {"spreadsheet", "PK\x03\x04zip"s, "run.csv: is a spreadsheet", ""},
      {"gzip", "\x1f\x8b\x08zip", "run.csv: is compressed with gzip; unpack", ""},
      {"matlab", "MATLAB 5.0 MAT-file, Platform: GLNXA64", "run.csv: is a MATLAB file; give it a name", ""},
      {"parquet", "PAR1 and so on", "run.csv: is a Parquet file; in Python write pandas.read_parquet", ""},
      {"hdf5", "\x89HDF\r\n\x1a\n and so on", "run.csv: is an HDF5 file; in Python write numpy.savez", ""},
      {"rosbag1", "#ROSBAG V2.0", "run.csv: is a bag of ROS 1; convert it with rosbags-convert", ""},
      {"robot_file", "<?xml version=\"1.0\"?>\n<robot name=\"arm\">\n</robot>\n",
       "run.csv: is a robot file, not a recording; name the robot under model.file or by --robot", ""},
      {"toml_robot", "[robot]\nname = \"arm\"\n", "run.csv: is a robot file, not a recording", ""},
      {"other_xml", "<log><t>0</t></log>\n", "run.csv: is XML, not a recording; export", ""},
      {"binary", "\x01\x02\x03\x04\x05\x06\x07\x08\x0e\x0f garbage", "run.csv: is a binary file", ""},
      {"zero_bytes_at_the_end", "t,q,u\n" + kSamples + "# " + std::string(4000, '-') + "\n" + std::string(64, '\0'),
       "run.csv:6: zero bytes", ""},
      {"huge_cell", "t,q,u\n0,1,2\n0.1," + std::string(100000, 'x') + ",2\n",
       "run.csv:3: column `q` has `xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...`", ""},
      {"words_under_the_header", "t,q,u\nseconds since start,the angle,the torque\n" + kSamples,
       "run.csv:2: column `t` has `seconds since start`", ""},
      {"nothing_to_use", "t,q,u\n" + kSamples,
       "target.time.use leaves no sample of trial run.csv, which covers 0 s to 0.2 s", "",
       [](RecordingSource& source) {
         source.use = {{5.0, 6.0}};
       }},
      {"everything_held_out", "t,q,u\n" + kSamples, "rig.toml: every trial is held out", "",
       [](RecordingSource& source) { source.files[0].held_out = true; }},
      {"unknown_trial_held_out", "t,q,u,k\n0,1,2,a\n1,1,2,a\n", "no file has the held-out trial `b`", "",
       [](RecordingSource& source) {
         source.trial_column = "k";
         source.holdout_trials = {"b"};
       }},
      {"trial_without_name", "t,q,u,k\n0,1,2,a\n1,1,2,\n", "run.csv:3: the trial column `k` is empty here", "",
       [](RecordingSource& source) { source.trial_column = "k"; }},
      {"fitted_and_held_out", "t,q,u\n" + kSamples, "rig.toml:4:12: ", "",
       [](RecordingSource& source) {
         source.files.push_back({source.files[0].path, true, {"rig.toml", 4, 12}});
       }},
      {"quoted_thousands", "t,q,u\n0,\"1,234\",2\n1,\"1,500\",2\n", "run.csv:2: column `q` has `1,234`", ""},
      {"wrong_delimiter_declared", "t,q,u\n" + kSamples, "run.csv:1: no column `t`", "",
       [](RecordingSource& source) { source.delimiter = ';'; }},
      {"unknown_sensor", "t,q,u\n" + kSamples,
       "rig.toml:7:1: the robot has no sensor channel `angl` (did you mean \"angle\"?); it has angle, rate", "",
       [](RecordingSource& source) { source.sensors[0].channel = "angl"; }},
      {"unknown_actuator", "t,q,u\n" + kSamples, "rig.toml:9:1: the robot has no actuator `moto`", "",
       [](RecordingSource& source) { source.commands[0].channel = "moto"; }},
      {"wrong_dimension", "t,q,u\n" + kSamples,
       "rig.toml:9:1: column `u` in V has another unit than motor, which is in N*m; correct the unit, or give a gain "
       "with its unit, N*m/(V)",
       "", [](RecordingSource& source) { source.commands[0].unit = "V"; }},
      {"wrong_gain", "t,q,u\n" + kSamples, "rig.toml:9:1: column `u` in V times a gain in N/V does not give N*m", "",
       [](RecordingSource& source) {
         source.commands[0].unit = "V";
         source.commands[0].gain_unit = "N/V";
       }},
      {"no_unit_at_all", "t,q,u\n" + kSamples, "rig.toml:7:1: `radiants` is not a unit", "",
       [](RecordingSource& source) { source.sensors[0].unit = "radiants"; }},
      {"time_in_radians", "t,q,u\n" + kSamples, "rig.toml: the time column's unit `rad` is not a unit of time", "",
       [](RecordingSource& source) { source.time_unit = "rad"; }},
      {"two_columns_for_a_sensor", "t,q,u\n" + kSamples, "rig.toml:7:1: sensor channel angle has two columns", "",
       [](RecordingSource& source) { source.sensors.push_back(source.sensors[0]); }},
      {"no_sensor", "t,q,u\n" + kSamples, "rig.toml: no column is read", "",
       [](RecordingSource& source) { source.sensors.clear(); }},
  };
}

std::vector<BadFile> readable_files() {
  return {
      {"crlf", "t,q,u\r\n0,1,2\r\n0.1,1.5,2.5\r\n0.2,2,3\r\n", "", ""},
      {"byte_order_mark", "\xef\xbb\xbft,q,u\n" + kSamples, "", ""},
      {"old_macintosh", "t,q,u\r0,1,2\r0.1,1.5,2.5\r0.2,2,3\r", "", "lines end in \\r alone"},
      {"semicolons", "t;q;u\n0;1;2\n0.1;1.5;2.5\n0.2;2;3\n", "", ""},
      {"semicolons_and_decimal_commas", "t;q;u\n0;1;2\n0,1;1,5;2,5\n0,2;2;3\n", "", "read as decimal commas"},
      {"quoted_decimal_commas", "t,q,u\n\"0\",\"1\",2\n\"0,1\",\"1,5\",\"2,5\"\n\"0,2\",2,3\n", "",
       "read as decimal commas"},
      {"quoted_decimal_commas_of_three_digits",
       "t,q,u\n\"0,000\",\"1,000\",\"2,000\"\n\"0,100\",\"1,500\",\"2,500\"\n\"0,200\",\"2,000\",\"3,000\"\n", "",
       "read as decimal commas"},
      {"tabs", "t\tq\tu\n0\t1\t2\n0.1\t1.5\t2.5\n0.2\t2\t3\n", "", ""},
      {"tabs_and_decimal_commas", "t\tq\tu\n0\t1\t2\n0,1\t1,5\t2,5\n0,2\t2\t3\n", "", "read as decimal commas"},
      {"spaces", "  t    q   u\n  0.0  1.0 2.0\n  0.1  1.5 2.5\n  0.2  2.0 3.0\n", "", ""},
      {"bars", "t|q|u\n0|1|2\n0.1|1.5|2.5\n0.2|2|3\n", "", ""},
      {"spaces_after_commas", "t, q, u\n0, 1, 2\n0.1, 1.5, 2.5\n0.2, 2, 3\n", "", ""},
      {"quotes", "\"t\",\"q\",\"u\"\n\"0\",\"1\",\"2\"\n0.1,\"1.5\",2.5\n0.2,2,3\n", "", ""},
      {"quoted_delimiter", "t,q,u,\"remark, if any\"\n0,1,2,\"a, \"\"b\"\"\"\n0.1,1.5,2.5,\n0.2,2,3,c\n", "", ""},
      {"excel_separator_line", "sep=;\nt;q;u\n0;1;2\n0.1;1.5;2.5\n0.2;2;3\n", "", ""},
      {"trailing_delimiters", "t,q,u,\n0,1,2,\n0.1,1.5,2.5,\n0.2,2,3,\n", "", ""},
      {"trailing_delimiters_in_rows", "t,q,u\n0,1,2,\n0.1,1.5,2.5,\n0.2,2,3,,\n", "", ""},
      {"blank_lines", "\nt,q,u\n\n0,1,2\n0.1,1.5,2.5\n\n0.2,2,3\n\n", "", ""},
      {"comments", "# rig 7\nt,q,u\n0,1,2\n# bump\n0.1,1.5,2.5\n% end\n0.2,2,3\n", "", ""},
      {"header_in_a_comment", "# rig 7\n# t,q,u\n" + kSamples, "", "run.csv:2: the last comment is used as the header"},
      {"lines_above_the_header", "Logger 3000\nrate,10,Hz\nt,q,u\n" + kSamples, "",
       "run.csv:3: the header was found in this line"},
      {"row_of_units", "t,q,u\ns,rad,Nm\n" + kSamples, "", "run.csv:2: a row of units, skipped"},
      {"row_of_other_units", "t,q,u\n[s],[deg],[Nm]\n" + kSamples, "",
       "run.csv:2: the row of units states deg for column `q`, which is read in rad"},
      {"latin1_names",
       "t,q,u,Temp. [\xb0"
       "C]\n0,1,2,20\n0.1,1.5,2.5,20\n0.2,2,3,20\n",
       "",
       "run.csv:1: column names are not UTF-8 and are read as Latin-1: `Temp. [\xc2\xb0"
       "C]`"},
      {"greek_names", "t,q,u,\xcf\x86\n0,1,2,20\n0.1,1.5,2.5,20\n0.2,2,3,20\n", "", ""},
      {"other_columns_of_text", "t,mode,q,u\n0,auto,1,2\n0.1,auto,1.5,2.5\n0.2,inf,2,3\n", "", ""},
      {"plus_signs", "t,q,u\n+0,+1,2e0\n+1e-1,+1.5,+2.5\n.2,2.,3\n", "", ""},
      {"utf16", utf16("t,q,u\n" + kSamples, true), "", "run.csv: is UTF-16 text; read as such"},
      {"utf16_without_mark", utf16("t,q,u\n" + kSamples, false), "", "run.csv: is UTF-16 text"},
      {"no_end_of_last_line", "t,q,u\n0,1,2\n0.1,1.5,2.5\n0.2,2,3", "", ""},
      {"breaks_off", "t,q,u\n" + kSamples + "0.3,1.", "", "run.csv:5: the file ends in the middle of its last line"},
      {"same_row_twice", "t,q,u\n0,1,2\n0.1,1.5,2.5\n0.1,1.5,2.5\n0.2,2,3\n", "",
       "run.csv:4: the same sample as in line 3 again; left out"},
      {"starts_late", "t,q,u\n100,1,2\n100.1,1.5,2.5\n100.2,2,3\n", "",
       "run.csv:2: time starts at 100 s in the file; shifted to start at 0 s"},
  };
}

class BadFiles : public testing::TestWithParam<BadFile> {
 protected:
  RecordingSource source() const {
    RecordingSource source = pendulum_source(folder_.write("run.csv", GetParam().content));
    if (GetParam().change) GetParam().change(source);
    return source;
  }
  TestFolder folder_;
};

class RefusedFiles : public BadFiles {};
class ReadableFiles : public BadFiles {};

TEST_P(RefusedFiles, SayWhereAndWhatToDo) {
  EXPECT_THAT(complaint_of(source()), testing::HasSubstr(GetParam().problem));
}

TEST_P(ReadableFiles, AreReadAsDocumented) {
  const Recording recording = read_pendulum(source());
  const TimeSeries& measured = recording.trials.at(0).measured;
  ASSERT_EQ(measured.times.size(), 3);
  EXPECT_NEAR(measured.times[1], 0.1, 1e-12);
  EXPECT_EQ(measured.samples(1, 0), 1.5);
  EXPECT_EQ(recording.trials[0].commands.series.samples(2, 0), 3.0);
  if (GetParam().note.empty())
    EXPECT_EQ(notes_of(recording), "");
  else
    EXPECT_THAT(notes_of(recording), testing::HasSubstr(GetParam().note));
}

const auto kName = [](const testing::TestParamInfo<BadFile>& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(All, RefusedFiles, testing::ValuesIn(refused_files()), kName);
INSTANTIATE_TEST_SUITE_P(All, ReadableFiles, testing::ValuesIn(readable_files()), kName);

class OddFiles : public testing::Test {
 protected:
  TestFolder folder_;
};

TEST_F(OddFiles, FolderAndMissingAndUnreadableFilesAreNamed) {
  std::filesystem::create_directory(folder_.path() / "runs");
  EXPECT_THAT(complaint_of(pendulum_source(folder_.path() / "runs")), testing::HasSubstr("runs: is a folder"));
  EXPECT_THAT(complaint_of(pendulum_source(folder_.path() / "none.csv")),
              testing::HasSubstr("none.csv: there is no such file"));
  EXPECT_THAT(complaint_of(pendulum_source("/proc/self/mem")), testing::HasSubstr("mem: cannot be read completely"));
  const std::filesystem::path locked = folder_.write("locked.csv", "t,q,u\n" + kSamples);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (::geteuid() != 0) {  // root may read everything
    EXPECT_THAT(complaint_of(pendulum_source(locked)), testing::HasSubstr("locked.csv: cannot be opened"));
  }
}

TEST_F(OddFiles, ANumberThatTheEndOfTheFileCutsOffIsNamedAndLeftOut) {
  const std::string lines =
      "t,q,u\n0,1,2.125\n0.1,1.5,2.250\n0.2,2,3.000\n0.3,2,3.125\n0.4,2,3.250\n0.5,2,3.375\n0.6,2,";
  const Recording cut = read_pendulum(pendulum_source(folder_.write("run.csv", lines + "3.5")));
  EXPECT_EQ(cut.trials.at(0).measured.times.size(), 6);
  EXPECT_THAT(notes_of(cut),
              testing::HasSubstr("run.csv:8: the file ends in the middle of a line: its last number, `3.5`, "
                                 "has fewer digits than all numbers above it; the line is left out"));
  const Recording whole = read_pendulum(pendulum_source(folder_.write("run.csv", lines + "3.500")));
  EXPECT_EQ(whole.trials.at(0).measured.times.size(), 7);
  EXPECT_EQ(notes_of(whole), "");
}

TEST_F(OddFiles, MissingSamplesAreCountedAndBecomeNaN) {
  const Recording recording =
      read_pendulum(pendulum_source(folder_.write("run.csv", "t,q,u\n0,1,2\n0.1,,2\n0.2,NaN,2\n0.3,n/a,2\n0.4,2,2\n")));
  EXPECT_TRUE(std::isnan(recording.trials[0].measured.samples(2, 0)));
  EXPECT_EQ(recording.trials[0].measured.samples(4, 0), 2.0);
  EXPECT_THAT(notes_of(recording), testing::HasSubstr("run.csv:3: column `q` has no value in 3 of 5 rows"));
}

TEST_F(OddFiles, DroppedSamplesAreCounted) {
  std::string text = "t,q,u\n";
  for (int i = 0; i < 100; ++i)
    if (i % 20 != 7) text += std::to_string(i) + "," + std::to_string(i % 7) + "," + std::to_string(i % 3) + "\n";
  RecordingSource source = pendulum_source(folder_.write("run.csv", text));
  source.time_unit = "ms";
  const Recording recording = read_pendulum(source);
  EXPECT_THAT(notes_of(recording), testing::HasSubstr("run.csv:9: about 5 samples of 100 are missing"));
  EXPECT_EQ(recording.trials[0].measured.times.size(), 95);
}

TEST_F(OddFiles, JitterIsNotedAndTimeStampsAreKept) {
  std::string text = "t,q,u\n";
  for (int i = 0; i < 100; ++i)
    text +=
        std::to_string(0.01 * i + 0.003 * (i % 3)) + "," + std::to_string(i % 7) + "," + std::to_string(i % 3) + "\n";
  const Recording recording = read_pendulum(pendulum_source(folder_.write("run.csv", text)));
  EXPECT_THAT(notes_of(recording), testing::HasSubstr("intervals vary between"));
  EXPECT_NEAR(recording.trials[0].measured.times[2], 0.026, 1e-9);
}

TEST_F(OddFiles, AMaskOrALongerGapAllowsAPause) {
  RecordingSource source =
      pendulum_source(folder_.write("run.csv", "t,q,u\n0,1,2\n0.1,1.2,2\n0.2,1,3\n9,1,2\n9.1,1,2\n"));
  source.mask = {{0.2, 9.0}};
  EXPECT_EQ(complaint_of(source), "");
  source.mask.clear();
  source.max_gap = 10.0;
  EXPECT_EQ(complaint_of(source), "");
}

TEST_F(OddFiles, AGivenStateInTheMiddleIsNoted) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", "t,q,u\n0,1,2\n1,2,3\n2,3,2\n3,4,2\n"));
  source.use = {{2.0, 3.0}};
  source.initial["hinge"] = {.joint = {InitialKnowledge::given, 3.0, 0.0}};
  EXPECT_THAT(notes_of(read_pendulum(source)),
              testing::HasSubstr("run.csv:4: target.initial also gives the state here"));
}

TEST_F(OddFiles, RepeatedComplaintsAreCounted) {
  std::string text = "t,q,u\n";
  for (int i = 0; i < 315; ++i) text += std::to_string(i) + ",bad,2\n";
  const std::string complaint = complaint_of(pendulum_source(folder_.write("run.csv", text)));
  EXPECT_EQ(std::count(complaint.begin(), complaint.end(), '\n'), 2);
  EXPECT_THAT(complaint, testing::HasSubstr("(and 312 more like it)"));
}

double processor_seconds(std::clock_t since) { return static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC; }

TEST_F(OddFiles, TwoHundredThousandRowsAreReadAboutAsFastAsWritten) {
  constexpr int kRows = 200000;
  const std::clock_t begin = std::clock();
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "t,q,u,w\n");
  for (int i = 0; i < kRows; ++i)
    fmt::format_to(std::back_inserter(text), "{:.3f},{:.6g},{:.6g},{:.6g}\n", 1e-3 * i, std::sin(1e-3 * i),
                   std::cos(1e-3 * i), std::sin(2e-3 * i));
  const RecordingSource source = pendulum_source(folder_.write("run.csv", fmt::to_string(text)));
  const double to_write = processor_seconds(begin);  // a measure of the machine and what else it does
  const std::clock_t before = std::clock();
  const Recording recording = read_pendulum(source);
  const double to_read = processor_seconds(before);
  RecordProperty("seconds", std::to_string(to_read));
  EXPECT_EQ(recording.trials[0].measured.times.size(), kRows);
  EXPECT_LT(to_read, 2.0 * to_write) << to_read << " s, to write " << to_write << " s";
}

}  // namespace
}  // namespace lacuna
