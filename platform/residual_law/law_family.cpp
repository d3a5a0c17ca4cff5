#include "residual_law/law_family.h"

#include "foundation/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace lacuna {
namespace {

constexpr int kPositions = 9, kVelocities = 11, kCommands = 7, kTimes = 7;  ///< knots
constexpr int kWaves = 12;                                                  ///< periods of a turn
constexpr int kDampingWaves = 4;
constexpr double kBesideJump = 1e-3;  ///< of the largest velocity
constexpr int kDriftDegrees = 3;      ///< of the time
constexpr int kDegrees = 4;           ///< of the position, in products with the velocity

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// Knots at quantiles, so that each function sees as much data.
std::vector<double> knots(std::vector<double> values, int count) {
  std::vector<double> chosen;
  if (values.empty()) return chosen;
  std::sort(values.begin(), values.end());
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const double knot = values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    if (chosen.empty() || knot > chosen.back()) chosen.push_back(knot);
  }
  return chosen;
}

/// The piecewise linear function that is 1 at knot `i` and 0 at its neighbours.
double hat(const std::vector<double>& at, std::size_t i, double x) {
  if (i > 0 && x < at[i]) return std::max(0.0, (x - at[i - 1]) / (at[i] - at[i - 1]));
  if (i + 1 < at.size() && x > at[i]) return std::max(0.0, (at[i + 1] - x) / (at[i + 1] - at[i]));
  return 1.0;
}

/// Friction jumps at zero velocity: one function that jumps there, and one knot on either side.
void add_jump(LawFamily& family) {
  family.functions.emplace_back([](const JointMoment& at) { return sign(at.velocity); });
  std::vector<double>& places = family.places;
  if (!(places.front() < 0.0 && places.back() > 0.0)) return;
  const double beside = kBesideJump * std::max(-places.front(), places.back());
  std::erase_if(places, [&](double place) { return std::abs(place) <= beside; });
  const auto after = std::upper_bound(places.begin(), places.end(), 0.0);
  places.insert(after, {-beside, beside});
}

void add_hats(const JointCourse& course, const std::string& quantity, const std::string& unit, double JointMoment::*of,
              int count, std::vector<LawFamily>& all) {
  const auto at = std::make_shared<const std::vector<double>>(knots(course.all(of), count));
  if (at->size() < 3) return;
  LawFamily family{quantity, {}, quantity, unit, *at, of, of == &JointMoment::velocity};
  for (std::size_t i = 0; i < at->size(); ++i)
    family.functions.emplace_back([at, i, of](const JointMoment& moment) { return hat(*at, i, moment.*of); });
  if (family.follows_velocity) add_jump(family);
  all.push_back(std::move(family));
}

LawFamily periodic() {
  LawFamily family{"position, periodically", {}};
  for (int n = 1; n <= kWaves; ++n) {
    family.functions.emplace_back([n](const JointMoment& at) { return std::sin(n * at.position); });
    family.functions.emplace_back([n](const JointMoment& at) { return std::cos(n * at.position); });
  }
  return family;
}

/// A position over the range of all, −1 to 1.
std::function<double(const JointMoment&)> scaled_position(const JointCourse& course) {
  const std::vector<double> all = course.all(&JointMoment::position);
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  const double middle = 0.5 * (*low + *high), half = std::max(0.5 * (*high - *low), 1e-12);
  return [middle, half](const JointMoment& at) { return std::clamp((at.position - middle) / half, -1.0, 1.0); };
}

/// A family over more than one quantity, without a curve.
LawFamily empty_family(const std::string& kind, bool follows_velocity) {
  LawFamily family{kind, {}};
  family.follows_velocity = follows_velocity;
  return family;
}

LawFamily velocity_by_position(const JointCourse& course) {
  LawFamily family = empty_family("velocity, by the position", true);
  const auto scaled = scaled_position(course);
  for (unsigned degree = 1; degree <= kDegrees; ++degree) {
    const auto of_position = [scaled, degree](const JointMoment& at) { return std::legendre(degree, scaled(at)); };
    family.functions.emplace_back([=](const JointMoment& at) { return of_position(at) * at.velocity; });
    family.functions.emplace_back([=](const JointMoment& at) { return of_position(at) * sign(at.velocity); });
    family.functions.emplace_back(
        [=](const JointMoment& at) { return of_position(at) * at.velocity * std::abs(at.velocity); });
  }
  return family;
}

