#include "foundation/processes/interrupt.h"
#include "foundation/text/problem.h"
#include "storage/child_process.h"
#include "storage/queries/query_output.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <chrono>
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
    run_queries(Database::open_read_only(file_, when_interrupted()), sql, *make_query_output(format, text));
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

TEST_F(QueryTest, ATableThatDoesNotFitIntoMemoryIsRefused) {
  const auto print = [&](const std::string& rows, QueryFormat format) {
    std::ostringstream text;
    const std::string sql =
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " + rows + ") SELECT i FROM n";
    run_queries(Database::open_read_only(file_), sql, *make_query_output(format, text, 2'000'000));
    return text.str();
  };
  EXPECT_THAT(print("10000", QueryFormat::table), HasSubstr("\n10000\n"));
  EXPECT_THAT(print("100000", QueryFormat::csv), HasSubstr("\n100000\n"));
  try {
    print("100000", QueryFormat::table);
    FAIL() << "no complaint";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("the table needs more than 2 MB of memory and was not printed"));
  }
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

TEST_F(QueryTest, FunctionsAreThoseThatOnlyCompute) {
  EXPECT_EQ(ask("SELECT round(sqrt(16)) AS a, json_extract('{\"b\":2}', '$.b') AS b, upper('c') AS c, "
                "group_concat(value) AS d, row_number() OVER () AS e FROM json_each('[1,2]')",
                QueryFormat::csv),
            "a,b,c,d,e\n4,2,C,\"1,2\",1\n");
  EXPECT_THAT(complaint("SELECT load_extension('x')"), HasSubstr("not authorized to use function: load_extension"));
  EXPECT_THAT(complaint("SELECT sqlite_compileoption_get(1)"), HasSubstr("a query may use SQLite's functions"));
  for (const std::string name : {"fts3_tokenizer('simple')", "rtreenode(2, x'00')", "readfile('/etc/passwd')"})
    EXPECT_THAT(complaint("SELECT " + name), HasSubstr("no such function: " + name.substr(0, name.find('(')))) << name;
  for (const std::string table : {"dbstat", "sqlite_dbpage", "fts3tokenize('simple', 'a')", "sqlite_stmt"})
    EXPECT_THAT(complaint("SELECT * FROM " + table), HasSubstr("no such table")) << table;
}

