#include "app/workspace/scale_note.h"

#include <gtest/gtest.h>

#include <numbers>

namespace lacuna {
namespace {

ColumnMapping column(const std::string& unit, double gain = 1.0, const std::string& gain_unit = "") {
  ColumnMapping mapping;
  mapping.unit = unit;
  mapping.gain = gain;
  mapping.gain_unit = gain_unit;
  return mapping;
}

TEST(CorrectedKey, IsWhatTheUserHasToType) {
  const double turn = 2.0 * std::numbers::pi, degree = 180.0 / std::numbers::pi;
  EXPECT_EQ(corrected_key(column("1", turn / 4096.0, "rad"), 0.25), "counts_per_turn = 1024");
  EXPECT_EQ(corrected_key(column("rad"), degree), "unit = \"deg\"");
  EXPECT_EQ(corrected_key(column("rad"), 1.0 / turn), "unit = \"rev\"");
  EXPECT_EQ(corrected_key(column("m"), 1.0 / 0.3048), "unit = \"ft\"");
  EXPECT_EQ(corrected_key(column("deg"), 0.25), "gain = 4");
  EXPECT_EQ(corrected_key(column("V", 0.5, "rad/V"), 2.0), "gain = \"0.25 rad/V\"");
}

}  // namespace
}  // namespace lacuna
