#include "foundation/text/problem.h"
#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/integrity/backup.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace lacuna {
namespace {

using test::add_experiments;
using test::ask;
using test::ChildProcess;
using test::is_intact;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class BackupTest : public testing::Test {
 protected:
  void fill(int experiments) const {
    Database database = Database::open(file());
    add_experiments(database, 0, experiments);
  }
  std::filesystem::path file() const { return folder_ / "rig.db"; }
  std::filesystem::path copy() const { return folder_ / "copy.db"; }
  /// Of the folder, beside the database and its log.
  std::vector<std::string> other_files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(file().parent_path()))
      if (const std::string name = entry.path().filename(); !name.starts_with("rig.db")) names.push_back(name);
    return names;
  }
  static int experiments_in(const std::filesystem::path& database) {
    return static_cast<int>(ask(Database::open_read_only(database), "SELECT count(*) FROM experiment"));
  }

  TestFolder folder_;
};

TEST_F(BackupTest, HoldsWhatTheDatabaseHeldAndNothingElseIsLeft) {
  fill(20);
  double last = 0.0;
  const std::uintmax_t bytes = back_up(file(), copy(), {}, [&](double part) { last = part; });
  EXPECT_EQ(bytes, std::filesystem::file_size(copy()));
  EXPECT_EQ(last, 1.0);
  EXPECT_THAT(other_files(), ElementsAre("copy.db"));
  EXPECT_TRUE(is_intact(Database::open_read_only(copy())));
  EXPECT_EQ(experiments_in(copy()), 20);
}

/// Each copy is one state: of what a transaction wrote all or nothing.
TEST_F(BackupTest, IsOneStateOfADatabaseThatIsWrittenMeanwhile) {
  fill(10);
  constexpr int kAtOnce = 7;
  ChildProcess writer([&](int to_parent) {
    Database database = Database::open(file());
    for (int round = 0;; ++round) {
      Transaction transaction(database);
      add_experiments(database, 10 + kAtOnce * round, kAtOnce);
      transaction.commit();
      if (round == 0) ChildProcess::say(to_parent, "w");
    }
  });
  ASSERT_EQ(writer.next(), 'w');
  int before = 0;
  for (int i = 0; i < 8; ++i) {
    const std::filesystem::path to = folder_ / ("copy-" + std::to_string(i) + ".db");
    back_up(file(), to);
    EXPECT_TRUE(is_intact(Database::open_read_only(to)));
    const int now = experiments_in(to);
    EXPECT_EQ((now - 10) % kAtOnce, 0) << now;
    EXPECT_GT(now, before);
    before = now;
  }
}

/// Restored: a copy in the place of the database is gone on with as the database was.
TEST_F(BackupTest, IsWrittenToAgainInThePlaceOfTheDatabase) {
  fill(3);
  back_up(file(), copy());
  fill(5);
  std::filesystem::rename(copy(), file());
  EXPECT_EQ(experiments_in(file()), 3);
  fill(4);
  EXPECT_EQ(experiments_in(file()), 4);
  EXPECT_TRUE(is_intact(Database::open_read_only(file())));
}

TEST_F(BackupTest, LeavesAFileThatIsThereAlone) {
  fill(1);
  std::ofstream(copy()) << "mine";
  EXPECT_THROW(back_up(file(), copy()), BadInput);
  EXPECT_THROW(back_up(file(), file()), BadInput);
  EXPECT_THROW(back_up(file(), folder_ / "."), BadInput);
  EXPECT_EQ(std::filesystem::file_size(copy()), 4U);
}

TEST_F(BackupTest, OfWhatIsNoDatabaseThereIsNone) {
  EXPECT_THROW(back_up(file(), copy()), BadInput);
  std::ofstream(file()) << "time,angle\n0,1\n";
  EXPECT_THROW(back_up(file(), copy()), Error);
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(BackupTest, OfADamagedDatabaseThereIsNone) {
  fill(40);
  {
    std::fstream bytes(file(), std::ios::in | std::ios::out | std::ios::binary);
    const auto middle = static_cast<std::streamoff>(std::filesystem::file_size(file()) / 2);
    bytes.seekp(middle - middle % 4096);
    bytes << std::string(4096, '\xff');
  }
  try {
    back_up(file(), copy());
    FAIL() << "a page of 0xff was copied";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("damaged"));
  }
  EXPECT_THAT(other_files(), IsEmpty());
}

/// What SQLite takes for sound, but is not what a run has ended with.
TEST_F(BackupTest, OfRowsThatAreNotThoseOfTheirRunThereIsNone) {
  {
    Database database = Database::open(file());
    ResultStore store(database);
    test::fill_small_database(store);
    store.end_run(RunEnding::done);
    Statement(database, "UPDATE fitted_value SET value = value + 1e-12").run();
  }
  try {
    back_up(file(), copy());
    FAIL() << "other values were copied";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("is damaged (run 1, table fitted_value: changed since the run ended"));
  }
  EXPECT_THAT(other_files(), IsEmpty());
}

}  // namespace
}  // namespace lacuna
