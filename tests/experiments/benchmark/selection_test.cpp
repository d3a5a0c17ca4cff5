#include "runs/selection.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace hidden_effects {
namespace {

std::vector<int> numbers(const std::string& cases, const std::string& part) {
  std::vector<CasePlan> plans(10);
  for (int number = 0; number < 10; ++number) plans[static_cast<std::size_t>(number)].number = number;
  std::vector<int> chosen;
  for (const CasePlan& plan : selected(plans, cases, part)) chosen.push_back(plan.number);
  return chosen;
}

TEST(Selection, TakesARange) {
  EXPECT_EQ(numbers("3-5", ""), (std::vector{3, 4, 5}));
  EXPECT_EQ(numbers("7", ""), std::vector{7});
}

TEST(Selection, PartsAreTheWhole) {
  EXPECT_EQ(numbers("", "1/3"), (std::vector{0, 3, 6, 9}));
  EXPECT_EQ(numbers("", "2/3"), (std::vector{1, 4, 7}));
  EXPECT_EQ(numbers("", "3/3"), (std::vector{2, 5, 8}));
}

TEST(Selection, RefusesWhatItCannotRead) {
  for (const char* part : {"0/3", "4/3", "2", "a/b"}) EXPECT_THROW(numbers("", part), std::invalid_argument) << part;
  for (const char* cases : {"3-x", "5-2", "0-10", "10", "-1"})
    EXPECT_THROW(numbers(cases, ""), std::invalid_argument) << cases;
}

}  // namespace
}  // namespace hidden_effects
