#include "app/workspace/search_range.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using Ranges = std::map<std::string, std::pair<double, double>>;

ModelDefinition with(const FreeValue& value) {
  ModelDefinition model;
  model.free = {value};
  return model;
}

Ranges ranges_of(const FreeValue& value, double start) {
  EffectEntry entry;
  entry.id = "friction";
  entry.start = {{"torque", start}};
  return search_range(entry, with(value));
}

FreeValue torque(double lower, double upper, Scale scale = Scale::linear) {
  return {{.address = "effect.friction.torque", .unit = "N*m", .lower = lower, .upper = upper, .scale = scale}};
}

TEST(SearchRange, HoldsTenTimesWhatWasFound) {
  EXPECT_EQ(ranges_of(torque(0.0, 1e4), 0.029968), (Ranges{{"torque", {0.0, 0.2997}}}));
  EXPECT_EQ(ranges_of(torque(-1e4, 1e4), -2.0), (Ranges{{"torque", {-20.0, 20.0}}}));
}

TEST(SearchRange, OfALogarithmicValueBeginsAtATenth) {
  EXPECT_EQ(ranges_of(torque(1e-6, 1e6, Scale::logarithmic), 0.5), (Ranges{{"torque", {0.05, 5.0}}}));
}

TEST(SearchRange, StaysWithinWhatIsDeclaredAndIsLeftOutWhereItIsAllOfThat) {
  EXPECT_EQ(ranges_of(torque(0.0, 8.0), 2.0), Ranges());
  EXPECT_EQ(ranges_of(torque(-1.0, 100.0), 2.0), (Ranges{{"torque", {-1.0, 20.0}}}));
}

TEST(SearchRange, SaysNothingOfWhatStartsAtNothingOrIsNotFree) {
  EXPECT_EQ(ranges_of(torque(0.0, 1e4), 0.0), Ranges());
  FreeValue other = torque(0.0, 1e4);
  other.address = "effect.friction_2.torque";
  EXPECT_EQ(ranges_of(other, 1.0), Ranges());
}

}  // namespace
}  // namespace lacuna