LawFamily periodic_damping() {
  LawFamily family = empty_family("velocity, by the position periodically", true);
  for (int n = 1; n <= kDampingWaves; ++n)
    for (const bool dry : {false, true}) {
      const auto of_velocity = [dry](const JointMoment& at) { return dry ? sign(at.velocity) : at.velocity; };
      family.functions.emplace_back([=](const JointMoment& at) { return of_velocity(at) * std::sin(n * at.position); });
      family.functions.emplace_back([=](const JointMoment& at) { return of_velocity(at) * std::cos(n * at.position); });
    }
  return family;
}

LawFamily memory() {
  LawFamily family = empty_family("the past of the motion", true);
  for (std::size_t m = 0; m < kMemories; ++m) {
    family.functions.emplace_back([m](const JointMoment& at) { return at.slow_velocity[m]; });
    family.functions.emplace_back([m](const JointMoment& at) { return at.slow_direction[m]; });
    family.functions.emplace_back([m](const JointMoment& at) { return std::abs(at.slow_velocity[m]) * at.velocity; });
  }
  return family;
}

LawFamily memory_of_command() {
  LawFamily family{"the past of the command", {}};
  for (std::size_t m = 0; m < kMemories; ++m)
    family.functions.emplace_back([m](const JointMoment& at) { return at.slow_command[m] - at.command; });
  return family;
}

/// A force that fades or grows during a recording.
LawFamily drifting(LawFamily family, const JointCourse& course, double JointMoment::*of) {
  const std::vector<double> times = course.all(&JointMoment::time);
  const double last = times.empty() ? 1.0 : std::max(*std::max_element(times.begin(), times.end()), 1e-12);
  for (unsigned degree = 1; degree <= kDriftDegrees; ++degree)
    family.functions.emplace_back(
        [=](const JointMoment& at) { return at.*of * std::legendre(degree, 2.0 * at.time / last - 1.0); });
  return family;
}

LawFamily command_and_velocity() {
  LawFamily family{"command and velocity", {}};
  family.functions.emplace_back([](const JointMoment& at) { return at.command * std::abs(at.velocity); });
  family.functions.emplace_back([](const JointMoment& at) { return at.command * at.velocity * at.velocity; });
  family.functions.emplace_back([](const JointMoment& at) { return std::abs(at.command) * sign(at.velocity); });
  family.functions.emplace_back([](const JointMoment& at) { return std::abs(at.command) * at.velocity; });
  family.functions.emplace_back([](const JointMoment& at) { return at.command * at.velocity; });
  return family;
}

/// The speed that `share` of the samples stay below, to two digits.
double usual_speed(const JointCourse& course, double share) {
  std::vector<double> speeds = course.all(&JointMoment::velocity);
  if (speeds.empty()) return 0.0;
  for (double& speed : speeds) speed = std::abs(speed);
  return std::stod(fmt::format("{:.2g}", quantile_of(speeds, share)));
}

void add_powers(std::vector<ForceTerm>& all, const std::string& unit) {
  using At = const JointMoment&;
  const std::string speed = unit + "/s";
  all.push_back({"1", "1", [](At) { return 1.0; }});
  all.push_back({"q", unit, [](At at) { return at.position; }});
  all.push_back({"q^2", unit + "^2", [](At at) { return at.position * at.position; }});
  all.push_back({"q^3", unit + "^3", [](At at) { return std::pow(at.position, 3); }});
  all.push_back({"q*abs(q)", unit + "^2", [](At at) { return at.position * std::abs(at.position); }});
  all.push_back({"sgn(v)", "1", [](At at) { return sign(at.velocity); }});
  all.push_back({"v", speed, [](At at) { return at.velocity; }});
  all.push_back({"abs(v)", speed, [](At at) { return std::abs(at.velocity); }});
  all.push_back({"v*abs(v)", unit + "^2/s^2", [](At at) { return at.velocity * std::abs(at.velocity); }});
  all.push_back({"v^3", unit + "^3/s^3", [](At at) { return std::pow(at.velocity, 3); }});
  all.push_back({"sgn(v)*sqrt(abs(v))", unit + "^0.5/s^0.5",
                 [](At at) { return sign(at.velocity) * std::sqrt(std::abs(at.velocity)); }});
  all.push_back({"q*v", unit + "^2/s", [](At at) { return at.position * at.velocity; }});
  all.push_back({"q^2*v", unit + "^3/s", [](At at) { return at.position * at.position * at.velocity; }});
  all.push_back({"sgn(v)*q", unit, [](At at) { return sign(at.velocity) * at.position; }});
  all.push_back({"sgn(v)*abs(q)", unit, [](At at) { return sign(at.velocity) * std::abs(at.position); }});
}

