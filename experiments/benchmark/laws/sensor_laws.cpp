#include "laws/joint_law.h"
#include "laws/law_kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// What a sensor makes of what it reads.
namespace hidden_effects {
namespace {

class SensorLaw : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  void read(int sensor, DenseReadings& readings) const final {
    if (sensor == element_) change(readings.values, readings.interval);
  }

 protected:
  virtual void change(Values& x, double interval) const = 0;
};

/// x at a place between two samples, by the parabola through three of them; the ends go on.
double at_place(const Values& x, double place) {
  const double last = static_cast<double>(x.size() - 1);
  const double inside = std::clamp(place, 0.0, last);
  const auto k = static_cast<std::size_t>(std::clamp(std::round(inside), 1.0, last - 1.0));
  const double t = inside - static_cast<double>(k);
  return x[k] + 0.5 * t * (x[k + 1] - x[k - 1]) + 0.5 * t * t * (x[k + 1] - 2.0 * x[k] + x[k - 1]);
}

class SensorDelay : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double interval) const override {
    const Values before = x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = at_place(before, static_cast<double>(k) - p_[0] / interval);
  }
};

/// Exact for readings that change evenly between two of the dense ones.
class SensorLag : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double interval) const override {
    const double decay = std::exp(-interval / p_[0]);
    double y = x.front(), before = x.front();
    for (double& value : x) {
      const double slope = (value - before) / interval;
      y = value - slope * p_[0] + (y - before + slope * p_[0]) * decay;
      before = value;
      value = y;
    }
  }
};

/// A Butterworth filter of second order with the same delay of slow signals as a lag of `time`.
class ButterworthLag : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double interval) const override {
    const double rate = std::numbers::sqrt2 / p_[0];  // √2/ω is the delay of slow signals
    const double w = std::tan(0.5 * rate * interval), d = 1.0 + std::numbers::sqrt2 * w + w * w;
    const double b = w * w / d, a1 = 2.0 * (w * w - 1.0) / d, a2 = (1.0 - std::numbers::sqrt2 * w + w * w) / d;
    double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
    for (double& value : x) {
      const double y = b * (value + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
      x2 = x1, x1 = value, y2 = y1, y1 = y;
      value = y;
    }
  }
};

class SensorOffset : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double) const override {
    for (double& value : x) value += p_[0];
  }
};

class Scale : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double) const override {
    for (double& value : x) value *= p_[0];
  }
};

class SensorSaturation : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double) const override {
    for (double& value : x) value = std::clamp(value, p_[0], p_[1]);
  }
};

class Eccentricity : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double) const override {
    for (double& value : x) value += p_[0] * std::sin(p_[2] * value) + p_[1] * std::cos(p_[2] * value);
  }
};

class Drift : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double interval) const override {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += p_[0] * static_cast<double>(k) * interval;
  }
};

/// A gauge that warms up: the drift ends after about three seconds.
class WarmingDrift : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double interval) const override {
    constexpr double kTime = 3.0;
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] += p_[0] * kTime * (1.0 - std::exp(-static_cast<double>(k) * interval / kTime));
  }
};

class ClockSkew : public SensorLaw {
 public:
  using SensorLaw::SensorLaw;

 protected:
  void change(Values& x, double) const override {
    const Values before = x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = at_place(before, static_cast<double>(k) / (1.0 + p_[0]));
  }
};

}  // namespace

std::vector<LawKind> sensor_laws() {
  constexpr double kFar = 1e5;
  return {
      {"sensor_delay",
       "sensor_delay",
       Place::sensor,
       true,
       {"delay"},
       make<SensorDelay>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 0.5)}; },
       everywhere},
      {"sensor_lag",
       "sensor_lag",
       Place::sensor,
       true,
       {"time"},
       make<SensorLag>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 2.0)}; },
       everywhere},
      {"butterworth_lag",
       "sensor_lag",
       Place::sensor,
       false,
       {"time"},
       make<ButterworthLag>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 2.0)}; },
       everywhere},
      {"sensor_offset",
       "sensor_offset",
       Place::sensor,
       true,
       {"offset"},
       make<SensorOffset>,
       [](double size, const Scales& at, const Shape& u) { return Values{with_sign(0.05 * size * at.position, u[0])}; },
       everywhere},
      {"sensor_scale",
       "sensor_scale",
       Place::sensor,
       true,
       {"scale"},
       make<Scale>,
       [](double size, const Scales&, const Shape& u) {
         return Values{u[0] < 0.5 ? 1.0 / (1.0 + 0.05 * size) : 1.0 + 0.05 * size};
       },
       everywhere},
      {"sensor_saturation",
       "sensor_saturation",
       Place::sensor,
       true,
       {"lower", "upper"},
       make<SensorSaturation>,
       [](double size, const Scales& at, const Shape& u) {
         const double reach = (at.highest - at.lowest) * std::min(0.45, 0.05 * size);
         return u[0] < 0.5 ? Values{at.lowest + reach, kFar} : Values{-kFar, at.highest - reach};
       },
       everywhere},
      {"encoder_eccentricity",
       "encoder_eccentricity",
       Place::sensor,
       true,
       {"sine", "cosine", "periods"},
       make<Eccentricity>,
       [](double size, const Scales& at, const Shape& u) {
         const double wave = 0.02 * size * at.position, phase = 2.0 * std::numbers::pi * u[0];
         return Values{wave * std::sin(phase), wave * std::cos(phase), between(2.0, 8.0, u[1]) / at.position};
       },
       everywhere},
      {"sensor_drift",
       "sensor_drift",
       Place::sensor,
       true,
       {"rate"},
       make<Drift>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{with_sign(0.05 * size * at.position / at.duration, u[0])};
       },
       everywhere},
      {"warming_drift",
       "sensor_drift",
       Place::sensor,
       false,
       {"rate"},
       make<WarmingDrift>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{with_sign(0.1 * size * at.position / at.duration, u[0])};
       },
       everywhere},
      {"clock_skew",
       "clock_skew",
       Place::sensor,
       true,
       {"skew"},
       make<ClockSkew>,
       [](double size, const Scales&, const Shape& u) { return Values{with_sign(std::min(0.02, 1e-3 * size), u[0])}; },
       everywhere},
  };
}

}  // namespace hidden_effects
