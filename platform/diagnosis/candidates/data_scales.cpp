#include "diagnosis/candidates/data_scales.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSpan = 0.02;    // s, over which a speed is read off positions
constexpr double kRarely = 0.95;  // share of moments with less speed

void hold(double& largest, double value) { largest = std::max(largest, value); }

double usual_speed(const Eigen::VectorXd& times, const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::vector<double> speeds;
  Eigen::Index behind = 0;
  for (Eigen::Index row = 0; row < values.size(); ++row) {
    while (times(row) - times(behind) > kSpan) ++behind;
    const double span = times(row) - times(behind);
    const double speed = std::abs(values(row) - values(behind)) / span;
    if (span > 0.0 && std::isfinite(speed)) speeds.push_back(speed);
  }
  if (speeds.empty()) return 0.0;
  const auto rank = speeds.begin() + static_cast<std::ptrdiff_t>(kRarely * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), rank, speeds.end());
  return *rank;
}

}  // namespace

std::map<std::string, double> data_scales(const std::vector<Trial>& trials) {
  std::map<std::string, double> scales;
  for (const Trial& trial : trials)
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
      const Eigen::VectorXd values = trial.measured.samples.col(static_cast<Eigen::Index>(c));
      double low = INFINITY, high = -INFINITY;
      for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
      const std::string& unit = trial.measured.channels[c].unit;
      if (high > low) hold(scales[unit], high - low);
      hold(scales[unit + "/s"], usual_speed(trial.measured.times, values));
    }
  return scales;
}

std::vector<double> shapes_to_try(const std::string& unit, const std::map<std::string, double>& scales) {
  if (unit == "1/s") return {10.0, 60.0, 300.0};
  if (unit == "s") return {1.0, 10.0};
  if (unit == "1/rad" || unit == "1/m") return {1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0};
  const auto known = scales.find(unit);
  if (known == scales.end() || !(known->second > 0.0)) return {};
  const bool speed = unit.size() > 2 && unit.ends_with("/s");
  return speed ? std::vector{0.02 * known->second, 0.2 * known->second}
               : std::vector{0.03 * known->second, 0.3 * known->second};
}

}  // namespace lacuna
