#include "app/terminal/replace_file.h"

#include <lacuna/error.h>

#include "foundation/text/problem.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

class ReplaceText : public testing::Test {
 protected:
  const TestFolder folder_;
  const fs::path file_ = folder_.write("rig.toml", "old\n");
};

TEST_F(ReplaceText, WritesTheNewTextAndKeepsPermissions) {
  fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  const auto before = fs::status(file_).permissions();
  {
    TextReplacement replacement(file_, "old\n", "new\n");
    EXPECT_EQ(read_text(file_), "old\n") << "not before it is published";
    replacement.publish();
  }
  EXPECT_EQ(read_text(file_), "new\n");
  EXPECT_EQ(fs::status(file_).permissions(), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(ReplaceText, RefusesAFileThatChangedMeanwhile) {
  TextReplacement replacement(file_, "older\n", "new\n");
  EXPECT_THROW(replacement.publish(), Error);
  EXPECT_EQ(read_text(file_), "old\n");
  replacement.take_back();
  EXPECT_EQ(read_text(file_), "old\n") << "nothing was published";
}

TEST_F(ReplaceText, TakesItBack) {
  TextReplacement replacement(file_, "old\n", "new\n");
  replacement.publish();
  replacement.take_back();
  EXPECT_EQ(read_text(file_), "old\n");
}

TEST_F(ReplaceText, DoesNotTakeBackWhatSomeoneElseWrote) {
  TextReplacement replacement(file_, "old\n", "new\n");
  replacement.publish();
  folder_.write("rig.toml", "mine\n");
  replacement.take_back();
  EXPECT_EQ(read_text(file_), "mine\n");
}

TEST_F(ReplaceText, IsKnownToFailBeforehandWhereTheFileMayNotBeWritten) {
  EXPECT_NO_THROW(check_replaceable(file_));
  fs::permissions(folder_.path(), fs::perms(0755));
  fs::permissions(file_, fs::perms(0444));
  const auto check_as_another_user = [this] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(1);
    try {
      check_replaceable(file_);
    } catch (const BadInput& error) {
      std::fputs(error.what(), stderr);
      ::_exit(2);
    }
    ::_exit(0);
  };
  EXPECT_EXIT(check_as_another_user(), testing::ExitedWithCode(2), "rig.toml: may not be changed");
}

TEST_F(ReplaceText, FollowsSymbolicLinks) {
  const fs::path link = folder_ / "link.toml";
  fs::create_symlink(file_, link);
  TextReplacement(link, "old\n", "new\n").publish();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_text(file_), "new\n");
}

}  // namespace
}  // namespace lacuna
