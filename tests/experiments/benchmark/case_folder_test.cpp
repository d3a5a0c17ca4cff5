#include "runs/case_folder.h"

#include "runs/case_failure.h"

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

namespace hidden_effects {
namespace {

TEST(CaseFolder, LeavesAloneWhatNoInterruptedRunLeft) {
  const lacuna::TestFolder work;
  const std::filesystem::path path = work / "fixed-0002";
  {
    const CaseFolder whole(path, true);
    work.write("fixed-0002/rig.toml", "kept");
  }
  EXPECT_THROW(CaseFolder(path, false), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::exists(path / "rig.toml"));
}

TEST(CaseFolder, IsEmptiedWhereAnInterruptedRunLeftIt) {
  const lacuna::TestFolder work;
  const std::filesystem::path path = work / "fixed-0002";
  try {
    const CaseFolder half(path, true);
    work.write("fixed-0002/rig.toml", "half");
    throw CaseStopped();
  } catch (const CaseStopped&) {
  }
  ASSERT_TRUE(std::filesystem::exists(path / "rig.toml"));
  {
    const CaseFolder again(path, false);
    EXPECT_FALSE(std::filesystem::exists(path / "rig.toml"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace hidden_effects
