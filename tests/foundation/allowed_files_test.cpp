#include "foundation/files/allowed_files.h"

#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

class AllowedFilesTest : public testing::Test {
 protected:
  std::string why(const fs::path& file) const { return allowed_.why_not_written(file); }

  TestFolder folder_, other_;
  AllowedFiles allowed_{{fs::canonical(folder_.path())}};
};

TEST_F(AllowedFilesTest, AreThoseInTheFolderAndBelowItWhetherTheyAreThereOrNot) {
  EXPECT_EQ(why(folder_.path()), "");
  EXPECT_EQ(why(folder_ / "new.toml"), "");
  EXPECT_EQ(why(folder_ / "new/deep/new.toml"), "");
  EXPECT_EQ(why(folder_ / "new/../new.toml"), "");
}

TEST_F(AllowedFilesTest, AreNoOthersByWhateverName) {
  const auto outside = testing::HasSubstr("lies outside " + fs::canonical(folder_.path()).string());
  fs::create_directory_symlink(other_.path(), folder_ / "folder");
  fs::create_symlink(other_ / "new.toml", folder_ / "file");
  EXPECT_THAT(why(other_ / "a.toml"), outside);
  EXPECT_THAT(why(folder_ / ".."), outside);
  EXPECT_THAT(why(folder_ / "../a.toml"), outside);
  EXPECT_THAT(why(folder_ / "folder/a.toml"), outside);
  EXPECT_THAT(why(folder_ / "file"), outside);
  EXPECT_THAT(why(folder_.path().string() + "-beside/a.toml"), outside);
  EXPECT_THAT(why("/"), outside);
}

TEST_F(AllowedFilesTest, AreReadInTheProgramsOwnFoldersToo) {
  for (const fs::path& folder : AllowedFiles::of_the_program()) {
    EXPECT_EQ(allowed_.why_not_read(folder / "plugins/a.so"), "");
    EXPECT_NE(allowed_.why_not_written(folder / "plugins/a.so"), "");
  }
}

TEST(AllowedFiles, AreAllWhereNoneAreNamed) {
  EXPECT_EQ(AllowedFiles({}).why_not_written("/etc/passwd"), "");
  EXPECT_NO_THROW(check_may_write("/etc/passwd"));
}

}  // namespace
}  // namespace lacuna