TEST_F(QueryTest, FunctionsThatTakeLongAreTheSameAndQuick) {
  EXPECT_EQ(
      ask("SELECT instr('aéb', 'b') AS a, instr(x'aabbcc', x'cc') AS b, instr('a', '') AS c, instr('', 'a') AS d, "
          "instr(1234, 3) AS e, instr(NULL, 'a') IS NULL AS f",
          QueryFormat::csv),
      "a,b,c,d,e,f\n3,3,1,0,3,1\n");
  EXPECT_EQ(ask("SELECT replace('aXbX', 'X', 'yz') AS a, replace('aa', '', 'b') AS b, replace(1212, 2, 3) AS c, "
                "replace('a', 'a', NULL) IS NULL AS d, replace('', 'a', 'b') AS e",
                QueryFormat::csv),
            "a,b,c,d,e\nayzbyz,aa,1313,1,\n");
  EXPECT_EQ(ask("SELECT trim('  a ') AS a, ltrim('éaé', 'é') AS b, rtrim('xyabyx', 'xy') AS c, trim('aaa', 'a') AS d",
                QueryFormat::csv),
            "a,b,c,d\na,aé,xyab,\n");
  const auto begin = std::chrono::steady_clock::now();
  ask("WITH t (x) AS (SELECT hex(zeroblob(4000000))) SELECT instr(x, x || '1'), "
      "length(replace(x, substr(x, 1, 2000000) || '1', '')) FROM t");
  EXPECT_THAT(complaint("SELECT trim('a', hex(zeroblob(1000)))"), HasSubstr("too many characters"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST_F(QueryTest, ValuesAndMemoryHaveALimit) {
  for (const std::string value : {"zeroblob(1000000000)", "randomblob(1000000000)", "hex(zeroblob(100000000))",
                                  "replace(hex(zeroblob(1000000)), '0', hex(zeroblob(1000)))"})
    EXPECT_THAT(complaint("SELECT length(" + value + ")"), HasSubstr("too big; a value may have at most 134 MB"))
        << value;
  const auto begin = std::chrono::steady_clock::now();
  for (const std::string value :
       {"printf('%.*c', 2000000000, 'x')", "printf('%d %-+3.*c', 1, -2000000000, 'x')", "format('%.2000000000c', 'x')",
        "printf('%99999999999999999999.99999999999999999999c', 'x')"})
    EXPECT_THAT(complaint("SELECT length(" + value + ")"), HasSubstr("too big; a value may have at most 134 MB"))
        << value;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  EXPECT_EQ(ask("SELECT printf('%.3c|%5.1f|%s|%%|%,d|%*d|%.*f', 'x', 2.25, 'a', 12345, 4, 7, 1, 0.25) AS a, "
                "format('%s', NULL) AS b, printf(NULL) IS NULL AS c",
                QueryFormat::csv),
            "a,b,c\n\"xxx|  2.3|a|%|12,345|   7|0.3\",,1\n");
  std::string many = "SELECT ";
  for (int i = 0; i < 12; ++i) many += "printf('%.*c', 100000000, 'x') AS c" + std::to_string(i) + (i < 11 ? "," : "");
  EXPECT_THAT(complaint("SELECT length(c0) FROM (" + many + " ORDER BY 1)"),
              HasSubstr("needs more than 1073 MB of memory"));
  std::string deep = "1";
  for (int i = 0; i < 300; ++i) deep += "+1";
  EXPECT_THAT(complaint("SELECT " + deep), HasSubstr("Expression tree is too large"));
}

/// What a stranger may have put into a file that has our header.
TEST_F(QueryTest, AHostileFileGivesSentences) {
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open(file_.c_str(), &handle), SQLITE_OK);
  const auto change = [&](const char* sql) {
    ASSERT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(handle);
  };
  change("CREATE VIEW tokens AS SELECT fts3_tokenizer('simple')");
  change("CREATE VIEW extension AS SELECT load_extension('x')");
  change("CREATE VIEW itself AS SELECT * FROM itself2; CREATE VIEW itself2 AS SELECT * FROM itself");
  change("CREATE VIEW long AS SELECT length(zeroblob(1000000000)) AS x");
  change("CREATE VIRTUAL TABLE words USING fts4(a)");
  change(
      "CREATE TABLE loud (a, b); INSERT INTO loud (a) VALUES (1);"
      "CREATE TRIGGER shout AFTER INSERT ON run BEGIN DELETE FROM loud; END");
  change("CREATE VIEW \"a\"\"; DROP TABLE loud; --\" AS SELECT 1");
  change("DROP VIEW runs; CREATE VIEW runs AS SELECT * FROM trace_samples(1)");
  EXPECT_THAT(complaint("SELECT * FROM tokens"), HasSubstr("no such function: fts3_tokenizer"));
  EXPECT_THAT(complaint("SELECT * FROM extension"), HasSubstr("SQL:1:1: "));
  EXPECT_THAT(complaint("SELECT * FROM itself"), HasSubstr("circularly defined"));
  EXPECT_THAT(complaint("SELECT * FROM long"), HasSubstr("too big"));
  EXPECT_THAT(complaint("SELECT * FROM words"), HasSubstr("no such module: fts4; of table modules"));
  change("DROP VIEW itself; DROP VIEW itself2; PRAGMA legacy_alter_table = ON");
  change(
      "ALTER TABLE trace RENAME TO kept; CREATE VIEW trace AS SELECT trace AS id, channel AS channels, 1 AS "
      "sample_count, 'float32' AS precision, x'' AS times, x'' AS samples, '' AS digest FROM trace_samples(1)");
  EXPECT_THAT(complaint("SELECT * FROM trace_samples(1)"), HasSubstr("SQL:1:"));
  change("DROP VIEW trace; ALTER TABLE kept RENAME TO trace; UPDATE schema_text SET sha256 = 'x' WHERE name = 'views'");
  sqlite3_close(handle);
  {
    Database database = Database::open(file_);
    ResultStore store(database);
    store.begin_run({.command = "test", .seed = 1, .threads = 1}, {});
  }
  EXPECT_EQ(ask("SELECT a FROM loud", QueryFormat::csv), "a\n1\n") << "neither a trigger nor a name is carried out";
}

TEST_F(QueryTest, AFaultInTheMiddleOfAQueryIsReported) {
  EXPECT_THAT(complaint("SELECT json_extract('{', '$')"), HasSubstr("malformed JSON"));
}

}  // namespace
}  // namespace lacuna
