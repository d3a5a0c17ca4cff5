#include "config/experiment_reader.h"
#include "config/robots/robot_reader.h"
#include "config/toml/text_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

const fs::path kBad = LACUNA_SOURCE_DIRECTORY "/tests/config/bad";

/// Every TOML file of a folder, in order.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::string without_folder(std::string text) {
  const std::string folder = LACUNA_SOURCE_DIRECTORY "/tests/config/";
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size());
  return text + "\n";
}

template <class Read>
std::string complaint(Read read, const fs::path& file) {
  try {
    read(file);
  } catch (const BadInput& bad) {
    return without_folder(bad.what());
  }
  return "no complaint\n";
}

/// The messages stand beside the file. LACUNA_WRITE_EXPECTED=1 writes them anew, to be read before they are committed.
void compare_with_expected(const fs::path& file, const std::string& messages) {
  const fs::path expected = fs::path(file).replace_extension(".expected");
  if (std::getenv("LACUNA_WRITE_EXPECTED")) std::ofstream(expected, std::ios::binary) << messages;
  EXPECT_EQ(messages, read_text_file(expected));
}

class BadExperiment : public testing::TestWithParam<std::string> {};
class BadRobot : public testing::TestWithParam<std::string> {};

TEST_P(BadExperiment, IsRefusedWithEveryProblemAtItsPlace) {
  compare_with_expected(kBad / GetParam(),
                        complaint([](const fs::path& file) { read_experiment(file); }, kBad / GetParam()));
}

TEST_P(BadRobot, IsRefusedWithEveryProblemAtItsPlace) {
  const fs::path file = kBad / "robots" / GetParam();
  compare_with_expected(file, complaint([](const fs::path& robot) { read_robot(robot); }, file));
}

std::string test_name(const testing::TestParamInfo<std::string>& info) { return fs::path(info.param).stem().string(); }

INSTANTIATE_TEST_SUITE_P(Config, BadExperiment, testing::ValuesIn(files_in(kBad)), test_name);
INSTANTIATE_TEST_SUITE_P(Config, BadRobot, testing::ValuesIn(files_in(kBad / "robots")), test_name);

}  // namespace
}  // namespace lacuna
