#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <sstream>
#include <string>
#include <vector>

/// No column of a view holds a value that was not computed: every column of every view is asked of databases that the
/// program filled, one with a diagnosis that errors over horizons decided, one with a diagnosis that likelihoods
/// decided and a run of the algorithm.
namespace lacuna {
namespace {

using nlohmann::ordered_json;

/// A view a paragraph, its columns in their order, what each holds: `text`, `null`, or a number between two; with
/// `?` it may be NULL in some rows.
constexpr const char* kColumns = R"(runs
 run 1..9
 experiment text
 command text
 started text
 ended text
 ending text
 seed -9e18..9e18
 threads 1..1000
 program text
 source_revision text
 processor text
 identity text
revisions
 experiment text
 number 1..9
 parent 1..9?
 change text
 effects text?
 free_values 1..99
 robot text
 first_run 1..9
 digest text
 id 1e12..1e14
latest_comparison
 experiment text
 revision 1..9
 trial text
 held_out 0..1
 channel text
 unit text
 rmse 1e-6..1
 floor 1e-6..1
 times_floor 0.1..1000
 normalised_rmse 1e-4..2
 max_error 1e-6..2
 max_error_time 0..100
 numerical_error 1e-12..1e-2?
 as_written_rmse 1e-6..10
 samples 10..1e6
 comparison 1e12..1e14
trial_setups
 experiment text
 trial text
 held_out 0..1
 setup text
 settings text?
 own text?
 id 1e12..1e14
error_by_revision
 experiment text
 revision 1..9
 change text
 channel text
 unit text
 fit_rmse 1e-6..1
 held_out_rmse 1e-6..1
 floor 1e-6..1
 times_floor 0.1..1000
 failed_trials 0..0
fitted_parameters
 experiment text
 revision 1..9
 position 0..99
 address text
 value 1e-9..10
 unit text
 standard_error 1e-9..1
 lower 0..10
 upper 1e-9..10
 start 0..10
 at_bound text?
 identifiable 0..1
 converged 0..1
 fit 1e12..1e14
holdout_looks
 experiment text
 number 1..9
 revision 1..9
 time text
 command text
 run 1..9
noise_floors
 experiment text
 revision 1..9
 trial text
 channel text
 floor 1e-6..1
 unit text
 sensor 1e-6..1
 input 0..1
 process 0..1
 origin text
diagnoses
 experiment text
 revision 1..9
 verdict text
 method text
 probability null
 calibrated 0..1
 chance 1e-4..0.05
 hypotheses 1..9
 answer text
 base_times_floor null
 times_floor null
 base_fitted_times_floor 2..100
 fitted_times_floor 0.3..5
 stopped null
 next_test text?
 next_test_setup text?
 run 1..9
 id 1e12..1e14
effect_ranking
 experiment text
 revision 1..9
 rank 1..9
 effects text
 method text
 gain -5..5
 gain_lower -5..5
 gain_upper -5..5
 times_floor null
 fitted_times_floor 0.3..100
 probability null
 look_alikes text?
 diagnosis 1e12..1e14
traces
 experiment text
 trial text
 held_out 0..1
 kind text
 revision 1..9?
 channels text
 sample_count 10..1e6
 duration 0.1..1000
 bytes 100..1e8
 id 1e12..1e14
 run 1..9?
 model 0..1e6?
eea_runs
 run 1..9
 experiment text
 replicate 1..1
 ending text
 passes_done 1..9
 passes 1..9
 best_score 1e-9..10
 metric text
 fitness text?
 models 1..1e6
 tests 0..1e6
 trials 1..100
 evaluations 1..1e6
 steps 1..1e9
 seconds 1e-6..600
 seed -9e18..9e18
 stopped null
error_by_pass
 experiment text
 run 1..9
 replicate 1..1
 pass 1..9
 trials 1..100
 error 1e-9..10
 metric text
 best_model 0..1e6
 evaluations_so_far 1..1e6
 steps_so_far 1..1e9
best_model
 experiment text
 run 1..9
 replicate 1..1
 pass 1..9
 model 0..1e6
 generation 0..1e6
 position 0..99
 address text
 value 1e-9..10
 unit text
 truth 1e-9..10
 error -10..10
 lower 0..10
 upper 1e-9..10
 best_score 1e-9..10
parameter_error_by_pass
 experiment text
 run 1..9
 replicate 1..1
 pass 1..9
 address text
 error 0..10
 unit text
ensembles
 experiment text
 run 1..9
 replicate 1..1
 pass 1..9
 rank 1..100
 model 0..1e6
 structure text
 score 1e-9..10
 position 0..99
 address text
 value 1e-9..10
 unit text
 truth 1e-9..10
foretold
 experiment text
 run 1..9
 replicate 1..1
 trial 0..100
 surprise 1e-9..10?
 metric text
 for_transfer 0..1
 passes_set_aside 0..9
transfer_gap
 experiment text
 run 1..9
 replicate 1..1
 pass 1..9
 trial 0..100
 test 0..1e6
 fitness text
 unit text
 predicted -1e9..1e9
 measured -1e9..1e9?
 gap -1e9..1e9?
 for_transfer 0..1
evaluations
 experiment text
 run 1..9
 replicate 1..1
 pass 0..9
 evaluations 0..1e6
 abandoned 0..1e6
 reused 0..1e6
 invalid 0..1e6
 steps 0..1e9
 test_evaluations 0..1e6
 invalid_tests 0..1e6
 test_steps 0..1e9
invalid_evaluations
 experiment text
 run 1..9
 replicate 1..1
 pass 0..9
 generation 0..1e6
 kind text
 number 0..1e6
 reason text
failed_trials
 experiment text
 run 1..9
 trial text
 test text
 failed text
 reason text
)";

struct Column {
  std::string name, expected;
};

using Views = std::map<std::string, std::vector<Column>>;

Views listed_views() {
  Views views;
  std::string view;
  std::istringstream lines(kColumns);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(' ')) {
      view = line;
      continue;
    }
    Column column;
    std::istringstream words(line);
    words >> column.name >> column.expected;
    views[view].push_back(column);
  }
  return views;
}

