#include "measurement/clocks/clock_alignment.h"

#include "measurement_fixture.h"

#include <cmath>
#include <random>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// A swing of a pendulum under a torque of three sines, by a logger of the torque and a camera of the angle.
struct Rig {
  double length = 20.0;        // s
  double camera_late = 0.317;  // s: what the camera's clock shows less
  double skew = 0.0;           // of the camera's clock
  double noise = 1e-3;         // rad
  double phase = 0.0;
  unsigned seed = 1;
  bool periodic = false;

  double torque(double t) const {
    if (periodic) return 0.5 * std::sin(2.0 * M_PI * t);
    return 0.4 * std::sin(1.7 * t + phase) + 0.3 * std::sin(3.1 * t * (1.0 + 0.02 * t) + 1.0) + 0.2 * std::sin(7.3 * t);
  }
};

struct Watched {
  std::vector<ClockedSignal> logger, camera;
};

Watched watch(const Rig& rig) {
  Watched watched{{{"motor", "N*m", false, true, {}, {}}}, {{"angle", "rad", true, false, {}, {}}}};
  std::mt19937 random(rig.seed);
  std::normal_distribution<double> noise(0.0, rig.noise);
  const double h = 2e-3;
  double q = 0.1, v = 0.0, next_frame = 0.0123;
  for (int i = 0; i * h < rig.length; ++i) {
    const double t = i * h, torque = rig.torque(t);
    watched.logger[0].times.push_back(t);
    watched.logger[0].values.push_back(torque);
    const auto acceleration = [&](double at, double speed) {
      return (torque - 1.2 * std::sin(at) - 0.02 * speed - 0.05 * std::tanh(speed / 0.01)) / 0.04;
    };
    const double middle_v = v + 0.5 * h * acceleration(q, v), middle_q = q + 0.5 * h * v;
    const double q1 = q + h * middle_v, v1 = v + h * acceleration(middle_q, middle_v);
    while (next_frame < t + h) {
      const double share = (next_frame - t) / h;
      watched.camera[0].times.push_back((next_frame - rig.camera_late) / (1.0 + rig.skew));
      watched.camera[0].values.push_back(q + share * (q1 - q) + noise(random));
      next_frame += 1.0 / 60.0;
    }
    q = q1;
    v = v1;
  }
  return watched;
}

constexpr std::pair kAnywhere{-1e9, 1e9};

TEST(ClockAlignment, FindsAnOffsetWithinItsError) {
  int within = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Watched watched = watch({.phase = 0.3 * seed, .seed = seed});
    const auto answer = align_clocks(watched.logger, watched.camera, {kAnywhere});
    const auto* found = std::get_if<ClockAlignment>(&answer);
    ASSERT_NE(found, nullptr) << std::get<std::string>(answer);
    EXPECT_NEAR(found->offset, 0.317, 3e-3) << seed;
    EXPECT_LT(found->offset_error, 2e-3) << seed;
    EXPECT_EQ(found->by, "motor");
    within += std::abs(found->offset - 0.317) < 2.5 * found->offset_error ? 1 : 0;
  }
  EXPECT_GE(within, 18);
}

/// A cart under a force of six sines, by a logger of the force and a camera of the position.
struct Cart {
  double noise = 1e-4;  // m
  double rate = 300.0;  // 1/s, of the camera
  double offset = -3.204;
  double length = 12.0;
  double friction = 0.0;  // N
};

Watched watch_cart(const Cart& cart, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, cart.noise);
  constexpr int kSines = 6, kParts = 4;
  constexpr double kHold = 2e-3, kMass = 2.0, kDamping = 4.0;
  std::vector<double> sizes, rates, phases;
  for (int k = 0; k < kSines; ++k) {
    sizes.push_back(3.0 * (0.5 + share(random)));
    rates.push_back(2.0 * M_PI * (0.2 + 2.3 * share(random)));
    phases.push_back(2.0 * M_PI * share(random));
  }
  Watched watched{{{"motor", "N", false, true, {}, {}}}, {{"pos", "m", true, false, {}, {}}}};
  double x = 0.0, v = 0.0, next_frame = 0.01 * share(random);
  for (int i = 0; i * kHold < cart.length; ++i) {
    double force = 0.0;
    for (std::size_t k = 0; k < kSines; ++k) force += sizes[k] * std::sin(rates[k] * i * kHold + phases[k]);
    watched.logger[0].times.push_back(i * kHold);
    watched.logger[0].values.push_back(force);
    for (int part = 0; part < kParts; ++part) {
      const double h = kHold / kParts, t = i * kHold + part * h;
      const auto acceleration = [&](double speed) {
        return (force - kDamping * speed - cart.friction * std::tanh(speed / 0.01)) / kMass;
      };
      const double middle = v + 0.5 * h * acceleration(v), after = v + h * acceleration(middle);
      for (; next_frame < t + h; next_frame += 1.0 / cart.rate) {
        const double s = next_frame - t;
        watched.camera[0].times.push_back(next_frame - cart.offset);
        watched.camera[0].values.push_back(x + s * v + 0.5 * s * s / h * (after - v) + noise(random));
      }
      x += h * middle;
      v = after;
    }
  }
  return watched;
}

