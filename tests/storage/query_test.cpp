#include "foundation/interrupt.h"
#include "foundation/problem.h"
#include "storage/child_process.h"
#include "storage/query_output.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <fmt/format.h>

#include <sstream>

namespace lacuna {
namespace {

using testing::HasSubstr;

class QueryTest : public testing::Test {
 protected:
  QueryTest() {
    Database database = Database::open(file_);
    ResultStore store(database);
    test::fill_small_database(store);
  }
  std::string ask(const std::string& sql, QueryFormat format = QueryFormat::table) const {
    std::ostringstream text;
    run_queries(Database::open_read_only(file_), sql, *make_query_output(format, text));
    return text.str();
  }
  std::string complaint(const std::string& sql) const {
    try {
      return "no complaint about " + sql + ": " + ask(sql);
    } catch (const BadInput& error) {
      return error.what();
    }
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
};

TEST_F(QueryTest, ATableHasAlignedColumnsWithNumbersToTheRight) {
  EXPECT_EQ(ask("SELECT 'µm' AS unit, 1.5 AS x UNION ALL SELECT 'rad', 200"),
            "unit    x\n"
            "----  ---\n"
            "µm    1.5\n"
            "rad   200\n");
}

TEST_F(QueryTest, NullIsNothingAndNoRowsAreSaid) {
  EXPECT_EQ(ask("SELECT NULL AS a, 'b' AS b"), "a  b\n-  -\n   b\n");
  EXPECT_EQ(ask("SELECT 1 AS a WHERE 0"), "a\n-\n(no rows)\n");
}

TEST_F(QueryTest, ALineBreakInACellDoesNotBreakTheTable) {
  EXPECT_EQ(ask("SELECT 'a' || char(10) || 'b' AS c"), "c\n---\na b\n");
}

TEST_F(QueryTest, CsvQuotesWhatNeedsItAndKeepsEveryDigit) {
  EXPECT_EQ(ask("SELECT 'a,\"b\"' AS text, 0.1 AS x, NULL AS n", QueryFormat::csv), "text,x,n\n\"a,\"\"b\"\"\",0.1,\n");
  EXPECT_EQ(ask("SELECT 1.0/3 AS x", QueryFormat::csv), "x\n0.3333333333333333\n");
}

TEST_F(QueryTest, JsonIsAListOfObjects) {
  EXPECT_EQ(ask("SELECT 1 AS a, 0.5 AS b, 'é\"' AS c, NULL AS d, 1e999 AS e", QueryFormat::json),
            "[\n{\"a\":1,\"b\":0.5,\"c\":\"é\\\"\",\"d\":null,\"e\":null}\n]\n");
  EXPECT_EQ(ask("SELECT 1 AS a WHERE 0", QueryFormat::json), "[]\n");
}

TEST_F(QueryTest, SeveralStatementsAreAnsweredInTurn) {
  EXPECT_EQ(ask("SELECT 1 AS a; -- and\nSELECT 2 AS b;"), "a\n-\n1\n\nb\n-\n2\n");
}

TEST_F(QueryTest, FaultsOfTheSqlHaveTheirPlace) {
  EXPECT_THAT(complaint("SELECT 1;\nSELECT numbr\nFROM runs"), HasSubstr("SQL:2:8: no such column: numbr"));
  EXPECT_THAT(complaint("SELEC 1"), HasSubstr("SQL:1:1: near \"SELEC\": syntax error"));
  EXPECT_THAT(complaint("SELECT * FROM error_by_revison"), HasSubstr("did you mean \"error_by_revision\"?"));
  EXPECT_THAT(complaint("SELECT * FROM quaternions"), HasSubstr("--views"));
  EXPECT_THAT(complaint("  -- nothing"), HasSubstr("no statement"));
}

TEST_F(QueryTest, NothingButReadingIsAllowed) {
  for (const std::string sql :
       {"DELETE FROM run", "INSERT INTO experiment (id, name) VALUES (1, 'x')", "DROP TABLE run",
        "UPDATE sqlite_master SET name = 'x'", "UPDATE run SET seed = 1", "VACUUM", "CREATE TEMP TABLE t (a)",
        "ATTACH 'other.db' AS other", "PRAGMA user_version = 3", "PRAGMA query_only = OFF",
        "PRAGMA journal_mode = DELETE", "BEGIN IMMEDIATE", "SELECT load_extension('x')", "VACUUM INTO 'copy.db'"}) {
    EXPECT_THAT(complaint(sql), HasSubstr("SQL:1:")) << sql;
  }
  EXPECT_FALSE(std::filesystem::exists("other.db"));
  EXPECT_FALSE(std::filesystem::exists("copy.db"));
}

TEST_F(QueryTest, SamplesOfATraceAreRows) {
  const std::string sine = "FROM traces, trace_samples(traces.id) WHERE kind = 'measured'";
  EXPECT_EQ(ask("SELECT count(*) AS n, max(time) AS end, min(channel) AS c " + sine, QueryFormat::csv),
            "n,end,c\n1000,0.999,angle\n");
  const TimeSeries series = test::sine(1000);
  EXPECT_EQ(ask("SELECT value " + sine + " AND sample = 17", QueryFormat::csv),
            fmt::format("value\n{}\n", series.samples(17, 0)));
  EXPECT_THAT(complaint("SELECT * FROM trace_samples"), HasSubstr("trace_samples needs the key of a trace"));
  EXPECT_THAT(complaint("SELECT * FROM trace_samples(12)"), HasSubstr("has no trace 12"));
}

TEST_F(QueryTest, ADamagedTraceIsAnErrorNotRows) {
  Database::open(file_).execute("UPDATE trace SET samples = CAST(x'01' || substr(samples, 2) AS BLOB)");
  EXPECT_THAT(complaint("SELECT count(*) FROM traces, trace_samples(traces.id)"), HasSubstr("is damaged"));
}

TEST_F(QueryTest, AnInterruptEndsALongQuery) {
  test::ChildProcess child([&](int to_parent) {
    watch_for_interrupts();
    test::ChildProcess::say(to_parent, "q");
    try {
      ask("WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT sum(i) FROM n");
    } catch (const Interrupted&) {
      test::ChildProcess::say(to_parent, "interrupted");
    }
  });
  ASSERT_EQ(child.next(), 'q');
  child.interrupt();
  EXPECT_EQ(child.all(), "interrupted");
}

TEST_F(QueryTest, AFaultInTheMiddleOfAQueryIsReported) {
  EXPECT_THAT(complaint("SELECT json_extract('{', '$')"), HasSubstr("malformed JSON"));
}

}  // namespace
}  // namespace lacuna
