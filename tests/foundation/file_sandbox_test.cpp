#include "foundation/files/file_sandbox.h"

#include "foundation/files/allowed_files.h"
#include "foundation/files/whole_file.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace lacuna {
namespace {

bool is_read(const std::filesystem::path& file) { return std::ifstream(file).get() != EOF; }

/// 0, or the number of what went wrong. The checks of names are not asked: what opens a file here is no code of ours.
int what_goes_wrong_in_the_sandbox(const std::filesystem::path& inside, const std::filesystem::path& outside) {
  enter_file_sandbox();
  if (!is_read(inside / "file") || !is_read("/proc/self/status")) return 1;
  if (is_read(outside / "file") || is_read("/etc/passwd")) return 2;
  if (std::ofstream(outside / "new").good() || !std::ofstream(inside / "new").good()) return 3;
  write_whole(inside / "file", "other", Link::followed);  // by way of a file without a name
  if (read_bytes(inside / "file") != "other") return 4;
  if (std::system("test \"$(echo started)\" = started") != 0) return 5;
  return std::system(("cat " + (outside / "file").string() + " 2>/dev/null").c_str()) == 0 ? 6 : 0;
}

TEST(FileSandboxDeathTest, HoldsAProcessAndWhatItStartsToTheFolder) {
  if (!has_file_sandbox()) GTEST_SKIP() << "this kernel has no Landlock";
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // the child is a new process, which no earlier test has touched
  const TestFolder inside, outside;
  inside.write("file", "text");
  outside.write("file", "text");
  setenv(kAllowedFolders, std::filesystem::canonical(inside.path()).c_str(), 1);
  EXPECT_EXIT(_exit(what_goes_wrong_in_the_sandbox(inside.path(), outside.path())), testing::ExitedWithCode(0), "");
  unsetenv(kAllowedFolders);
}

}  // namespace
}  // namespace lacuna
