#include "tasks/slurm_jobs.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(SlurmJobs, NameTasksAsRanges) {
  EXPECT_EQ(array_of({}), "");
  EXPECT_EQ(array_of({0}), "0");
  EXPECT_EQ(array_of({0, 1, 2, 3}), "0-3");
  EXPECT_EQ(array_of({0, 1, 4, 6, 7, 9}), "0-1,4,6-7,9");
}

TEST(SlurmJobs, TakeWordsInQuotesTogether) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(words_of("--time=5  -p long"), (Words{"--time=5", "-p", "long"}));
  EXPECT_EQ(words_of("--comment=\"two words\" '' x"), (Words{"--comment=two words", "", "x"}));
  EXPECT_EQ(words_of(""), Words{});
  EXPECT_THROW(words_of("--comment=\"two"), Error);
}

}  // namespace
}  // namespace lacuna
