#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace lacuna {

/// A motion of size 1 and the time that it takes for something to happen in it, some 0.5 s.
struct TestMotion {
  std::string name;
  std::function<double(double)> at;  ///< of the time, s
};

/// A position that a first-order servo, which brakes at 4 units/s, takes to a row of goals.
inline double servo_steps(double t) {
  static constexpr double kGoals[] = {0.4, -0.8, 0.9, 0.1, -0.5, 0.7};
  const double stage = t / 0.8;
  const auto i = static_cast<std::size_t>(stage);
  const double from = i == 0 ? 0.0 : kGoals[(i - 1) % 6], to = kGoals[i % 6], since = 0.8 * (stage - std::floor(stage));
  return to + (from - to) * std::exp(-since / 0.05) * (std::cos(40.0 * since) + 0.5 * std::sin(40.0 * since));
}

/// Positions of joints.
inline std::vector<TestMotion> test_motions() {
  const double turn = 2.0 * std::numbers::pi;
  return {
      {"swing", [=](double t) { return std::exp(-0.1 * t) * std::sin(turn * 0.7 * t + 0.3); }},
      {"chirp", [=](double t) { return std::sin(turn * (0.2 * t + 0.12 * t * t)); }},
      {"sum of sines", [=](double t) { return 0.6 * std::sin(turn * 0.5 * t) + 0.3 * std::sin(turn * 1.7 * t + 1.0); }},
      {"servo steps", servo_steps},
      {"friction stops",  // moves for a while, stands for a while
       [](double t) {
         const double stage = t / 0.6;
         return 0.25 * (std::floor(stage) + std::min(1.0, 2.0 * (stage - std::floor(stage)))) - 1.0;
       }},
      {"impacts", [=](double t) { return std::exp(-0.2 * t) * std::abs(std::sin(turn * 0.6 * t + 0.4)); }},
      {"limit stops", [=](double t) { return std::clamp(1.4 * std::sin(turn * 0.5 * t), -1.0, 0.8); }},
      {"rest, then a swing", [=](double t) { return t < 2.0 ? 0.0 : std::sin(turn * 0.8 * (t - 2.0)); }},
      {"flexible",
       [=](double t) { return std::sin(turn * 0.5 * t) + 0.05 * std::exp(-0.3 * t) * std::sin(turn * 18.0 * t); }},
  };
}

/// Velocities, which may step.
inline std::vector<TestMotion> test_velocities() {
  const double turn = 2.0 * std::numbers::pi;
  return {
      {"impacts' velocity",
       [=](double t) {
         const double phase = turn * 0.6 * t + 0.4;
         return std::exp(-0.2 * t) * std::cos(phase) * (std::sin(phase) < 0.0 ? -1.0 : 1.0);
       }},
      {"relay", [=](double t) { return std::sin(turn * 3.0 * t) > 0.2 ? 1.0 : -1.0; }},
      {"stick and slip",
       [](double t) {  // slips of 20 ms, each of another size
         const double stage = t / 0.15;
         const double since = 0.15 * (stage - std::floor(stage));
         return since > 0.02
                    ? 0.0
                    : (0.6 + 0.4 * std::sin(7.0 * std::floor(stage))) * std::sin(std::numbers::pi * since / 0.02);
       }},
      {"vibration near half the rate", [=](double t) { return std::exp(-0.5 * t) * std::sin(turn * 47.0 * t); }},
      {"vibration beside a motion",
       [=](double t) { return std::sin(turn * 0.5 * t) + 0.2 * std::sin(turn * 47.0 * t); }},
  };
}

/// A column of a file, and which of its rows are not the joint's.
struct MixedColumn {
  std::vector<double> times, values;
  std::vector<std::size_t> bad;
  double quantum = 0.0;
};

struct Sampling {
  double rate = 100.0;   ///< 1/s
  double noise = 1e-3;   ///< standard deviation
  double quantum = 0.0;  ///< 0: none
  double seconds = 6.0;
};

inline MixedColumn sampled(const TestMotion& motion, const Sampling& how, std::mt19937& random) {
  MixedColumn column;
  std::normal_distribution<double> noise(0.0, 1.0);
  const auto count = static_cast<std::size_t>(how.seconds * how.rate);
  for (std::size_t i = 0; i < count; ++i) {
    column.times.push_back(static_cast<double>(i) / how.rate);
    double value = motion.at(column.times.back()) + how.noise * noise(random);
    if (how.quantum > 0.0) value = how.quantum * std::round(value / how.quantum);
    column.values.push_back(value);
  }
  return column;
}

/// Single readings that are somewhere else, with the given chance each.
inline void add_glitches(double chance, MixedColumn& column, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (std::size_t i = 3; i + 3 < column.values.size(); ++i) {
    if (uniform(random) >= chance) continue;
    column.bad.push_back(i);
    column.values[i] += (uniform(random) < 0.5 ? -1.0 : 1.0) * (1.5 + 2.0 * uniform(random));
  }
}

/// Rows of another publisher between those of the joint, after every `every` of them, more or less where `irregular`.
inline void add_rows_between(const std::function<double(double)>& other, std::size_t every, bool irregular,
                             MixedColumn& column, std::mt19937& random) {
  MixedColumn mixed;
  std::size_t left = every;
  std::uniform_int_distribution<int> more(-1, 1);
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    mixed.times.push_back(column.times[i]);
    mixed.values.push_back(column.values[i]);
    if (--left > 0 || i + 1 == column.values.size()) continue;
    left = static_cast<std::size_t>(std::max(1, static_cast<int>(every) + (irregular ? more(random) : 0)));
    mixed.bad.push_back(mixed.values.size());
    mixed.times.push_back(column.times[i] + 0.25 * (column.times[i + 1] - column.times[i]));
    mixed.values.push_back(other(mixed.times.back()));
  }
  column = mixed;
}

}  // namespace lacuna
