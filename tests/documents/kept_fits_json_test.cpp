#include "documents/kept_fits_json.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(KeptFitsJson, IsReadBackDigitForDigit) {
  const KeptFits fits = {
      {"3 lengths: ", {{{"body.arm.mass", 1.0 / 3.0}}, {Eigen::Vector2d(1.0 / 3.0, -2.0), Eigen::Vector2d(0.0, 5e-9)}}},
      {"5 lengths: coulomb_friction @ joint.hinge",
       {{{"body.arm.mass", 0.1}, {"coulomb_friction @ joint.hinge.torque", 1e-300}}, {}}}};
  EXPECT_EQ(read_kept_fits(kept_fits_json(fits)), fits);
}

TEST(KeptFitsJson, OfAnotherVersionIsNone) {
  EXPECT_FALSE(read_kept_fits("{}"));
  EXPECT_FALSE(read_kept_fits("not JSON"));
  EXPECT_FALSE(read_kept_fits(R"({"format": 1, "fits": {}, "likelihoods": null})"));
  EXPECT_FALSE(read_kept_fits(R"({"format": 2, "fits": {"a": {"values": {"b": null}, "starts": []}}})"));
}

TEST(KeptFitsJson, ThatNestsTooDeepIsNone) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_FALSE(read_kept_fits(R"({"format": 2, "fits": {}, "more": )" + deep + "}"));
}

}  // namespace
}  // namespace lacuna
