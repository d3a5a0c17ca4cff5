#include "app/commands/commands.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <vector>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr int kDone = 0;
constexpr int kBadInput = 2;

class SqlCommand : public testing::Test {
 protected:
  SqlCommand() {
    Database database = Database::open(file_);
    ResultStore store(database);
    test::fill_small_database(store);
  }

  int lacuna_sql(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"lacuna", "sql"});
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_program(static_cast<int>(pointers.size()), pointers.data());
    said_ = testing::internal::GetCapturedStdout();
    complained_ = testing::internal::GetCapturedStderr();
    return code;
  }

  TestFolder folder_;
  std::string file_ = (folder_ / "rig.db").string();
  std::string said_;
  std::string complained_;
};

TEST_F(SqlCommand, PrintsATable) {
  EXPECT_EQ(lacuna_sql({file_, "SELECT revision, change FROM error_by_revision ORDER BY revision"}), kDone);
  EXPECT_EQ(said_,
            "revision  change\n"
            "--------  ----------------\n"
            "       1  rigid\n"
            "       2  coulomb_friction\n");
}

TEST_F(SqlCommand, TakesTheFormatBeforeOrAfterTheStatement) {
  EXPECT_EQ(lacuna_sql({file_, "--csv", "SELECT 1 AS a"}), kDone);
  EXPECT_EQ(said_, "a\n1\n");
  EXPECT_EQ(lacuna_sql({file_, "--json", "SELECT 1 AS a"}), kDone);
  EXPECT_EQ(said_, "[\n{\"a\":1}\n]\n");
  EXPECT_EQ(lacuna_sql({file_, "SELECT 1 AS a", "--json"}), kDone);
  EXPECT_EQ(said_, "[\n{\"a\":1}\n]\n");
}

TEST_F(SqlCommand, WritesJsonToAFile) {
  const std::string json = (folder_ / "a.json").string();
  EXPECT_EQ(lacuna_sql({file_, "SELECT 1 AS a", "--json=" + json}), kDone);
  EXPECT_EQ(said_, "");
  std::stringstream content;
  content << std::ifstream(json).rdbuf();
  EXPECT_EQ(content.str(), "[\n{\"a\":1}\n]\n");
  EXPECT_EQ(lacuna_sql({file_, "SELECT 1 AS a", "--json=" + (folder_ / "no/such.json").string()}), kBadInput);
  EXPECT_THAT(complained_, HasSubstr("such.json: cannot be written"));
}

TEST_F(SqlCommand, ListsTheViewsWithExamples) {
  EXPECT_EQ(lacuna_sql({file_, "--views"}), kDone);
  EXPECT_THAT(said_, HasSubstr("error_by_revision\n  One row per revision and channel"));
  EXPECT_THAT(said_, HasSubstr("\n  SELECT revision, change, channel"));
}

TEST_F(SqlCommand, SaysWhatIsWrongWithItsInput) {
  EXPECT_EQ(lacuna_sql({file_, "SELECT nowhere FROM runs"}), kBadInput);
  EXPECT_THAT(complained_, HasSubstr("SQL:1:8: no such column: nowhere"));
  EXPECT_EQ(lacuna_sql({file_}), kBadInput);
  EXPECT_EQ(lacuna_sql({(folder_ / "none.db").string(), "SELECT 1"}), kBadInput);
  EXPECT_THAT(complained_, HasSubstr("none.db: no such database"));
}

}  // namespace
}  // namespace lacuna
