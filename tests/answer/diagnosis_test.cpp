#include "answer/diagnosis.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(DiagnosisMethods, AreReadAsTheyAreWritten) {
  for (const DiagnosisMethod method :
       {DiagnosisMethod::prediction, DiagnosisMethod::horizon, DiagnosisMethod::likelihood})
    EXPECT_EQ(read_method(to_string(method)), method);
  EXPECT_EQ(read_method("prediction"), DiagnosisMethod::prediction);
  EXPECT_FALSE(read_method("guess"));
}

TEST(Verdicts, AreNamedAsTheDatabaseHasThem) {
  EXPECT_EQ(to_string(Verdict::nothing_missing), "nothing_missing");
  EXPECT_EQ(to_string(Verdict::effect_found), "effect_found");
  EXPECT_EQ(to_string(Verdict::not_in_library), "not_in_library");
  EXPECT_EQ(to_string(Verdict::cannot_tell), "cannot_tell");
}

TEST(Gained, IsNothingWhereTheGainIsNegativeOrUnknown) {
  EXPECT_EQ(gained(Gain{2.5, 0.1, 2.3, 2.7}), 2.5);
  EXPECT_EQ(gained(Gain{-2.5, 0.1, -2.7, -2.3}), 0.0);
  EXPECT_EQ(gained(std::nullopt), 0.0);
}

}  // namespace
}  // namespace lacuna
