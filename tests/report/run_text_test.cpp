#include "report/text/run_text.h"

#include <gmock/gmock.h>

#include <sstream>

namespace lacuna {
namespace {

/// The words of each line of a table, whose columns are two blanks apart or more.
std::vector<std::vector<std::string>> cells_of(const std::string& table) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream text(table);
  for (std::string line; std::getline(text, line);) {
    std::vector<std::string>& cells = lines.emplace_back();
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end = std::min(line.find("  ", at), line.size());
      if (end > at) cells.push_back(line.substr(at, end - at));
      at = end == at ? at + 1 : end;
    }
    for (std::string& cell : cells) cell.erase(0, cell.find_first_not_of(' '));
  }
  return lines;
}

/// Models that do without effects have no figures of these.
TEST(RunText, FiguresStandUnderTheirNamesWhicheverPassesHaveThem) {
  const std::vector<PassRow> passes = {
      {.number = 1, .best_score = 0.5, .objective = {{"body.*.mass", "kg", 1.0}, {"effects", "1", 2.0}}},
      {.number = 2,
       .best_score = 0.25,
       .objective = {{"body.*.mass", "kg", 3.0}, {"effect.*.torque", "N*m", 4.0}, {"effects", "1", 0.0}}},
      {.number = 3, .best_score = 0.125, .objective = {{"effect.*.torque", "N*m", 5.0}}}};
  const auto lines = cells_of(passes_text(passes, {}));
  ASSERT_EQ(lines.size(), 4U);
  const auto first_five = [&](std::size_t line) { return std::vector(lines[line].begin(), lines[line].begin() + 5); };
  EXPECT_THAT(first_five(0),
              testing::ElementsAre("pass", "error", "body.*.mass off by", "effects off by", "effect.*.torque off by"));
  EXPECT_THAT(first_five(1), testing::ElementsAre("1", "0.5", "1.00 kg", "2", "-"));
  EXPECT_THAT(first_five(2), testing::ElementsAre("2", "0.25", "3.00 kg", "0", "4.00 N·m"));
  EXPECT_THAT(first_five(3), testing::ElementsAre("3", "0.125", "-", "-", "5.00 N·m"));
}

/// The value that was predicted of a test is not that of the one which took its place.
TEST(RunText, SaysWhereAnotherTestTookAPlace) {
  const std::vector<PassRow> passes = {{.number = 1, .best_test = 41, .best_fitness = 3.0},
                                       {.number = 2, .best_test = 90, .best_fitness = 4.0}};
  const std::vector<TargetTrialRow> trials = {{.number = 0, .test = 0}, {.number = 1, .test = 61}};
  const auto lines = cells_of(passes_text(passes, trials));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1][3], "replaced");
  EXPECT_EQ(lines[2][3], "-") << "not carried out yet";
}

}  // namespace
}  // namespace lacuna
