#include "answer/bound_findings.h"

#include <gmock/gmock.h>

#include <limits>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const std::vector<FreeValue> kFree = {{{"body.arm.mass", "kg", 0.3, 1.0, 0.5, Scale::linear}, ""},
                                      {{"joint.hinge.damping", "N*m*s/rad", 0.0, 0.2, 0.01, Scale::linear}, ""}};

TEST(BoundFindings, NameABoundThatCutsAnInterval) {
  EXPECT_THAT(
      bound_findings(kFree, {{"body.arm.mass", "kg", 0.98, 0.95, 1.0}}),
      ElementsAre("body.arm.mass: its upper bound in [model.free], 1.00 kg, cuts its 95 % interval short; widen "
                  "it if the value may be larger"));
  EXPECT_THAT(bound_findings(kFree, {{"body.arm.mass", "kg", 0.31, 0.3, 0.34}}),
              ElementsAre("body.arm.mass: its lower bound in [model.free], 0.300 kg, cuts its 95 % interval short; "
                          "widen it if the value may be smaller"));
}

TEST(BoundFindings, NameABoundThatHoldsAValue) {
  EXPECT_THAT(
      bound_findings(kFree, {{"body.arm.mass", "kg", 1.0, kNone, kNone, {}, true}}),
      ElementsAre("body.arm.mass is at its upper bound in [model.free], 1.00 kg: a larger value would fit better: "
                  "the bound is too tight, or the value has absorbed a missing effect"));
}

TEST(BoundFindings, AreNoneOfZeroAndOfIntervalsInside) {
  EXPECT_THAT(bound_findings(kFree, {{"joint.hinge.damping", "N*m*s/rad", 0.0, kNone, kNone, {}, true},
                                     {"body.arm.mass", "kg", 0.6, 0.5, 0.7}}),
              IsEmpty());
  EXPECT_THAT(bound_findings(kFree, {{"joint.hinge.damping", "N*m*s/rad", 0.001, 0.0, 0.002}}), IsEmpty());
  EXPECT_THAT(bound_findings(kFree, {{"body.arm.mass", "kg", 0.6, kNone, kNone}}), IsEmpty()) << "it is not told";
}

}  // namespace
}  // namespace lacuna
