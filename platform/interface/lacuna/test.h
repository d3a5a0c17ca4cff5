#pragma once

#include <lacuna/time_series.h>

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace lacuna {

/// What a command does between two samples.
enum class Hold { zero_order, first_order };

/// Commands as functions of time; channels are named like the actuators they drive.
struct CommandSeries {
  TimeSeries series;  ///< after its last sample, the last one counts
  Hold hold = Hold::zero_order;
  /// What was commanded before the first sample, by channel: what delays and lags hold at the start. NaN, or no value
  /// at all: the first sample's.
  std::vector<double> before = {};
  bool may_be_off = false;  ///< NaN in a sample means that the actuator is off; else it is a mistake

  /// The command of a channel before the first sample.
  double before_first(Eigen::Index channel) const {
    const auto i = static_cast<std::size_t>(channel);
    return before.empty() || std::isnan(before[i]) ? series.samples(0, channel) : before[i];
  }
};

/// Turns sensor readings into commands, once a control period. Const and shared by threads;
/// memory lies in `state`.
class Controller {
 public:
  virtual ~Controller() = default;
  virtual int state_size() const { return 0; }
  /// A text that is another one for another law, where trials are driven by it: part of their digests.
  virtual std::string identity() const { return {}; }
  /// `sensors`: one value a sensor channel; `commands`: one an actuator, to be written; time in s.
  virtual void act(double time, std::span<const double> sensors, std::span<double> state,
                   std::span<double> commands) const = 0;
};

/// Joint coordinates at the start, in joint order, rad or m; empty: zero. Bodies that float
/// start at their pose in the spec, at rest.
struct StartState {
  std::vector<double> positions;
  std::vector<double> velocities;
};

/// What is done to the target.
struct Test {
  std::variant<CommandSeries, std::shared_ptr<const Controller>>
      drive;              ///< shared: a controller outlives the genome it came from and is used by several trials
  double duration = 0.0;  ///< s
  StartState start;
  std::string setup = {};  ///< of the rig, one that the model knows, such as "heavy_load"; empty: the model as it is
};

}  // namespace lacuna