/// Noise of readings used to make accelerations small, which a later command made up for: ten standard errors off.
TEST(ClockAlignment, NoiseOfReadingsShiftsNothing) {
  constexpr unsigned kSeeds = 20;
  constexpr double kWithin = 3.0;  // standard errors
  int within = 0, all = 0;
  for (const Cart& cart : {Cart{}, Cart{.noise = 5e-4}, Cart{.noise = 3e-4, .rate = 60.0},
                           Cart{.noise = 2e-4, .rate = 120.0, .offset = 1234.5, .friction = 1.0}}) {
    double sum = 0.0, squares = 0.0, claimed = 0.0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      const Watched watched = watch_cart(cart, seed);
      const auto answer = align_clocks(watched.logger, watched.camera, {kAnywhere});
      const auto* found = std::get_if<ClockAlignment>(&answer);
      ASSERT_NE(found, nullptr) << std::get<std::string>(answer) << " seed " << seed;
      const double error = found->offset - cart.offset;
      within += std::abs(error) < kWithin * found->offset_error ? 1 : 0;
      ++all;
      sum += error;
      squares += error * error;
      claimed += found->offset_error * found->offset_error;
    }
    const double scatter = std::sqrt(squares / kSeeds);
    EXPECT_LT(std::abs(sum / kSeeds), 3.0 * scatter / std::sqrt(kSeeds)) << "bias at noise " << cart.noise;
    EXPECT_LT(scatter, 1.6 * std::sqrt(claimed / kSeeds)) << cart.noise;
    EXPECT_LT(scatter, 1e-3) << cart.noise;
  }
  EXPECT_GE(within, static_cast<int>(0.97 * all)) << "of " << all;
}

/// Readings that are hardly more than noise are refused or have a large error, and are not far off with a small one.
TEST(ClockAlignment, NoiseAsLargeAsTheMotionIsNotBelieved) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Watched watched = watch_cart({.noise = 0.3}, seed);
    const auto answer = align_clocks(watched.logger, watched.camera, {kAnywhere});
    const auto* found = std::get_if<ClockAlignment>(&answer);
    EXPECT_TRUE(!found || std::abs(found->offset + 3.204) < 4.0 * found->offset_error) << seed;
  }
}

TEST(ClockAlignment, FindsASkew) {
  const Watched watched = watch({.length = 60.0, .skew = 4e-4});
  const auto answer = align_clocks(watched.logger, watched.camera, {kAnywhere, 0.0, true});
  const auto* found = std::get_if<ClockAlignment>(&answer);
  ASSERT_NE(found, nullptr) << std::get<std::string>(answer);
  EXPECT_NEAR(found->skew, 4e-4, 4.0 * found->skew_error);
  EXPECT_LT(found->skew_error, 1e-4);
  EXPECT_NEAR(found->offset, 0.317, 4.0 * found->offset_error + 1e-5);
}

TEST(ClockAlignment, RefusesAMotionThatRepeatsItself) {
  const Watched watched = watch({.noise = 3e-3, .periodic = true});
  const auto answer = align_clocks(watched.logger, watched.camera, {kAnywhere});
  ASSERT_TRUE(std::holds_alternative<std::string>(answer)) << std::get<ClockAlignment>(answer).offset;
  EXPECT_THAT(std::get<std::string>(answer), HasSubstr("equally well, so this motion does not"));
  const auto near = align_clocks(watched.logger, watched.camera, {{0.0, 0.7}});
  ASSERT_TRUE(std::holds_alternative<ClockAlignment>(near)) << std::get<std::string>(near);
  // One tone tells an offset from friction by its harmonics alone.
  const ClockAlignment& found = std::get<ClockAlignment>(near);
  EXPECT_NEAR(found.offset, 0.317, 3.0 * found.offset_error) << found.offset_error;
}

TEST(ClockAlignment, RefusesSignalsOfOtherMotions) {
  Watched watched = watch({});
  std::mt19937 random(5);
  std::normal_distribution<double> step(0.0, 0.05);
  double wandering = 0.0;
  for (double& value : watched.camera[0].values) value = wandering += step(random);
  const auto answer = align_clocks(watched.logger, watched.camera, {kAnywhere});
  EXPECT_TRUE(std::holds_alternative<std::string>(answer)) << std::get<ClockAlignment>(answer).offset;
}

/// The rate of a gyroscope against an encoder's position.
TEST(ClockAlignment, TellsByTwoReadingsOfOneMotion) {
  Watched watched = watch({.noise = 1e-4});
  ClockedSignal& encoder = watched.camera[0];
  ClockedSignal gyro{"rate", "rad/s", true, false, {}, {}};
  for (std::size_t i = 1; i + 1 < encoder.times.size(); ++i) {
    gyro.times.push_back(encoder.times[i] - 1.25);
    gyro.values.push_back((encoder.values[i + 1] - encoder.values[i - 1]) /
                          (encoder.times[i + 1] - encoder.times[i - 1]));
  }
  const auto answer = align_clocks(watched.camera, {gyro}, {kAnywhere});
  const auto* found = std::get_if<ClockAlignment>(&answer);
  ASSERT_NE(found, nullptr) << std::get<std::string>(answer);
  EXPECT_NEAR(found->offset, 1.25, 1e-3);
  EXPECT_EQ(found->by, "rate");
}

}  // namespace
}  // namespace lacuna
