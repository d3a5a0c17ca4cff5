#include "data_checks/unit_checks.h"

#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>

#include <numbers>

namespace lacuna {
namespace {

std::optional<DataWarning> unit_doubt_of(const RecordedPendulum& rig) {
  const DataCheckTask task{rig.definition, *rig.model, rig.trials, rig.values};
  const std::vector<ChannelNoise> noise = sensor_noise(rig.definition.structure.robot, rig.trials);
  return unit_doubt(task, acceleration_table(task, noise), noise);
}

/// The readings and their declared noise in another unit.
RecordedPendulum read_in(double factor) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) {
    trial.measured.samples *= factor;
    trial.sensor_noise[0] *= factor;
  }
  return rig;
}

TEST(UnitDoubt, NamesDegreesThatWereReadAsRadians) {
  const std::optional<DataWarning> doubt = unit_doubt_of(read_in(180.0 / std::numbers::pi));
  ASSERT_TRUE(doubt);
  EXPECT_EQ(doubt->severity, Severity::fault);
  EXPECT_THAT(doubt->sentence, testing::HasSubstr("angle: the readings in rad are 57.3 times too large"));
}

TEST(UnitDoubt, NamesThousandthsThatWereReadAsWholeUnits) {
  const std::optional<DataWarning> doubt = unit_doubt_of(read_in(1000.0));
  ASSERT_TRUE(doubt);
  EXPECT_THAT(doubt->sentence, testing::HasSubstr("thousandths (mrad, mm)"));
}

TEST(UnitDoubt, IsNoneOfReadingsInTheRightUnit) { EXPECT_FALSE(unit_doubt_of(read_in(1.0))); }

/// Another factor is no unit.
TEST(UnitDoubt, IsNoneOfReadingsWhoseFactorIsNoUnit) { EXPECT_FALSE(unit_doubt_of(read_in(8.0))); }

TEST(UnitDoubt, IsNoneOfAnEmptyTable) {
  const RecordedPendulum rig = read_in(1000.0);
  EXPECT_FALSE(unit_doubt({rig.definition, *rig.model, rig.trials, rig.values}, {}, {}));
}

}  // namespace
}  // namespace lacuna
