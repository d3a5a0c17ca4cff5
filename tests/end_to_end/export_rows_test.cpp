#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A database with one comparison of the pendulum of first-steps.toml.
class ExportedRows : public testing::Test {
 protected:
  ExportedRows() {
    program_.copy_first_steps();
    EXPECT_EQ(program_.run({"compare", "first-steps.toml"}).exit_code, 0);
  }

  /// What a command that is refused says.
  std::string refused(const std::vector<std::string>& arguments, int exit_code = 2) const {
    const Outcome outcome = program_.run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.output << outcome.errors;
    return outcome.errors;
  }
  Outcome done(const std::vector<std::string>& arguments) const {
    Outcome outcome = program_.run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome;
  }
  bool is_there(const std::string& file) const { return std::filesystem::exists(program_.folder() / file); }
  /// Files in the folder, hidden ones as well.
  std::size_t files() const {
    const std::filesystem::directory_iterator folder(program_.folder());
    return static_cast<std::size_t>(std::distance(begin(folder), end(folder)));
  }

  const Program program_;
};

TEST_F(ExportedRows, OfAViewAreThoseOfSql) {
  const std::vector<std::string> sql = {"sql", "first-steps.db", "SELECT * FROM fitted_parameters"};
  done({"export", "first-steps.db", "fitted_parameters", "--csv", "values.csv"});
  EXPECT_EQ(program_.read("values.csv"), done({sql[0], sql[1], sql[2], "--csv"}).output);
  EXPECT_EQ(done({"export", "first-steps.db", "fitted_parameters", "--json"}).output,
            done({sql[0], sql[1], sql[2], "--json"}).output);
  EXPECT_EQ(done({"export", "first-steps.db", "fitted_parameters", "values.jsonl"}).errors,
            "values.jsonl  3 rows of fitted_parameters\n");
  EXPECT_EQ(nlohmann::json::parse(program_.read("values.jsonl").substr(0, program_.read("values.jsonl").find('\n'))),
            nlohmann::json::parse(done({"export", "first-steps.db", "fitted_parameters", "--json"}).output).at(0));
}

TEST_F(ExportedRows, OfATrialHaveMeasuredBesidePredicted) {
  EXPECT_EQ(done({"export", "first-steps.db", "chirp.csv", "--csv=trace.csv"}).errors,
            "trace.csv  chirp.csv of first-steps: measured and predicted by revision 1\n");
  EXPECT_THAT(program_.read("trace.csv"), StartsWith("time [s],angle measured [rad],angle predicted [rad]\n0,"));
  const std::string samples =
      "SELECT value FROM traces, trace_samples(traces.id) WHERE trial = 'chirp.csv' AND kind = 'predicted'";
  std::string values = done({"sql", "first-steps.db", samples, "--csv"}).output;
  values.erase(0, values.find('\n') + 1);
  const nlohmann::json rows = nlohmann::json::parse(done({"export", "first-steps.db", "chirp.csv", "--json"}).output);
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(std::count(values.begin(), values.end(), '\n')));
  EXPECT_EQ(rows.at(700).at("angle predicted [rad]").get<double>(), [&] {
    std::size_t at = 0;
    for (int i = 0; i < 700; ++i) at = values.find('\n', at) + 1;
    return std::stod(values.substr(at));
  }());
}

/// Every format says the same, to the last bit, and so does NumPy itself.
TEST_F(ExportedRows, AreTheSameInEveryFormat) {
  for (const std::string name : {"trace.csv", "trace.json", "trace.npz", "trace.mcap"})
    done({"export", "first-steps.db", "chirp.csv", name});
  done({"export", "first-steps.db", "latest_comparison", "--npz", "view.npz"});
  done({"export", "first-steps.db", "latest_comparison", "--json", "view.json"});
  program_.write("same.py", R"(
import csv, json, numpy
trace = numpy.load("trace.npz", allow_pickle=False)
rows = json.load(open("trace.json"))
cells = list(csv.reader(open("trace.csv", newline="")))
assert list(trace) == cells[0] == list(rows[0]), list(trace)
for i, name in enumerate(trace):
    assert trace[name].dtype == numpy.float64 and trace[name].shape == (len(rows),)
    assert all(row[name] == value for row, value in zip(rows, trace[name]))
    assert all(float(row[i]) == value for row, value in zip(cells[1:], trace[name]))
view = numpy.load("view.npz", allow_pickle=False)
for row, number in zip(json.load(open("view.json")), range(1000)):
    for name, value in row.items():
        cell = view[name][number]
        assert cell == value or (value is None and (cell == "" or numpy.isnan(cell))), (name, cell, value)
assert view["held_out"].dtype == numpy.int64 and view["trial"].dtype.kind == "U"
print("same")
)");
  const Outcome checked = program_.shell("/usr/bin/python3 same.py");
  EXPECT_EQ(checked.output, "same\n") << checked.errors;
}

/// The columns of a trace as a recording: with the unit that each of them names.
TEST_F(ExportedRows, AreRecordingsThatLacunaReads) {
  for (const std::string name : {"trace.csv", "trace.jsonl", "trace.npz", "trace.mcap"}) {
    done({"export", "first-steps.db", "sine.csv", name});
    program_.write("again.toml",
                   "[experiment]\nname = \"again\"\nseed = 1\n[target]\nkind = \"recorded\"\nfiles = [\"" + name +
                       "\"]\nholdout = []\n[target.time]\ncolumn = \"" +
                       (name == "trace.mcap" ? "/angle.t" : "time [s]") +
                       "\"\nunit = \"s\"\n[target.sensors]\nangle = { column = \"" +
                       (name == "trace.mcap" ? "/angle.measured" : "angle measured [rad]") +
                       "\", unit = \"rad\" }\n[target.commands]\n[model]\nfile = \"robots/servo-pendulum.toml\"\n");
    const Outcome checked = program_.run({"check", "again.toml"});
    EXPECT_THAT(checked.errors + checked.output, HasSubstr("angle")) << name;
    EXPECT_EQ(checked.exit_code, 0) << name << checked.errors;
  }
}

