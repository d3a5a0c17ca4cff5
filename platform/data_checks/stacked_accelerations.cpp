#include "data_checks/stacked_accelerations.h"

#include "data_checks/command_lags.h"
#include "data_checks/straight_fit.h"

#include <algorithm>

namespace lacuna {

std::vector<StackedAccelerations> stacked(const AccelerationTable& table) {
  std::vector<StackedAccelerations> all;
  for (const ChannelAccelerations& one : table.channels) {
    auto known =
        std::find_if(all.begin(), all.end(), [&](const StackedAccelerations& s) { return s.channel == one.channel; });
    if (known == all.end()) known = all.insert(all.end(), {one.channel, one.unit, {}, {}, {}, one.deviation});
    const Eigen::MatrixXd beside = surroundings(one);
    const Eigen::Index before = known->measured.size(), rows = before + one.size();
    known->measured.conservativeResize(rows);
    known->beside.conservativeResize(rows, beside.cols());
    known->commanded.conservativeResize(rows, one.commanded.cols());
    known->measured.tail(one.size()) = one.measured / one.deviation;
    known->beside.bottomRows(one.size()) = beside;
    known->commanded.bottomRows(one.size()) = one.commanded / one.deviation;
  }
  return all;
}

double unexplained_share(const AccelerationTable& table) {
  double left = 0.0, all = 0.0;
  for (const StackedAccelerations& one : stacked(table)) {
    Eigen::MatrixXd columns(one.beside.rows(), one.beside.cols() + one.commanded.cols());
    columns << one.beside, one.commanded;
    left += straight_fit(columns, one.measured).squares;
    all += one.measured.squaredNorm();
  }
  return all > 0.0 ? left / all : 1.0;
}

}  // namespace lacuna
