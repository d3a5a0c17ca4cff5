#pragma once

#include <lacuna/time_series.h>

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace lacuna {

/// The course of a command between two samples.
enum class Hold { zero_order, first_order };

/// Commands as functions of time; channels have the names of the actuators they drive.
struct CommandSeries {
  TimeSeries series;  ///< constant after the last sample
  Hold hold = Hold::zero_order;
  /// Command before the first sample, by channel: the initial value of delays and lags. NaN, or empty: the first
  /// sample's.
  std::vector<double> before = {};
  bool may_be_off = false;  ///< NaN in a sample means that the actuator is off; otherwise NaN is an error

  /// The command of a channel before the first sample.
  double before_first(Eigen::Index channel) const {
    const auto i = static_cast<std::size_t>(channel);
    return before.empty() || std::isnan(before[i]) ? series.samples(0, channel) : before[i];
  }
};

/// Computes commands from sensor readings, once per control period. Const and shared by threads; memory is in `state`.
class Controller {
 public:
  virtual ~Controller() = default;
  virtual int state_size() const { return 0; }
  /// A text that differs between laws, part of the digests of trials that are driven by the controller.
  virtual std::string identity() const { return {}; }
  /// `sensors`: one value per sensor channel; `commands`: one per actuator, to be written; time in s.
  virtual void act(double time, std::span<const double> sensors, std::span<double> state,
                   std::span<double> commands) const = 0;
};

/// Joint coordinates at the start, in joint order, rad or m; empty: zero. Floating bodies start at their pose in the
/// spec, at rest.
struct StartState {
  std::vector<double> positions;
  std::vector<double> velocities;
};

/// A test for the target.
struct Test {
  std::variant<CommandSeries, std::shared_ptr<const Controller>>
      drive;              ///< shared: a controller may outlive the genome it came from and is used by several trials
  double duration = 0.0;  ///< s
  StartState start;
  std::string setup = {};  ///< setup of the rig, known to the model, such as "heavy_load"; empty: the model as it is
};

}  // namespace lacuna
