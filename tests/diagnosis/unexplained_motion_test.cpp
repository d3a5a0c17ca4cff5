#include "diagnosis/verdict/unexplained_motion.h"

#include "diagnosis/recorded_pendulum.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

double deviation(const Trial& trial) {
  const Eigen::ArrayXd values = trial.measured.samples.col(0).array();
  return std::sqrt((values - values.mean()).square().mean());
}

/// `share` of the motion is missed.
std::vector<std::string> sentences(const PendulumTruth& truth, double share) {
  BaseSolution base;
  base.trials = {recorded(truth, "multi.csv", multisine, 6.0, 1)};
  const double missed = share * deviation(base.trials.front());
  return unexplained_motion(base, {{"angle", "rad", missed, missed, missed}});
}

TEST(UnexplainedMotion, IsThatOfAModelThatMissesAFifthOfWhatIsSmooth) {
  EXPECT_THAT(sentences({}, 0.3), ElementsAre(HasSubstr("angle: the model misses")));
  EXPECT_THAT(sentences({}, 0.1), IsEmpty());
}

/// A file in another unit than the others is no noise either.
TEST(UnexplainedMotion, IsAlsoWhatPassesForNoise) {
  BaseSolution base;
  base.trials = {recorded({}, "multi.csv", multisine, 6.0, 1)};
  const double motion = deviation(base.trials.front());
  EXPECT_THAT(unexplained_motion(base, {{"angle", "rad", 0.3 * motion, 0.05 * motion, 0.05 * motion}}),
              ElementsAre(HasSubstr("angle: the model misses")));
  EXPECT_THAT(unexplained_motion(base, {{"angle", "rad", 0.1 * motion, 0.05 * motion, 0.05 * motion}}), IsEmpty());
}

/// What scatters from sample to sample is the sensor's noise, however large.
TEST(UnexplainedMotion, IsNotTheNoiseOfAPoorSensor) {
  const PendulumTruth poor{.noise = 1.0};
  EXPECT_THAT(sentences(poor, 0.9), IsEmpty());
}

}  // namespace
}  // namespace lacuna
