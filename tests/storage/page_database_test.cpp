#include "storage/pages/page_database.h"

#include "foundation/text/problem.h"

#include "storage/asked.h"
#include "storage/core/without_folders.h"
#include "storage/made_up_run.h"
#include "storage/pages/readable_database.h"
#include "storage/queries/page_query.h"
#include "storage/results/stored_run.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace lacuna {
namespace {

using test::ask;
using test::sentence_of;
using testing::HasSubstr;

constexpr std::size_t kPlenty = 50'000'000;

class PageDatabaseTest : public testing::Test {
 protected:
  PageDatabaseTest() {
    ResultStore store(database_);
    small_ = test::fill_small_database(store);
    test::add_made_up_run(database_);
  }
  /// The copy as a file of its own.
  Database kept(const PageDatabase& pages) const {
    const std::vector<std::byte> bytes = pages.bytes();
    return Database::open_read_only(
        folder_.write("copy.db", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
  }
  PageTable asked(const std::string& sql, std::vector<PageCell> values = {}, std::size_t most = 1000) const {
    return answered({.sql = sql, .values = std::move(values), .most_rows = most});
  }
  PageTable answered(PageQuery query) const {
    query.longest = std::chrono::milliseconds(200);
    return ask_for_page(file_, pages_file_, query);
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
  std::filesystem::path pages_file_ = folder_ / "pages.db";
  Database database_ = Database::open(file_);
  test::SmallDatabase small_;
};

TEST_F(PageDatabaseTest, CopiesEveryRowAndViewButNotTheStatesOfCheckpoints) {
  PageDatabase pages;
  pages.copy(database_, kPlenty);
  const Database copy = kept(pages);
  for (const char* table : {"run", "model", "model_score", "test", "test_score", "trace", "trial", "best_value",
                            "comparison_score", "diagnosis", "error_by_pass", "latest_comparison", "effect_ranking"}) {
    const std::string count = std::string("SELECT count(*) FROM ") + table;
    EXPECT_GT(ask(copy, count.c_str()), 0) << table;
    EXPECT_EQ(ask(copy, count.c_str()), ask(database_, count.c_str())) << table;
  }
  EXPECT_EQ(ask(copy, "SELECT sum(length(state)) FROM checkpoint"), 0);
  EXPECT_EQ(ask(copy, "SELECT count(*) FROM page_note"), 0);
  EXPECT_TRUE(test::is_intact(copy));
}

TEST_F(PageDatabaseTest, OfALargeDatabaseTakesWhatPassesNeedAndSaysSo) {
  PageDatabase pages;
  pages.copy(database_, 1000);
  const Database copy = kept(pages);
  EXPECT_EQ(ask(copy, "SELECT count(*) FROM page_note WHERE sentence LIKE '%selection%'"), 1);
  EXPECT_EQ(
      ask(copy, "SELECT count(*) FROM page_note WHERE sentence LIKE '%only the best models and tests of each pass%'"),
      1);
  EXPECT_LT(ask(copy, "SELECT count(*) FROM model"), ask(database_, "SELECT count(*) FROM model"));
  EXPECT_LT(ask(copy, "SELECT count(*) FROM trace"), ask(database_, "SELECT count(*) FROM trace"));
  for (const char* view : {"error_by_pass", "best_model", "transfer_gap", "error_by_revision"}) {
    const std::string count = std::string("SELECT count(*) FROM ") + view;
    EXPECT_EQ(ask(copy, count.c_str()), ask(database_, count.c_str())) << view;
  }
}

TEST_F(PageDatabaseTest, ASelectionIsNoLargerThanAskedForAndSaysHowLargeItIs) {
  for (const std::size_t most : {400'000U, 700'000U}) {
    PageDatabase pages;
    pages.copy(database_, most);
    EXPECT_LE(pages.size(), most);
    const Database copy = kept(pages);
    const std::string says = fmt::format(
        "SELECT count(*) FROM page_note WHERE sentence LIKE '%a selection of it, "
        "{:.1f} MB; %'",
        static_cast<double>(pages.size()) / 1e6);
    EXPECT_EQ(ask(copy, says.c_str()), ask(copy, "SELECT count(*) > 0 FROM page_note")) << most;
  }
}

TEST_F(PageDatabaseTest, ASelectionKnowsHowManyModelsThereWere) {
  PageDatabase pages;
  pages.copy(database_, 1000);
  const Database copy = kept(pages);
  EXPECT_LT(ask(copy, "SELECT models FROM eea_runs"), ask(database_, "SELECT models FROM eea_runs"));
  EXPECT_EQ(ask(copy, "SELECT models FROM page_run"), ask(database_, "SELECT models FROM eea_runs"));
  EXPECT_EQ(ask(copy, "SELECT tests FROM page_run"), ask(database_, "SELECT tests FROM eea_runs"));
}

TEST_F(PageDatabaseTest, TellsNoFolders) {
  database_.execute(
      "UPDATE run SET command = 'lacuna run ''/home/ada/my rig/walk.toml'' --db /srv/x.db';"
      "UPDATE experiment_text SET file = '/home/ada/walk.toml';"
      "INSERT INTO plugin_file SELECT number, '/home/ada/lib/a.so', printf('%064d', 1), '' FROM run;"
      "INSERT INTO plugin_file SELECT number, '/usr/lib/a.so', printf('%064d', 1), '' FROM run;"
      "INSERT INTO robot_file SELECT number, '/home/ada/robots/r.toml', printf('%064d', 1) FROM run");
  PageDatabase pages;
  pages.copy(database_, kPlenty);
  const std::vector<std::byte> bytes = pages.bytes();
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_EQ(text.find("/home"), std::string::npos);
  EXPECT_EQ(text.find("/usr/lib"), std::string::npos);
  EXPECT_EQ(ask(kept(pages), "SELECT count(*) FROM run WHERE command = 'lacuna run ''walk.toml'' --db x.db'"),
            ask(database_, "SELECT count(*) FROM run"));
  EXPECT_NO_THROW(check_stored_texts(kept(pages))) << "a name without its folder is no edit";
}

TEST(WithoutFolders, KeepsNamesAndWhatIsNoPath) {
  EXPECT_EQ(without_folders("/home/ada/walk.toml: is not in this folder, /home/ada; go"),
            "walk.toml: is not in this folder, ada; go");
  EXPECT_EQ(without_folders("robots/a.toml and 3 /s, N/A, http://x.org/y, / and /x"),
            "robots/a.toml and 3 /s, N/A, http://x.org/y, / and /x");
  EXPECT_EQ(without_folders("--set a=\"/my files/b c/\" end"), "--set a=\"b c\" end");
  EXPECT_EQ(without_folders(""), "");
}

ReplayRecord replay_of(const std::string& identity) {
  ReplayRecord replay{.experiment = "rig",
                      .identity = identity,
                      .run = 2,
                      .trial = 0,
                      .pass = 1,
                      .model = 7,
                      .robot = "{}",
                      .traces = {}};
  replay.traces.emplace_back("model", test::sine(100));
  return replay;
}

TEST_F(PageDatabaseTest, KeepsRobotsInMotion) {
  PageDatabase pages;
  EXPECT_FALSE(pages.find_replay("a", 0, 7));
  const std::int64_t id = pages.add(replay_of("a"));
  EXPECT_EQ(pages.find_replay("a", 0, 7), id);
  pages.copy(database_, kPlenty);
  EXPECT_EQ(ask(kept(pages),
                "SELECT sample_count FROM page_replay JOIN page_replay_trace ON replay = page_replay.id "
                "WHERE run = 2 AND kind = 'model'"),
            100);
}

TEST_F(PageDatabaseTest, TellsRunsOfOneNumberInTwoFilesApart) {
  PageDatabase pages;
  const std::int64_t first = pages.add(replay_of("a"));
  EXPECT_FALSE(pages.find_replay("b", 0, 7));
  EXPECT_NE(pages.add(replay_of("b")), first);
}

TEST_F(PageDatabaseTest, AFaultLeavesNothingHalfDone) {
  PageDatabase pages(pages_file_);
  ReplayRecord twice = replay_of("a");
  twice.traces.push_back(twice.traces.front());
  EXPECT_THROW(pages.add(twice), Error);
  EXPECT_FALSE(pages.find_replay("a", 0, 7));
  pages.add(replay_of("b"));  // which a transaction left open would refuse
  EXPECT_EQ(asked("SELECT identity FROM page_replay").rows.size(), 1U);
}

class PageQueryTest : public PageDatabaseTest {
 protected:
  PageDatabase pages_{pages_file_};
};

TEST_F(PageQueryTest, BindsValuesAndGivesBytes) {
  const PageTable table = asked("SELECT ?1 + 1 AS a, ?2 AS b, ?3 AS c, x'0102' AS d, NULL AS e",
                                {std::int64_t{4}, std::string("text"), 0.5});
  EXPECT_EQ(table.columns, (std::vector<std::string>{"a", "b", "c", "d", "e"}));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0][0], PageCell(std::int64_t{5}));
  EXPECT_EQ(table.rows[0][1], PageCell(std::string("text")));
  EXPECT_EQ(table.rows[0][2], PageCell(0.5));
  EXPECT_EQ(table.rows[0][3], PageCell(std::vector<std::byte>{std::byte{1}, std::byte{2}}));
  EXPECT_EQ(table.rows[0][4], PageCell(std::monostate{}));
}

TEST_F(PageQueryTest, CutsLongAnswers) {
  const PageTable table = asked("SELECT * FROM model", {}, 3);
  EXPECT_EQ(table.rows.size(), 3U);
  EXPECT_TRUE(table.cut);
  EXPECT_FALSE(asked("SELECT 1").cut);
}

TEST_F(PageQueryTest, CutsLargeAnswers) {
  const PageTable table =
      answered({.sql = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 9) "
                       "SELECT zeroblob(1000) FROM n",
                .most_bytes = 3500});
  EXPECT_TRUE(table.cut);
  EXPECT_EQ(table.rows.size(), 4U);
}

TEST_F(PageQueryTest, SaysHowManyBytesThereAreWhereThatIsEnough) {
  const PageTable table = answered({.sql = "SELECT x'010203'", .sizes = true});
  EXPECT_EQ(std::get<Blob>(table.rows.at(0).at(0)).bytes, 3U);
}

TEST_F(PageQueryTest, RefusesValuesThatWouldNotFitIntoMemory) {
  EXPECT_THAT(sentence_of([&] { asked("SELECT zeroblob(1000000000)"); }), HasSubstr("too big"));
  EXPECT_THAT(sentence_of([&] { asked("SELECT 'x' LIKE printf('%.*c', 1000, '%')"); }), HasSubstr("too complex"));
}

TEST_F(PageQueryTest, HasSamplesAsRowsAndThePagesOwnTables) {
  EXPECT_EQ(asked("SELECT value FROM samples WHERE trace = (SELECT min(id) FROM trace)", {}, 5000).rows.size(), 1000U);
  EXPECT_GT(asked("SELECT * FROM page_view WHERE name = 'error_by_pass'").rows.size(), 0U);
}

TEST_F(PageQueryTest, RefusesAllButReading) {
  for (const char* sql : {"DELETE FROM run", "CREATE TABLE x (y)", "CREATE TEMP TABLE x (y)", "ATTACH '/tmp/x' AS y",
                          "PRAGMA query_only = OFF", "DELETE FROM page_note", "DETACH pages", "VACUUM",
                          "SELECT load_extension('x')", "UPDATE samples SET value = 1", "BEGIN"})
    EXPECT_THROW(static_cast<void>(asked(sql)), BadInput) << sql;
  EXPECT_THAT(sentence_of([&] { asked("SELECT * FROM nowhere"); }), HasSubstr("no such table: nowhere"));
  EXPECT_THAT(sentence_of([&] { asked(" -- nothing"); }), HasSubstr("there is no statement"));
}

TEST_F(PageQueryTest, EndsWhatTakesTooLong) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(sentence_of([&] {
                asked("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n");
              }),
              HasSubstr("took longer than"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST_F(PageQueryTest, FindsTheDatabaseThatTookAnothersPlace) {
  const std::string before = stamp_of(file_);
  EXPECT_EQ(stamp_of(file_), before);
  {
    Database other = Database::open(folder_ / "other.db");
    ResultStore store(other);
    store.begin_run({.command = "lacuna compare other.toml", .seed = 1, .threads = 1}, provenance_of_this_program());
    store.end_run(RunEnding::done);
  }
  for (const char* tail : {"", "-wal", "-shm"}) std::filesystem::remove(file_.string() + tail);
  EXPECT_EQ(stamp_of(file_), "");
  EXPECT_THROW(static_cast<void>(asked("SELECT 1")), BadInput);
  std::filesystem::rename(folder_ / "other.db", file_);
  EXPECT_NE(stamp_of(file_), before);
  EXPECT_EQ(asked("SELECT command FROM run").rows.at(0).at(0), PageCell(std::string("lacuna compare other.toml")));
}

TEST_F(PageQueryTest, OfAnOlderVersionsFileThereIsOneCopyForEachState) {
  const std::filesystem::path old = folder_ / "old.db";
  {
    std::vector<Migration> older = schema_migrations();
    older.pop_back();
    Database::open(old, older);
  }
  std::filesystem::create_directory(folder_ / "scratch");
  ReadableDatabase readable(old, folder_ / "scratch");
  const auto first = readable.file();
  EXPECT_NE(*first, old);
  EXPECT_EQ(readable.file(), first);
  EXPECT_EQ(ask_for_page(*first, pages_file_, {.sql = "SELECT count(*) FROM where_it_fails"}).rows.size(), 1U);
  Database::open(old);  // brings it up to date
  EXPECT_EQ(*readable.file(), old);
  EXPECT_TRUE(std::filesystem::exists(*first)) << "somebody reads it";
}

TEST_F(PageQueryTest, StampsChangeWithEachCommit) {
  const std::string before = stamp_of(file_);
  ResultStore store(database_);
  store.begin_run({.command = "lacuna fit rig.toml", .seed = 1, .threads = 1}, provenance_of_this_program());
  EXPECT_NE(stamp_of(file_), before);
}

}  // namespace
}  // namespace lacuna
