#include <gtest/gtest.h>

/// Stands for mujoco_test.cpp where MuJoCo is not installed.
TEST(AgainstMuJoCo, AccelerationsOfRandomTreesAreTheSame) {
  GTEST_SKIP() << "MuJoCo was not installed when the tests were built; install it (Debian: libmujoco-dev), build again";
}
