#include "report/figures/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kCloseEnds = 4.0;      // between them, where ticks are those of a linear axis
constexpr int kLinearTicks = 8;         // at most
constexpr double kBesideValues = 0.04;  // of the axis, beside the values
constexpr double kWidestNumber = 52.0;  // px
constexpr double kHighNumber = 18.0;    // px

/// Multiples of every so many powers of ten, for axes of at most so many decades.
struct TickStep {
  std::vector<double> factors;
  int powers;
  double most_decades;
};

std::vector<TickStep> tick_steps() {
  std::vector<TickStep> steps = {
      {{1, 2, 3, 4, 5, 6, 7, 8, 9}, 1, 1.2}, {{1, 2, 3, 5}, 1, 1.2}, {{1, 2, 5}, 1, 3.0}, {{1, 3}, 1, 3.0}};
  for (const int powers : {1, 2, 3, 5, 10, 20, 50, 100, 200}) steps.push_back({{1}, powers, HUGE_VAL});
  return steps;
}

std::vector<double> multiples(double low, double high, const TickStep& step) {
  std::vector<double> ticks;
  const double powers = step.powers;
  for (double power = std::floor(std::floor(std::log10(low)) / powers) * powers; power <= std::ceil(std::log10(high));
       power += powers)
    for (const double factor : step.factors) {
      const double tick = factor * std::pow(10.0, power);
      if (tick >= 0.999 * low && tick <= 1.001 * high) ticks.push_back(tick);
    }
  return ticks;
}

std::vector<double> round_numbers(double low, double high, int count) {
  const double rough = (high - low) / count, power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= 0.999 * rough) step = factor * power;
  std::vector<double> ticks;
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i += 1.0) ticks.push_back(i * step);
  return ticks;
}

bool are_apart(const std::vector<double>& ticks, double least) {
  return std::adjacent_find(ticks.begin(), ticks.end(), [&](double one, double next) {
           return std::log(next / one) < 0.999 * least;
         }) == ticks.end();
}

}  // namespace

std::vector<double> log_ticks(double low, double high, double apart) {
  const double length = std::log(high) - std::log(low), least = apart * length;
  if (high / low < kCloseEnds)
    for (int count = kLinearTicks; count > 0; --count)
      if (std::vector<double> ticks = round_numbers(low, high, count); are_apart(ticks, least)) return ticks;
  for (const TickStep& step : tick_steps()) {
    if (length / std::log(10.0) > step.most_decades) continue;
    if (std::vector<double> ticks = multiples(low, high, step); are_apart(ticks, least)) return ticks;
  }
  return {};
}

std::string log_tick_text(double tick) {
  return tick >= 0.9e-3 && tick < 1e5 ? fmt::format("{:.6g}", tick) : fmt::format("{:.3g}", tick);
}

std::string log_axis(char axis, double low, double high, double length, bool numbered) {
  if (!(low > 0.0) || !(low <= high)) return {};
  const double least = std::pow(1.5, high / low < 1.5 ? 1.0 : 0.0);
  low /= least;
  high *= least;
  const double margin = std::exp(kBesideValues * (std::log(high) - std::log(low)));
  low /= margin;
  high *= margin;
  std::string ticks;
  for (const double tick : log_ticks(low, high, (axis == 'x' ? kWidestNumber : kHighNumber) / std::max(length, 1.0)))
    ticks += fmt::format("{}\"{}\" {:.9g}", ticks.empty() ? "" : ", ", numbered ? log_tick_text(tick) : "", tick);
  return fmt::format("set logscale {0}\nset {0}range [{1:.9g}:{2:.9g}]\nset {0}tics ({3})\n", axis, low, high, ticks);
}

}  // namespace lacuna