void add_waves(std::vector<ForceTerm>& all) {
  for (int n = 1; n <= 2 * kWaves; ++n) {
    const std::string angle = n == 1 ? "q" : fmt::format("{}*q", n);
    const auto sine = [n](const JointMoment& at) { return std::sin(n * at.position); };
    const auto cosine = [n](const JointMoment& at) { return std::cos(n * at.position); };
    all.push_back({fmt::format("sin({})", angle), "1", sine});
    all.push_back({fmt::format("cos({})", angle), "1", cosine});
    if (n > kDampingWaves) continue;
    all.push_back({fmt::format("sgn(v)*sin({})", angle), "1",
                   [=](const JointMoment& at) { return sign(at.velocity) * sine(at); }});
    all.push_back({fmt::format("sgn(v)*cos({})", angle), "1",
                   [=](const JointMoment& at) { return sign(at.velocity) * cosine(at); }});
  }
}

/// Friction that is stronger at low speed, or acts only there.
void add_fading(std::vector<ForceTerm>& all, const JointCourse& course) {
  double last = 0.0;
  for (const double share : {0.1, 0.3, 0.6}) {
    const double speed = usual_speed(course, share);
    if (!(speed > last)) continue;
    last = speed;
    all.push_back({fmt::format("sgn(v)*exp(-(v/{:g})^2)", speed), "1", [speed](const JointMoment& at) {
                     return sign(at.velocity) * std::exp(-std::pow(at.velocity / speed, 2));
                   }});
    all.push_back({fmt::format("tanh(v/{:g})", speed), "1",
                   [speed](const JointMoment& at) { return std::tanh(at.velocity / speed); }});
  }
}

void add_commands(std::vector<ForceTerm>& all, const JointCourse& course) {
  using At = const JointMoment&;
  const std::string &unit = course.command_unit, speed = course.position_unit + "/s";
  all.push_back({"u", unit, [](At at) { return at.command; }});
  all.push_back({"abs(u)", unit, [](At at) { return std::abs(at.command); }});
  all.push_back({"u*abs(u)", unit + "^2", [](At at) { return at.command * std::abs(at.command); }});
  all.push_back({"u^3", unit + "^3", [](At at) { return std::pow(at.command, 3); }});
  all.push_back({"sgn(u)", "1", [](At at) { return sign(at.command); }});
  all.push_back({"sgn(v)*abs(u)", unit, [](At at) { return sign(at.velocity) * std::abs(at.command); }});
  all.push_back({"u*abs(v)", unit + "*" + speed, [](At at) { return at.command * std::abs(at.velocity); }});
}

}  // namespace

std::vector<LawFamily> law_families(const JointCourse& course) {
  std::vector<LawFamily> all;
  add_hats(course, "position", course.position_unit, &JointMoment::position, kPositions, all);
  add_hats(course, "velocity", course.position_unit + "/s", &JointMoment::velocity, kVelocities, all);
  if (!course.command_unit.empty())
    add_hats(course, "command", course.command_unit, &JointMoment::command, kCommands, all);
  add_hats(course, "time", "s", &JointMoment::time, kTimes, all);
  if (course.position_unit == "rad") {
    all.push_back(periodic());
    all.push_back(periodic_damping());
  }
  all.push_back(velocity_by_position(course));
  all.push_back(memory());
  all.push_back(drifting(empty_family("time and velocity", true), course, &JointMoment::velocity));
  if (course.command_unit.empty()) return all;
  all.push_back(memory_of_command());
  all.push_back(command_and_velocity());
  all.push_back(drifting(empty_family("command and time", false), course, &JointMoment::command));
  return all;
}

std::vector<ForceTerm> force_terms(const JointCourse& course) {
  std::vector<ForceTerm> all;
  add_powers(all, course.position_unit);
  if (course.position_unit == "rad") add_waves(all);
  add_fading(all, course);
  if (!course.command_unit.empty()) add_commands(all, course);
  return all;
}

}  // namespace lacuna
