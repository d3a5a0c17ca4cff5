#include "app/workspace/channel_extent.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

void widen(ChannelExtent& extent, const TimeSeries& series, const std::string& channel) {
  for (std::size_t c = 0; c < series.channels.size(); ++c) {
    if (series.channels[c].name != channel) continue;
    extent.unit = series.channels[c].unit;
    for (const double value : series.samples.col(static_cast<Eigen::Index>(c))) {
      if (std::isnan(value))
        ++extent.missing;
      else
        extent.smallest = std::min(extent.smallest, value), extent.largest = std::max(extent.largest, value);
    }
  }
}

}  // namespace

ChannelExtent extent_of(const std::string& channel, SeriesKind kind, const std::vector<Trial>& trials) {
  ChannelExtent extent;
  for (const Trial& trial : trials)
    widen(extent, kind == SeriesKind::measured ? trial.measured : trial.commands.series, channel);
  return extent;
}

double duration_of(const Trial& trial) {
  const Eigen::VectorXd& times = trial.measured.times;
  return times.size() > 1 ? times[times.size() - 1] - times[0] : 0.0;
}

}  // namespace lacuna
