#include "tasks/slurm_jobs.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(SlurmJobs, NameTasksAsRanges) {
  EXPECT_EQ(array_of({}), "");
  EXPECT_EQ(array_of({0}), "0");
  EXPECT_EQ(array_of({0, 1, 2, 3}), "0-3");
  EXPECT_EQ(array_of({0, 1, 4, 6, 7, 9}), "0-1,4,6-7,9");
}

}  // namespace
}  // namespace lacuna
