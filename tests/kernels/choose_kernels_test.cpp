#include "foundation/text/problem.h"
#include "kernels/kernels.h"
#include "kernels/levels.h"

#include <gmock/gmock.h>

namespace lacuna::test {
namespace {

using testing::HasSubstr;

std::string complaint_of(const char* wanted) {
  try {
    choose_kernels(wanted);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "none";
}

TEST(ChooseKernels, TakesTheBestWhereNothingIsWanted) {
  EXPECT_EQ(&choose_kernels(nullptr), supported_kernels().back());
  EXPECT_EQ(&choose_kernels(""), supported_kernels().back());
}

TEST(ChooseKernels, TakesThePortableOnesWhereTheyAreWanted) {
  EXPECT_EQ(&choose_kernels("portable"), lacuna_kernels_portable());
  EXPECT_EQ(supported_kernels().front(), lacuna_kernels_portable());
}

TEST(ChooseKernels, TakesEachByItsName) {
  for (const DenseKernels* one : supported_kernels()) EXPECT_EQ(&choose_kernels(one->level), one);
}

#ifdef __x86_64__
TEST(ChooseKernels, UsesVectorsOfFourWhereTheProcessorHasThem) {
  const bool has_them = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  EXPECT_STREQ(choose_kernels(nullptr).level, has_them ? "x86-64-v3" : "portable");
}
#endif

TEST(ChooseKernels, NamesWhatIsPossibleWhereTheWantedOnesAreUnknown) {
  EXPECT_THAT(complaint_of("fast"), HasSubstr("LACUNA_KERNELS: no kernels \"fast\" for this processor"));
  for (const DenseKernels* one : supported_kernels()) EXPECT_THAT(complaint_of("fast"), HasSubstr(one->level));
}

}  // namespace
}  // namespace lacuna::test
