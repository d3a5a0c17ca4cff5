#include "fitting/shooting/start_points.h"

#include "fitting/numerics/seeded_noise.h"
#include "foundation/statistics.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSmallestShare = 1e-7;  ///< of the range, where the search for a size begins
constexpr double kLadder = 3.1622776601683795;

double rms_change(const std::vector<Eigen::VectorXd>& a, const std::vector<Eigen::VectorXd>& b) {
  std::vector<Eigen::VectorXd> difference;
  for (std::size_t k = 0; k < a.size(); ++k) difference.push_back(a[k] - b[k]);
  return root_mean_square(difference);
}

/// The smallest size on a geometric ladder from zero at which value `j` matters: it changes the prediction by as much
/// as the residual, or by half of its largest possible change.
double size_that_matters(ShootingProblem& problem, const FreeValue& free, Eigen::Index j, const FitPoint& own,
                         const std::vector<Eigen::VectorXd>& residuals) {
  const double direction = free.upper > 0.0 ? 1.0 : -1.0;
  const double farthest = direction > 0.0 ? free.upper : -free.lower;
  const double enough = std::max(1.0, root_mean_square(residuals));
  std::vector<double> changes;
  std::vector<Eigen::VectorXd> moved;
  for (double size = kSmallestShare * farthest; size < farthest; size *= kLadder) {
    FitPoint point = own;
    point.values(j) = direction * size;
    if (!problem.residuals(point, moved)) break;
    changes.push_back(rms_change(moved, residuals));
    if (changes.back() >= enough) break;
  }
  if (changes.empty()) return kSmallestShare * farthest;
  const double half = 0.5 * *std::max_element(changes.begin(), changes.end());
  const auto rung = std::find_if(changes.begin(), changes.end(), [&](double change) { return change >= half; });
  return kSmallestShare * farthest * std::pow(kLadder, static_cast<double>(rung - changes.begin()));
}

/// Sizes of the values that start at zero; 0 for the others.
std::vector<double> finite_sizes(ShootingProblem& problem, const ParameterSpace& space,
                                 const std::vector<FreeValue>& free, const FitPoint& own) {
  std::vector<double> sizes(free.size(), 0.0);
  std::vector<Eigen::VectorXd> residuals;
  const bool valid = problem.residuals(own, residuals);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    if (free[i].start != 0.0 || space.logarithmic(j)) continue;
    sizes[i] = valid ? size_that_matters(problem, free[i], j, own, residuals)
                     : 1e-3 * std::max(std::abs(free[i].lower), std::abs(free[i].upper));
  }
  return sizes;
}

double draw(const FreeValue& free, double size, SeededNoise& random) {
  const double spread = std::pow(10.0, random.uniform(-1.0, 1.0));
  const double side = random.uniform();
  if (free.start == 0.0) {
    const bool negative = free.lower < 0.0 && (free.upper <= 0.0 || side < 0.5);
    return negative ? -size * spread : size * spread;
  }
  const double within = random.uniform();
  const bool narrow = free.upper - free.lower < 2.0 * std::abs(free.start);
  if (narrow) return free.lower + within * (free.upper - free.lower);
  return free.start * std::pow(10.0, 1.2 * (within - 0.5));
}

}  // namespace

std::vector<Eigen::VectorXd> start_points(ShootingProblem& problem, const ParameterSpace& space,
                                          const std::vector<FreeValue>& free, int count, std::uint64_t seed) {
  std::vector<double> own;
  for (const FreeValue& value : free) own.push_back(value.start);
  std::vector<Eigen::VectorXd> points = {space.to_coordinates(own)};
  if (count <= 1) return points;

  const std::vector<double> sizes = finite_sizes(problem, space, free, problem.start(points.front()));
  const bool any_zero = std::any_of(sizes.begin(), sizes.end(), [](double size) { return size > 0.0; });
  for (const double share : {1.0, 0.2}) {
    if (!any_zero || static_cast<int>(points.size()) >= count) break;
    std::vector<double> finite = own;
    for (std::size_t i = 0; i < free.size(); ++i)
      if (sizes[i] > 0.0) finite[i] = (free[i].upper > 0.0 ? share : -share) * sizes[i];
    points.push_back(space.to_coordinates(finite));
  }
  for (std::uint64_t stream = 0; static_cast<int>(points.size()) < count; ++stream) {
    SeededNoise random(seed, stream);
    std::vector<double> drawn;
    for (std::size_t i = 0; i < free.size(); ++i)
      drawn.push_back(std::clamp(draw(free[i], sizes[i], random), free[i].lower, free[i].upper));
    points.push_back(space.to_coordinates(drawn));
  }
  return points;
}

}  // namespace lacuna
