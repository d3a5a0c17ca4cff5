#include "fitting/error_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr Eigen::Index kSamples = 1000;  // ten whole periods

Eigen::VectorXd sine(double size, double phase, double offset = 0.0) {
  return Eigen::VectorXd::NullaryExpr(kSamples, [=](Eigen::Index i) {
    return offset + size * std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 100.0 + phase);
  });
}

constexpr double kTolerance = 1e-9;

TEST(ErrorParts, AnOffsetIsBias) {
  const ErrorParts parts = error_parts(sine(1.0, 0.0, 0.3), sine(1.0, 0.0));
  EXPECT_NEAR(parts.bias_share, 1.0, kTolerance);
  EXPECT_NEAR(parts.magnitude_share, 0.0, kTolerance);
  EXPECT_NEAR(parts.theil_u, 0.3 / (std::sqrt(0.5 + 0.09) + std::sqrt(0.5)), kTolerance);
}

TEST(ErrorParts, ASwingTooWideIsMagnitude) {
  const ErrorParts parts = error_parts(sine(1.0, 0.0), sine(1.2, 0.0));
  EXPECT_NEAR(parts.magnitude_share, 1.0, kTolerance);
  EXPECT_NEAR(parts.sprague_geers_magnitude, 0.2, kTolerance);
  EXPECT_NEAR(error_parts(sine(1.0, 0.0, 5.0), sine(1.2, 0.0, 5.0)).spread_error, 0.2, kTolerance);
  EXPECT_NEAR(parts.sprague_geers_phase, 0.0, 1e-6);  // the arc cosine is steep at 1
}

TEST(ErrorParts, ALagIsForm) {
  const ErrorParts parts = error_parts(sine(1.0, 0.0), sine(1.0, -0.4));
  EXPECT_NEAR(parts.form_share, 1.0, kTolerance);
  EXPECT_NEAR(parts.sprague_geers_magnitude, 0.0, kTolerance);
  EXPECT_NEAR(parts.sprague_geers_phase, 0.4 / std::numbers::pi, kTolerance);
}

TEST(ErrorParts, GapsDoNotCountAndNothingHasNoParts) {
  Eigen::VectorXd measured = sine(1.0, 0.0, 0.3);
  measured(17) = std::nan("");
  EXPECT_NEAR(error_parts(measured, sine(1.0, 0.0)).bias_share, 1.0, kTolerance);
  EXPECT_TRUE(std::isnan(error_parts(Eigen::VectorXd(), Eigen::VectorXd()).theil_u));
  EXPECT_TRUE(std::isnan(error_parts(sine(1.0, 0.0), sine(1.0, 0.0)).bias_share));
}

}  // namespace
}  // namespace lacuna
