#include "support/convergence.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace lacuna {
namespace {

constexpr double kRoundingOfRuns = 3e-12;  ///< of the readings' size, after some thousand steps
constexpr std::size_t kFitted = 4;         ///< the finest changes, which the slope is fitted to

Eigen::ArrayXd sizes_of(const TimeSeries::Samples& readings) {
  return (readings.array().square().colwise().mean().sqrt()).max(1e-300).transpose();
}

double change(const TimeSeries::Samples& coarse, const TimeSeries::Samples& fine, const Eigen::ArrayXd& sizes) {
  return std::sqrt(((coarse - fine).array().rowwise() / sizes.transpose()).square().mean());
}

/// Least squares through (−i, log2 of a change).
double slope(const std::vector<double>& changes) {
  const double middle = 0.5 * static_cast<double>(changes.size() - 1);
  double moment = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const double place = static_cast<double>(i) - middle;
    moment -= place * std::log2(changes[i]);
    spread += place * place;
  }
  return moment / spread;
}

}  // namespace

Convergence converge(const std::function<TimeSeries::Samples(int)>& solution, int halvings) {
  Convergence found;
  std::vector<double> above_rounding;
  TimeSeries::Samples coarse = solution(0);
  const Eigen::ArrayXd sizes = sizes_of(coarse);
  for (int halving = 1; halving <= halvings; ++halving) {
    const TimeSeries::Samples fine = solution(halving);
    found.changes.push_back(change(coarse, fine, sizes));
    coarse = fine;
    // What has reached rounding stays there, whatever a later one happens to be.
    if (above_rounding.size() + 1 == found.changes.size() && found.changes.back() > kRoundingOfRuns)
      above_rounding.push_back(found.changes.back());
  }
  found.exact = above_rounding.size() < 2;
  if (found.exact) return found;
  if (above_rounding.size() > kFitted) above_rounding.erase(above_rounding.begin(), above_rounding.end() - kFitted);
  found.order = slope(above_rounding);
  return found;
}

std::string to_string(const Convergence& convergence) {
  std::ostringstream text;
  text << "order " << (convergence.exact ? "exact" : std::to_string(convergence.order)) << ", changes";
  for (const double change : convergence.changes) text << ' ' << change;
  return text.str();
}

}  // namespace lacuna
