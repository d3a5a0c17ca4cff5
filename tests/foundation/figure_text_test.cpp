#include "foundation/text/figure_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lacuna {
namespace {

TEST(ProbabilityText, IsNeverMoreThanTheProbability) {
  EXPECT_EQ(probability_text(0.896), "0.89");
  EXPECT_EQ(probability_text(0.8999), "0.89");
  EXPECT_EQ(probability_text(0.949), "0.94");
  for (int percent = 1; percent < 100; ++percent) {
    const double probability = percent / 100.0;
    EXPECT_NEAR(std::stod(probability_text(probability)), probability, 1e-12) << "what has two digits keeps them";
    EXPECT_EQ(probability_text(probability + 0.0099), probability_text(probability));
  }
}

TEST(ProbabilityText, IsNeverCertain) {
  EXPECT_EQ(probability_text(0.9972), "0.99");
  EXPECT_EQ(probability_text(1.0), "0.99");
  EXPECT_EQ(probability_text(0.004), "< 0.01");
  EXPECT_EQ(probability_text(0.0), "< 0.01");
  EXPECT_EQ(probability_text(std::nan("")), "-");
}

TEST(ErrorChangeText, IsNoMultiple) {
  EXPECT_EQ(error_change_text(0.9, 12.1), "−92.6 %");
  EXPECT_EQ(error_change_text(66.0, 100.0), "−34 %");
  EXPECT_EQ(error_change_text(0.57, 100.0), "−99.43 %");
  EXPECT_EQ(error_change_text(12.0, 12.1), "−0.8 %");
  EXPECT_EQ(error_change_text(14.0, 10.0), "+40 %");
  EXPECT_EQ(error_change_text(1.0, 1.0), "0.0 %");
}

TEST(ErrorChangeText, NeverSaysThatNoErrorIsLeft) { EXPECT_EQ(error_change_text(1e-9, 1.0), "−99.99 %"); }

TEST(ErrorChangeText, SaysNothingOfWhatIsNotKnown) {
  EXPECT_EQ(error_change_text(std::nan(""), 1.0), "–");
  EXPECT_EQ(error_change_text(1.0, std::nan("")), "–");
  EXPECT_EQ(error_change_text(1.0, 0.0), "–");
}

}  // namespace
}  // namespace lacuna
