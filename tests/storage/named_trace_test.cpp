#include "foundation/text/problem.h"
#include "storage/queries/query_output.h"
#include "storage/queries/stored_tables.h"
#include "storage/small_database.h"
#include "storage/traces/named_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

class NamedTraceTest : public testing::Test {
 protected:
  NamedTraceTest() { test::fill_small_database(store_); }

  std::optional<NamedTrace> find(const std::string& name, std::optional<int> revision = std::nullopt) const {
    return find_named_trace(database_, {name, revision});
  }
  std::string complaint(const std::string& name, std::optional<int> revision = std::nullopt) const {
    try {
      find(name, revision);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "no complaint";
  }
  /// Numbers of the traces of a kind, as the view has them.
  std::vector<std::string> traces(const std::string& kind) const {
    std::ostringstream text;
    run_queries(database_, "SELECT id FROM traces WHERE kind = '" + kind + "' ORDER BY id",
                *make_query_output(QueryFormat::csv, text));
    std::istringstream lines(text.str());
    std::vector<std::string> numbers;
    for (std::string line; std::getline(lines, line);) numbers.push_back(line);
    numbers.erase(numbers.begin());
    return numbers;
  }

  TestFolder folder_;
  Database database_ = Database::open(folder_ / "rig.db");
  ResultStore store_{database_};
};

TEST_F(NamedTraceTest, HasTheReadingsBesideTheNewestPrediction) {
  for (const std::string name : {"sine", "sine.csv"}) {
    const std::optional<NamedTrace> found = find(name);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->experiment, "rig");
    EXPECT_EQ(found->trial, "sine");
    EXPECT_EQ(found->revision, 2);
    ASSERT_THAT(found->parts, SizeIs(2));
    EXPECT_EQ(found->parts[0].label, "measured");
    EXPECT_EQ(found->parts[0].series.samples, test::sine(1000).samples);
    EXPECT_EQ(found->parts[1].label, "predicted");
    EXPECT_EQ(found->parts[1].series.samples.cast<float>(), test::sine(1000, 0.29).samples.cast<float>());
  }
}

TEST_F(NamedTraceTest, IsOfTheRevisionThatIsAskedFor) {
  EXPECT_EQ(find("sine", 1)->revision, 1);
  EXPECT_THAT(
      complaint("sine", 7),
      HasSubstr("--revision 7: this revision has no prediction of sine; there are predictions of revision 1, 2"));
}

TEST_F(NamedTraceTest, IsOfAFittedModelBeforeOneAsWritten) {
  const StoredTrial trial = store_.trials(store_.record_experiment({"rig", "rig.toml", "x", {}})).front();
  ComparisonRecord as_written;
  as_written.kind = ComparisonKind::as_written;
  store_.begin_run({.command = "lacuna compare --as-is"}, {});
  const StoredRevision first = *store_.revision(store_.record_experiment({"rig", "rig.toml", "x", {}}), 1);
  const ComparisonId comparison = store_.record_comparison(first.id, as_written);
  store_.record_trace(trial.id, TraceKind::predicted, test::sine(1000, 0.1), TracePrecision::float32, comparison);
  EXPECT_EQ(find("sine")->revision, 2);
}

/// A trial that was read anew in between: the model of its first readings predicted last.
TEST_F(NamedTraceTest, IsTheNewestOfAllReadingsOfATrial) {
  const ExperimentId rig = store_.record_experiment({"rig", "rig.toml", "x", {}});
  const StoredTrial before = store_.trials(rig).front();
  store_.begin_run({.command = "lacuna compare rig.toml"}, {});
  const TrialId anew = store_.find_or_add_trial(rig, {"sine", "sine.csv", std::string(64, 'b'), false, 1.0, 10});
  ASSERT_NE(anew, before.id);
  const StoredRevision first = *store_.revision(rig, 1);
  const ComparisonId comparison = store_.record_comparison(first.id, {});
  store_.record_trace(anew, TraceKind::measured, test::sine(10), TracePrecision::float64);
  store_.record_trace(anew, TraceKind::predicted, test::sine(10, 0.2), TracePrecision::float32, comparison);
  EXPECT_EQ(find("sine")->revision, 1);
  EXPECT_EQ(find("sine", 2)->parts.at(0).series.samples, test::sine(1000).samples);
  store_.record_trace(before.id, TraceKind::predicted, test::sine(1000, 0.25), TracePrecision::float32,
                      store_.record_comparison(store_.revision(rig, 2)->id, {}));
  EXPECT_EQ(find("sine")->revision, 2);
}

TEST_F(NamedTraceTest, ByItsNumberIsOneTrace) {
  const std::optional<NamedTrace> measured = find(traces("measured").at(0));
  ASSERT_TRUE(measured);
  EXPECT_THAT(measured->parts, SizeIs(1));
  const std::optional<NamedTrace> predicted = find(traces("predicted").at(0));
  ASSERT_TRUE(predicted);
  EXPECT_EQ(predicted->revision, 1);
  EXPECT_THAT(predicted->parts, SizeIs(2));
  EXPECT_FALSE(find("12345"));
  EXPECT_THAT(complaint(traces("predicted").at(0), 2), HasSubstr("is not of this revision"));
}

TEST_F(NamedTraceTest, IsNoneWithoutTracesOrOfAnotherName) {
  EXPECT_FALSE(find("chirp")) << "it has no trace";
  EXPECT_FALSE(find("sines"));
  EXPECT_THAT(names_of_traces(database_, 10), ElementsAre("sine"));
}

TEST_F(NamedTraceTest, OfSeveralExperimentsIsRefused) {
  store_.begin_run({.command = "lacuna compare other.toml"}, {});
  const ExperimentId other = store_.record_experiment({"other", "other.toml", "text", {}});
  const TrialId trial = store_.find_or_add_trial(other, {"sine", "sine.csv", test::kSomeDigest, false, 1.0, 10});
  store_.record_trace(trial, TraceKind::measured, test::sine(10), TracePrecision::float64);
  EXPECT_THAT(complaint("sine"), AllOf(HasSubstr("names several trials"), HasSubstr("sine of rig"),
                                       HasSubstr("sine of other"), HasSubstr("view traces")));
}

TEST_F(NamedTraceTest, TablesAndViewsAreReadWhole) {
  const StoredTables tables = stored_tables(database_);
  EXPECT_THAT(tables.views, AllOf(Contains("error_by_revision"), Not(Contains("fit"))));
  EXPECT_THAT(tables.tables, AllOf(Contains("fit"), Not(Contains(HasSubstr("sqlite_")))));
  std::ostringstream text;
  read_table(database_, "run", *make_query_output(QueryFormat::json_lines, text));
  EXPECT_THAT(text.str(), AllOf(testing::StartsWith("{\"number\":1,"), testing::EndsWith("}\n")));
}

}  // namespace
}  // namespace lacuna
