#include "report/text/bound_text.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

FittedValue value_of(const std::string& address, const std::string& unit, double value, bool lower, bool upper) {
  FittedValue fitted;
  fitted.address = address;
  fitted.unit = unit;
  fitted.value = value;
  fitted.at_lower_bound = lower;
  fitted.at_upper_bound = upper;
  return fitted;
}

TEST(BoundText, SaysWhichBoundAndWhatItMeans) {
  FitResult fit;
  fit.values = {value_of("body.arm.mass", "kg", 0.53, false, false),
                value_of("effect.coulomb_friction.torque", "N*m", 0.0, true, false),
                value_of("joint.hinge.damping", "N*m*s/rad", 0.0, true, false),
                value_of("body.carriage.mass", "kg", 500.0, false, true),
                value_of("effect.pull.force", "N", -20.0, true, false)};
  EXPECT_EQ(bound_text(fit),
            "effect.coulomb_friction.torque: the fit stopped at the lower bound, 0.00 N·m: this effect does not "
            "improve the model\n"
            "joint.hinge.damping: the fit stopped at the lower bound, 0.00 N·m·s/rad: another value does not improve "
            "the model\n"
            "body.carriage.mass: the fit stopped at the upper bound, 500 kg: a larger value would fit better: the "
            "bound is too tight, or the value has absorbed a missing effect\n"
            "effect.pull.force: the fit stopped at the lower bound, -20.0 N: a smaller value than the effect allows "
            "would fit better; the missing effect may be another one\n");
}

TEST(BoundText, DoesNotDismissAnEffectThatShorterSegmentsShow) {
  FitResult fit;
  fit.values = {value_of("effect.coulomb_friction.torque", "N", 0.0, true, false)};
  fit.stages.resize(2);
  fit.stages[0].values = {19.9};
  fit.stages[1].values = {0.0};
  EXPECT_EQ(bound_text(fit),
            "effect.coulomb_friction.torque: the fit stopped at the lower bound, 0.00 N: whole trials give this value, "
            "but shorter segments do not, so something else is missing too\n");
}

TEST(BoundText, IsEmptyWhereNoValueIsAtABound) {
  FitResult fit;
  fit.values = {value_of("body.arm.mass", "kg", 0.53, false, false)};
  EXPECT_EQ(bound_text(fit), "");
}

}  // namespace
}  // namespace lacuna