ordered_json rows_asked(const Program& program, const std::string& database, const std::string& sql) {
  const Outcome outcome = program.run({"sql", database, "--json", sql});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  return ordered_json::parse(outcome.output);
}

bool holds(const ordered_json& value, std::string what) {
  if (what.ends_with('?')) {
    if (value.is_null()) return true;
    what.pop_back();
  }
  if (what == "null") return value.is_null();
  if (what == "text") return value.is_string();
  const std::size_t to = what.find("..");
  return value.is_number() && value >= std::stod(what.substr(0, to)) && value <= std::stod(what.substr(to + 2));
}

/// The views that have rows.
std::vector<std::string> check_views(const Program& program, const std::string& database) {
  const Views listed = listed_views();
  std::vector<std::string> filled;
  for (const ordered_json& view :
       rows_asked(program, database, "SELECT name FROM sqlite_master WHERE type = 'view' ORDER BY name")) {
    const std::string name = view["name"];
    if (!listed.contains(name)) {
      ADD_FAILURE() << name << " is not listed in this test";
      continue;
    }
    std::vector<std::string> there, known;
    for (const ordered_json& column :
         rows_asked(program, database, "SELECT name FROM pragma_table_info('" + name + "') ORDER BY cid"))
      there.push_back(column["name"]);
    for (const Column& column : listed.at(name)) known.push_back(column.name);
    EXPECT_EQ(there, known) << name;
    const ordered_json rows = rows_asked(program, database, "SELECT * FROM " + name);
    if (!rows.empty()) filled.push_back(name);
    for (const ordered_json& row : rows)
      for (const Column& column : listed.at(name))
        EXPECT_TRUE(row.contains(column.name) && holds(row[column.name], column.expected))
            << name << '.' << column.name << " is to hold " << column.expected << ": " << row;
  }
  return filled;
}

TEST(ViewColumns, HoldWhatADiagnosisAndARunComputed) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"compare", "first-steps.toml"}).exit_code, 0);
  const Outcome diagnosis =
      program.run({"diagnose", "first-steps.toml", "--among", "coulomb_friction", "joint_spring"});
  ASSERT_EQ(diagnosis.exit_code, 0) << diagnosis.errors;
  program.write("small.toml", kSmallRun);
  const Outcome run = program.run({"run", "small.toml", "--db", "first-steps.db"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  ASSERT_EQ(rows_asked(program, "first-steps.db", "SELECT method FROM diagnoses")[0]["method"], "prediction");
  EXPECT_GE(check_views(program, "first-steps.db").size(), 18U) << "views with rows";
}

}  // namespace
}  // namespace lacuna
