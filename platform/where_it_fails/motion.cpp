#include "where_it_fails/motion.h"

#include <cmath>

namespace lacuna {

Motion motion_of(const Eigen::VectorXd& times, const Eigen::VectorXd& velocities, double rest) {
  Motion motion{Eigen::VectorXd::Zero(times.size()), Eigen::VectorXd::Zero(times.size())};
  double direction = 0.0;
  double ended = times.size() > 0 ? times(0) : 0.0;
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    const double now = std::abs(velocities(i)) > rest ? std::copysign(1.0, velocities(i)) : 0.0;
    if (direction != 0.0 && now != direction) ended = times(i);
    direction = now;
    motion.direction(i) = now;
    motion.since_reversal(i) = times(i) - ended;
  }
  return motion;
}

}  // namespace lacuna
