#include "end_to_end/program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const std::string& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(LACUNA_SOURCE_DIRECTORY "/experiments" + folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string test_name(const testing::TestParamInfo<std::string>& file) {
  std::string name = fs::path(file.param).stem();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class ExperimentFile : public testing::TestWithParam<std::string> {};

TEST_P(ExperimentFile, PassesItsCheck) {
  const Program program;
  if (program.read(GetParam()).find("LACUNA_DATA") != std::string::npos && std::getenv("LACUNA_DATA") == nullptr) {
    GTEST_SKIP() << "LACUNA_DATA, the folder of recordings that are not part of this project, is not set";
  }
  if (program.read(GetParam()).find("mujoco_cart_pole") != std::string::npos &&
      !fs::exists(LACUNA_BINARY_DIRECTORY "/bin/mujoco_cart_pole")) {
    GTEST_SKIP() << "MuJoCo, which this target is computed with, is not installed";
  }
  const Outcome check = program.shell("lacuna check '" + GetParam() + "'");  // its target is a program beside lacuna
  EXPECT_EQ(check.exit_code, 0) << check.errors;
}

INSTANTIATE_TEST_SUITE_P(Experiments, ExperimentFile, testing::ValuesIn(files_of("")), test_name);

/// Rigs that others recorded.
class MeasuredRig : public testing::TestWithParam<std::string> {};

/// Their files were written as they are, whatever some jumps look like.
TEST_P(MeasuredRig, PassesItsCheckWithoutAFalseNoteOnItsNumbers) {
  if (std::getenv("LACUNA_DATA") == nullptr)
    GTEST_SKIP() << "LACUNA_DATA, the folder of recordings that are not part of this project, is not set";
  const Program program;
  const Outcome check = program.shell("lacuna check '" + GetParam() + "'");
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  for (const char* words :
       {"encoding = ", "a glitch", "repeats it", "is a copy", "its sign is lost", "no device measures"})
    EXPECT_EQ(check.output.find(words), std::string::npos) << check.output;
}

INSTANTIATE_TEST_SUITE_P(Experiments, MeasuredRig, testing::ValuesIn(files_of("/real")), test_name);

}  // namespace
}  // namespace lacuna