TEST_F(ExportedRows, ReplaceNothingUnlessForced) {
  program_.write("old.csv", "mine\n");
  EXPECT_THAT(refused({"export", "first-steps.db", "runs", "--csv", "old.csv"}),
              AllOf(HasSubstr("old.csv: exists already"), HasSubstr("--force")));
  EXPECT_EQ(program_.read("old.csv"), "mine\n");
  done({"export", "first-steps.db", "runs", "--csv", "old.csv", "--force"});
  EXPECT_THAT(program_.read("old.csv"), StartsWith("run,experiment,"));
  EXPECT_THAT(refused({"export", "first-steps.db", "runs", "--csv", "first-steps.db", "--force"}),
              HasSubstr("is read by this command"));
  EXPECT_EQ(done({"export", "first-steps.db", "runs", "--csv", "/dev/stdout"}).output.substr(0, 4), "run,");
}

TEST_F(ExportedRows, AreRefusedWithWhatThereIs) {
  EXPECT_THAT(refused({"export", "first-steps.db", "error_by_revison", "--csv"}),
              AllOf(HasSubstr("has no view, trial or table \"error_by_revison\" (did you mean \"error_by_revision\"?)"),
                    HasSubstr("\n  views: "), HasSubstr("\n  trials: sine.csv, steps.csv, chirp.csv\n"),
                    HasSubstr("\n  tables: ")));
  EXPECT_THAT(refused({"export", "first-steps.db"}), HasSubstr("say what to export, one of these:\n  views: "));
  EXPECT_THAT(refused({"export", "first-steps.db", "runs"}), HasSubstr("--csv, --json, --npz or --mcap"));
  EXPECT_THAT(refused({"export", "first-steps.db", "runs", "--csv", "--json"}), HasSubstr("give only one of --csv"));
  EXPECT_THAT(refused({"export", "first-steps.db", "runs", "--mcap", "runs.mcap"}),
              HasSubstr("runs is a table; use --csv, --json or --npz"));
  EXPECT_THAT(refused({"export", "first-steps.db", "chirp.csv", "--csv", "--revision", "9"}),
              HasSubstr("there are predictions of revision 1"));
  EXPECT_THAT(refused({"export", "first-steps.db", "runs", "--csv", "--set", "engine.step=0.001"}),
              HasSubstr("--set is for an experiment file"));
}

TEST_F(ExportedRows, AreOfADatabase) {
  program_.write("notes.txt", "no database, and longer than the head of one would have to be, to be sure of it\n");
  EXPECT_THAT(refused({"export", "notes.txt", "runs", "--csv"}), HasSubstr("notes.txt"));
  EXPECT_THAT(refused({"export", "missing.db", "runs", "--csv"}), HasSubstr("missing.db"));
  EXPECT_THAT(
      refused({"export", "first-steps.toml", "runs", "--csv"}),
      HasSubstr("is an experiment file, but this command needs a database: lacuna export first-steps.db runs --csv"));
  EXPECT_THAT(refused({"export", "first-steps.db", "--urdf", "arm.urdf"}),
              HasSubstr("is a database, but this command needs an experiment file: lacuna export first-steps.toml"));
  EXPECT_FALSE(is_there("arm.urdf"));
}

TEST_F(ExportedRows, OfAFullDiskLeaveNoFile) {
  const std::size_t before = files();
  for (const std::string name : {"trace.csv", "trace.npz", "trace.mcap"}) {
    const Outcome outcome = program_.shell("ulimit -f 80; lacuna export first-steps.db chirp.csv " + name);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr(name + ": cannot be written completely"), HasSubstr("disk not full")));
  }
  EXPECT_EQ(files(), before);
}

TEST_F(ExportedRows, ThatAreInterruptedLeaveNoFile) {
  ASSERT_EQ(program_
                .shell("sqlite3 first-steps.db 'CREATE VIEW endless AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL "
                       "SELECT i + 1 FROM n) SELECT i FROM n'")
                .exit_code,
            0);
  const std::size_t before = files();
  for (const std::string name : {"rows.csv", "rows.npz"}) {
    const Outcome outcome =
        program_.shell("lacuna export first-steps.db endless " + name + " & sleep 1.5; kill -TERM $!; wait $!");
    EXPECT_EQ(outcome.exit_code, 75) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("interrupted"));
  }
  EXPECT_EQ(files(), before);
}

/// Through a pipe, as a plot program may read them.
TEST_F(ExportedRows, GoThroughAPipe) {
  const Outcome piped = program_.shell("lacuna export first-steps.db chirp.csv --npz | cat > piped.npz");
  EXPECT_EQ(piped.exit_code, 0) << piped.errors;
  done({"export", "first-steps.db", "chirp.csv", "named.npz"});
  EXPECT_EQ(program_.read("piped.npz"), program_.read("named.npz"));
  if (program_.shell("command -v script").exit_code != 0) GTEST_SKIP() << "there is no script to make a terminal";
  const Outcome terminal =
      program_.shell("script -qec 'lacuna export first-steps.db chirp.csv --npz' /dev/null </dev/null");
  EXPECT_EQ(terminal.exit_code, 2);
  EXPECT_THAT(terminal.output, HasSubstr("a binary file cannot go to a terminal"));
}

}  // namespace
}  // namespace lacuna
