#include "storage/asked.h"
#include "storage/queries/query.h"
#include "storage/queries/verification.h"
#include "support/test_folder.h"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/// Databases that programs of earlier schema versions wrote, as SQL text: vNN.sql is one of version NN. Beside each,
/// vNN.expected holds what it answered before it was migrated, a line a query: the answer, a tab, the query.
namespace lacuna {
namespace {

using testing::IsEmpty;

const std::filesystem::path kSamples = LACUNA_SOURCE_DIRECTORY "/tests/storage/schema_samples";

/// Versions that have no sample, and why.
const std::map<int, std::string> kVersionsWithoutSample = {
    {5, "versions 5 and 6 came with one commit, so that no committed program ended at 5"},
};

std::string sample_name(int version) { return fmt::format("v{:02}", version); }

std::vector<int> versions_with_sample() {
  std::vector<int> versions;
  for (const auto& entry : std::filesystem::directory_iterator(kSamples))
    if (entry.path().extension() == ".sql") versions.push_back(std::stoi(entry.path().stem().string().substr(1)));
  std::sort(versions.begin(), versions.end());
  return versions;
}

struct ExpectedAnswer {
  std::string answer;
  std::string query;
};

std::vector<ExpectedAnswer> expected_answers(int version) {
  std::istringstream lines(read_bytes(kSamples / (sample_name(version) + ".expected")));
  std::vector<ExpectedAnswer> answers;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos) throw Error("a line without a tab: " + line);
    answers.push_back({line.substr(0, tab), line.substr(tab + 1)});
  }
  return answers;
}

std::string first_text(const Database& database, const std::string& query) {
  Statement statement(database, query.c_str());
  return statement.step() ? statement.text(0) : "no row";
}

/// Names and definitions of all tables and indices.
std::string definitions(const Database& database) {
  return first_text(database,
                    "SELECT count(*) || group_concat(replace(replace(sql, '\"', ''), ' ', '')) FROM"
                    " (SELECT * FROM sqlite_master WHERE sql IS NOT NULL AND type <> 'view' ORDER BY name)");
}

class SchemaSample : public testing::TestWithParam<int> {
 protected:
  SchemaSample() {
    SQLite::Database(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec(read_bytes(kSamples / (sample_name(GetParam()) + ".sql")));
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "sample.db";
};

TEST_P(SchemaSample, IsOfItsVersion) {
  SQLite::Database sample(file_.string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(sample.execAndGet("PRAGMA user_version").getInt(), GetParam());
  EXPECT_EQ(sample.execAndGet("PRAGMA application_id").getInt(), kApplicationId);
  const std::vector<ExpectedAnswer> answers = expected_answers(GetParam());
  EXPECT_GE(answers.size(), 10U);
  for (const auto& [answer, query] : answers) EXPECT_EQ(sample.execAndGet(query).getString(), answer) << query;
}

TEST_P(SchemaSample, KeepsWhatItHolds) {
  const Database migrated = Database::open(file_);
  EXPECT_EQ(test::ask(migrated, "PRAGMA user_version"), schema_migrations().back().number);
  for (const auto& [answer, query] : expected_answers(GetParam()))
    EXPECT_EQ(first_text(migrated, query), answer) << query;
  EXPECT_TRUE(test::is_intact(migrated));
}

/// Hashes of traces, of texts and, from version 15 on, of the rows of runs.
TEST_P(SchemaSample, KeepsWhatItsHashesSay) {
  Database::open(file_);
  const Verification found = verify(Database::open_read_only(file_));
  EXPECT_THAT(found.damage, IsEmpty());
  EXPECT_THAT(found.seals.broken, IsEmpty());
  EXPECT_EQ(found.seals.sealed.empty(), GetParam() < 15);
}

TEST_P(SchemaSample, HasTheTablesOfANewDatabase) {
  EXPECT_EQ(definitions(Database::open(file_)), definitions(Database::open(folder_ / "new.db")));
}

TEST_P(SchemaSample, HasTodaysViews) {
  const Database migrated = Database::open(file_);
  const std::vector<ViewDescription> views = view_descriptions();
  EXPECT_EQ(test::ask(migrated, "SELECT count(*) FROM sqlite_master WHERE type = 'view'"),
            static_cast<std::int64_t>(views.size()));
  for (const ViewDescription& view : views) {
    Statement all(migrated, ("SELECT * FROM " + name_in_sql(view.name)).c_str());
    EXPECT_NO_THROW(while (all.step());) << view.name;
  }
}

TEST_P(SchemaSample, IsMigratedOnce) {
  Database::open(file_);
  const std::string bytes = read_bytes(file_);
  Database::open(file_);
  EXPECT_TRUE(read_bytes(file_) == bytes);
  EXPECT_EQ(SQLite::Database(file_.string() + ".before-version-" + std::to_string(schema_migrations().back().number))
                .execAndGet("PRAGMA user_version")
                .getInt(),
            GetParam());
}

/// A copy is migrated; the file stays as it is.
TEST_P(SchemaSample, IsReadWithoutBeingChanged) {
  const std::string bytes = read_bytes(file_);
  {
    const Database read = Database::open_read_only(file_);
    for (const auto& [answer, query] : expected_answers(GetParam()))
      EXPECT_EQ(first_text(read, query), answer) << query;
  }
  EXPECT_TRUE(read_bytes(file_) == bytes);
}

INSTANTIATE_TEST_SUITE_P(Versions, SchemaSample, testing::ValuesIn(versions_with_sample()),
                         [](const auto& version) { return sample_name(version.param); });

/// Version 16 wrote a chance of 1 and a probability of 0 where errors over horizons decided, and the fitted errors as
/// those of what was left out.
TEST(SchemaSamples, ViewsLeaveOutWhatAnOldDiagnosisByHorizonNeverComputed) {
  const TestFolder folder;
  const std::filesystem::path file = folder / "sample.db";
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(read_bytes(kSamples / "v16.sql"));
  const Database migrated = Database::open(file);
  EXPECT_EQ(first_text(migrated, "SELECT group_concat(method, ' ') FROM diagnoses"), "likelihood horizon");
  EXPECT_EQ(first_text(migrated,
                       "SELECT group_concat(quote(chance) || ' ' || quote(round(base_times_floor, 1)) || ' ' ||"
                       " quote(round(times_floor, 2)), ', ') FROM diagnoses"),
            "0.0005 4.9 3.18, NULL NULL NULL");
  EXPECT_EQ(first_text(migrated,
                       "SELECT group_concat(quote(round(base_fitted_times_floor, 1)) || ' ' ||"
                       " quote(round(fitted_times_floor, 2)), ', ') FROM diagnoses"),
            "NULL NULL, 19.7 1.09");
  EXPECT_EQ(first_text(migrated,
                       "SELECT count(probability) || count(times_floor) || count(fitted_times_floor)"
                       " FROM effect_ranking WHERE method = 'horizon'"),
            "002");
}

TEST(SchemaSamples, EveryEarlierVersionHasOne) {
  const std::vector<int> versions = versions_with_sample();
  for (int version = 1; version < schema_migrations().back().number; ++version) {
    const bool has_sample = std::binary_search(versions.begin(), versions.end(), version);
    EXPECT_NE(has_sample, kVersionsWithoutSample.contains(version)) << "version " << version;
  }
}

}  // namespace
}  // namespace lacuna
