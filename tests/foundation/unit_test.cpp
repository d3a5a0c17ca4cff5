#include "foundation/unit.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace lacuna {
namespace {

TEST(ParseUnit, ReadsProductsPowersAndPrefixes) {
  EXPECT_DOUBLE_EQ(parse_unit("mm")->to_si, 1e-3);
  EXPECT_DOUBLE_EQ(parse_unit("deg/s")->to_si, std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(parse_unit("g*cm^2")->to_si, 1e-7);
  EXPECT_TRUE(parse_unit("N*m*s/rad")->same_dimension(*parse_unit("kg*m^2/s")));
  EXPECT_TRUE(parse_unit("N/V")->same_dimension(*parse_unit("A*s/m")));
}

/// NIST SP 811, appendix B.
TEST(ParseUnit, ReadsInchesAndPounds) {
  EXPECT_DOUBLE_EQ(parse_unit("in/s")->to_si, 0.0254);
  EXPECT_DOUBLE_EQ(parse_unit("ft")->to_si, 0.3048);
  EXPECT_DOUBLE_EQ(parse_unit("oz")->to_si, 0.028349523125);
  EXPECT_DOUBLE_EQ(parse_unit("kip")->to_si, 4448.2216152605);
  EXPECT_NEAR(parse_unit("lbf*in")->to_si, 0.1129848290276, 1e-13);
  EXPECT_NEAR(parse_unit("ozf*in")->to_si, 0.007061551814, 1e-12);
  EXPECT_NEAR(parse_unit("psi")->to_si, 6894.757293168, 1e-9);
  EXPECT_TRUE(parse_unit("lbf")->same_dimension(*parse_unit("N")));
  EXPECT_TRUE(parse_unit("lb*in^2")->same_dimension(*parse_unit("kg*m^2")));
  EXPECT_EQ(parse_unit("min")->to_si, 60.0);
}

TEST(ParseUnit, RefusesWhatIsNoUnit) {
  for (const char* text : {"", "furlong", "N*", "N//m", "m^", "m^x", "(m", "m)", "Nm "})
    EXPECT_FALSE(parse_unit(text)) << text;
}

TEST(FormatQuantity, ChoosesAPrefixThatSuitsTheSize) {
  EXPECT_EQ(format_quantity(0.0091, "rad"), "9.10 mrad");
  EXPECT_EQ(format_quantity(95.1, "kg"), "95.1 kg");
  EXPECT_EQ(format_quantity(0.131, "N*m"), "0.131 N*m");
  EXPECT_EQ(format_quantity(std::numeric_limits<double>::infinity(), "N/m"), "inf N/m");
}

/// A share of 1 that somebody gives in degrees is a mistake.
TEST(ParseUnit, AnAngleIsNoShare) {
  EXPECT_TRUE(parse_unit("deg")->same_dimension(*parse_unit("mrad")));
  EXPECT_TRUE(parse_unit("%")->same_dimension(*parse_unit("1")));
  EXPECT_FALSE(parse_unit("deg")->same_dimension(*parse_unit("1")));
  EXPECT_TRUE(parse_unit("rad/s")->same_dimension(*parse_unit("Hz")));
  EXPECT_TRUE(parse_unit("N*m*s/rad")->same_dimension(*parse_unit("N*m*s")));
}

}  // namespace
}  // namespace lacuna
