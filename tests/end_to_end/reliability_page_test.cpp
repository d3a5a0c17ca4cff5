#include "end_to_end/guide.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

namespace lacuna {
namespace {

/// "Suite.Name" of every test in the sources.
std::set<std::string> names_of_tests() {
  const std::regex declared("TEST(?:_[FP])?\\((\\w+),\\s*(\\w+)\\)");
  const std::filesystem::path root = LACUNA_SOURCE_DIRECTORY;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = source_file(entry.path().lexically_relative(root).string());
    for (std::sregex_iterator found(text.begin(), text.end(), declared), end; found != end; ++found)
      names.insert((*found)[1].str() + "." + (*found)[2].str());
  }
  return names;
}

TEST(ReliabilityPage, NamesTestsThatThereAre) {
  const std::set<std::string> tests = names_of_tests();
  const std::string page = source_file("docs/explanation/reliability.md");
  const std::regex named("`([A-Z]\\w+\\.[A-Z]\\w+)`");
  int count = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), named), end; found != end; ++found, ++count)
    EXPECT_TRUE(tests.contains((*found)[1].str())) << (*found)[1].str();
  EXPECT_GE(count, 20);
}

}  // namespace
}  // namespace lacuna
