#include "app/replace_file.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

#include <fstream>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

class ReplaceText : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(file_) << "old\n";
  }
  fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path file_ = folder_ / "rig.toml";
};

TEST_F(ReplaceText, WritesTheNewTextAndKeepsPermissions) {
  fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  const auto before = fs::status(file_).permissions();
  replace_text(file_, "old\n", "new\n");
  EXPECT_EQ(read_text(file_), "new\n");
  EXPECT_EQ(fs::status(file_).permissions(), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ReplaceText, RefusesAFileThatChangedMeanwhile) {
  EXPECT_THROW(replace_text(file_, "older\n", "new\n"), Error);
  EXPECT_EQ(read_text(file_), "old\n");
}

TEST_F(ReplaceText, FollowsSymbolicLinks) {
  const fs::path link = folder_ / "link.toml";
  fs::create_symlink(file_, link);
  replace_text(link, "old\n", "new\n");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_text(file_), "new\n");
}

}  // namespace
}  // namespace lacuna
