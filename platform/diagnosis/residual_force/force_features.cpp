#include "diagnosis/residual_force/force_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// A speed that `share` of the moments stay below, to two digits.
double usual_speed(const JointMotion& motion, double share) {
  std::vector<double> speeds;
  for (const Eigen::VectorXd& values : motion.velocity)
    for (const double value : values) speeds.push_back(std::abs(value));
  if (speeds.empty()) return 0.0;
  const auto rank = speeds.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), rank, speeds.end());
  return std::stod(fmt::format("{:.2g}", *rank));
}

void add_powers(std::vector<ForceFeature>& all, const std::string& unit) {
  const std::string speed = unit + "/s";
  all.push_back({"1", "1", [](double, double, double) { return 1.0; }});
  all.push_back({"q", unit, [](double q, double, double) { return q; }});
  all.push_back({"q^2", unit + "^2", [](double q, double, double) { return q * q; }});
  all.push_back({"q^3", unit + "^3", [](double q, double, double) { return q * q * q; }});
  all.push_back({"q*abs(q)", unit + "^2", [](double q, double, double) { return q * std::abs(q); }});
  all.push_back({"sgn(v)", "1", [](double, double v, double) { return sign(v); }});
  all.push_back({"v", speed, [](double, double v, double) { return v; }});
  all.push_back({"abs(v)", speed, [](double, double v, double) { return std::abs(v); }});
  all.push_back({"v*abs(v)", unit + "^2/s^2", [](double, double v, double) { return v * std::abs(v); }});
  all.push_back({"v^3", unit + "^3/s^3", [](double, double v, double) { return v * v * v; }});
  all.push_back({"sgn(v)*sqrt(abs(v))", unit + "^0.5/s^0.5",
                 [](double, double v, double) { return sign(v) * std::sqrt(std::abs(v)); }});
  all.push_back({"q*v", unit + "^2/s", [](double q, double v, double) { return q * v; }});
  all.push_back({"q^2*v", unit + "^3/s", [](double q, double v, double) { return q * q * v; }});
  all.push_back({"sgn(v)*q", unit, [](double q, double v, double) { return sign(v) * q; }});
  all.push_back({"sgn(v)*abs(q)", unit, [](double q, double v, double) { return sign(v) * std::abs(q); }});
}

void add_waves(std::vector<ForceFeature>& all) {
  for (int n = 1; n <= 24; ++n) {
    const std::string angle = n == 1 ? "q" : fmt::format("{}*q", n);
    all.push_back({fmt::format("sin({})", angle), "1", [n](double q, double, double) { return std::sin(n * q); }});
    all.push_back({fmt::format("cos({})", angle), "1", [n](double q, double, double) { return std::cos(n * q); }});
    if (n > 4) continue;
    all.push_back({fmt::format("sgn(v)*sin({})", angle), "1",
                   [n](double q, double v, double) { return sign(v) * std::sin(n * q); }});
    all.push_back({fmt::format("sgn(v)*cos({})", angle), "1",
                   [n](double q, double v, double) { return sign(v) * std::cos(n * q); }});
  }
}

/// Friction that is stronger, or only there, at low speed.
void add_fading(std::vector<ForceFeature>& all, const JointMotion& motion) {
  double last = 0.0;
  for (const double share : {0.1, 0.3, 0.6}) {
    const double speed = usual_speed(motion, share);
    if (!(speed > last)) continue;
    last = speed;
    all.push_back({fmt::format("sgn(v)*exp(-(v/{:g})^2)", speed), "1",
                   [speed](double, double v, double) { return sign(v) * std::exp(-v * v / (speed * speed)); }});
    all.push_back(
        {fmt::format("tanh(v/{:g})", speed), "1", [speed](double, double v, double) { return std::tanh(v / speed); }});
  }
}

void add_commands(std::vector<ForceFeature>& all, const std::string& unit, const std::string& position) {
  all.push_back({"u", unit, [](double, double, double u) { return u; }});
  all.push_back({"abs(u)", unit, [](double, double, double u) { return std::abs(u); }});
  all.push_back({"u*abs(u)", unit + "^2", [](double, double, double u) { return u * std::abs(u); }});
  all.push_back({"u^3", unit + "^3", [](double, double, double u) { return u * u * u; }});
  all.push_back({"sgn(u)", "1", [](double, double, double u) { return sign(u); }});
  all.push_back({"sgn(v)*abs(u)", unit, [](double, double v, double u) { return sign(v) * std::abs(u); }});
  all.push_back({"u*abs(v)", unit + "*" + position + "/s", [](double, double v, double u) { return u * std::abs(v); }});
}

}  // namespace

std::vector<ForceFeature> force_features(const JointMotion& motion) {
  std::vector<ForceFeature> all;
  add_powers(all, motion.position_unit);
  if (motion.position_unit == "rad") add_waves(all);
  add_fading(all, motion);
  if (!motion.command_unit.empty()) add_commands(all, motion.command_unit, motion.position_unit);
  return all;
}

}  // namespace lacuna
