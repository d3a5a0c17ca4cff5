#include "data_checks/acceleration_table.h"

#include <algorithm>

namespace lacuna {
namespace {

/// The command integrated once and twice to its own samples and evaluated between them; constant before the first and
/// after the last. A command that is held between samples is a step function.
class Integrals {
 public:
  Integrals(const Eigen::VectorXd& times, const Eigen::VectorXd& values, Hold hold) : times_(times), values_(values) {
    slopes_ = Eigen::VectorXd::Zero(values.size());
    once_ = twice_ = Eigen::VectorXd::Zero(values.size());
    for (Eigen::Index i = 0; i + 1 < values.size(); ++i) {
      const double h = times(i + 1) - times(i);
      if (hold == Hold::first_order) slopes_(i) = (values(i + 1) - values(i)) / h;
      once_(i + 1) = once_(i) + h * (values_(i) + 0.5 * h * slopes_(i));
      twice_(i + 1) = twice_(i) + h * (once_(i) + h * (0.5 * values_(i) + h * slopes_(i) / 6.0));
    }
  }
  double at(double time, int order) const {
    const double* const next = std::upper_bound(times_.data(), times_.data() + times_.size(), time);
    const Eigen::Index i = std::max<Eigen::Index>(next - times_.data() - 1, 0);
    const double h = time - times_(i), slope = next == times_.data() ? 0.0 : slopes_(i);
    if (order == 1) return once_(i) + h * (values_(i) + 0.5 * h * slope);
    return twice_(i) + h * (once_(i) + h * (0.5 * values_(i) + h * slope / 6.0));
  }

 private:
  const Eigen::VectorXd& times_;
  Eigen::VectorXd values_, slopes_, once_, twice_;
};

}  // namespace

Eigen::MatrixXd ChannelAccelerations::of_commands(const Trial& source, double lag) const {
  const TimeSeries& commands = source.commands.series;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size(), commands.samples.cols());
  if (commands.times.size() == 0) return result;
  for (Eigen::Index u = 0; u < result.cols(); ++u) {
    const Integrals integrals(commands.times, commands.samples.col(u), source.commands.hold);
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Eigen::VectorXd& weight = weights[static_cast<std::size_t>(i)];
      const Eigen::Index begin = first[static_cast<std::size_t>(i)];
      for (Eigen::Index k = 0; k < weight.size(); ++k)
        result(i, u) += weight(k) * integrals.at(source.measured.times(begin + k) - lag, order);
    }
  }
  return result;
}

}  // namespace lacuna
