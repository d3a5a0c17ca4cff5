#include "foundation/unit.h"

#include "foundation/text/unit_text.h"

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
  EXPECT_EQ(format_quantity(0.131, "N*m"), "0.131 N·m");
  EXPECT_EQ(format_quantity(0.0315, "N*m*s/rad"), "31.5 mN·m·s/rad");
  EXPECT_EQ(format_quantity(2.0, "kg*m^2"), "2.00 kg·m²");
  EXPECT_EQ(format_quantity(std::numeric_limits<double>::infinity(), "N/m"), "inf N/m");
}

TEST(FormatChange, GivesBothValuesThePrefixOfTheLarger) {
  EXPECT_EQ(format_change(7.85e-3, 3.91e-4, "N*m*s/rad"), "7.85 → 0.391 mN·m·s/rad");
  EXPECT_EQ(format_change(-0.4, 0.2, "1"), "-0.400 → 0.200");
}

TEST(UnitText, IsReadBackAsItIsTyped) {
  for (const char* unit : {"N*m*s^2/rad^2", "kg*m^2", "1/s^-2", "m/s^2*kg", "rad", "%", "1/(N*m)"})
    EXPECT_EQ(typed_unit(unit_text(unit)), unit);
  EXPECT_EQ(unit_text("N*m*s^2/rad^2"), "N·m·s²/rad²");
  EXPECT_EQ(unit_text("1/s^-12"), "1/s⁻¹²");
  EXPECT_TRUE(parse_unit("N·m·s²/rad²")->same_dimension(*parse_unit("N*m*s^2/rad^2")));
  EXPECT_EQ(unit_after_number("1"), "");
  EXPECT_EQ(unit_after_number("N*m"), " N·m");
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
