#pragma once

#include <cmath>

namespace lacuna {

/// A number with its derivatives by a joint's position and velocity: arithmetic on it differentiates by the chain rule
/// (forward mode; R. E. Wengert, Communications of the ACM 7 (1964) 463-464). A plain number converts to one whose
/// derivatives are zero. Where a function has a kink (abs and sgn at zero) or an infinite slope (sqrt at zero), the
/// derivative is zero: no side is preferred.
struct Dual {
  double value = 0.0, by_position = 0.0, by_velocity = 0.0;

  Dual() = default;
  Dual(double number) : value(number) {}  // implicit, so that laws may contain plain numbers
  Dual(double number, double d_position, double d_velocity)
      : value(number), by_position(d_position), by_velocity(d_velocity) {}

  static Dual position(double q) { return {q, 1.0, 0.0}; }
  static Dual velocity(double v) { return {v, 0.0, 1.0}; }

  /// A function of this number, from its value and slope at the number.
  Dual through(double result, double slope) const { return {result, slope * by_position, slope * by_velocity}; }
};

inline Dual operator-(const Dual& a) { return a.through(-a.value, -1.0); }
inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.by_position + b.by_position, a.by_velocity + b.by_velocity};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.by_position - b.by_position, a.by_velocity - b.by_velocity};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.by_position * b.value + a.value * b.by_position,
          a.by_velocity * b.value + a.value * b.by_velocity};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.by_position - quotient * b.by_position) / b.value,
          (a.by_velocity - quotient * b.by_velocity) / b.value};
}

inline Dual sgn(const Dual& a) { return {a.value > 0.0 ? 1.0 : a.value < 0.0 ? -1.0 : 0.0}; }
inline Dual abs(const Dual& a) { return a.through(std::abs(a.value), sgn(a).value); }
inline Dual sin(const Dual& a) { return a.through(std::sin(a.value), std::cos(a.value)); }
inline Dual cos(const Dual& a) { return a.through(std::cos(a.value), -std::sin(a.value)); }
inline Dual exp(const Dual& a) { return a.through(std::exp(a.value), std::exp(a.value)); }
inline Dual tanh(const Dual& a) {
  const double result = std::tanh(a.value);
  return a.through(result, 1.0 - result * result);
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return a.through(root, root > 0.0 ? 0.5 / root : 0.0);
}
inline Dual pow(const Dual& a, double exponent) {
  const bool infinite = a.value == 0.0 && exponent < 1.0;
  return a.through(std::pow(a.value, exponent), infinite ? 0.0 : exponent * std::pow(a.value, exponent - 1.0));
}

}  // namespace lacuna
