#include "candidates/probe_sizes.h"

#include "candidates/data_scales.h"
#include "fitting/shooting/parameter_space.h"
#include "foundation/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr double kFirst = 1e-3;    ///< of a parameter's range, the first size
constexpr double kStride = 100.0;  ///< at most, from a size to the next
constexpr int kTrials = 24;
constexpr double kBeside = 0.01;                  ///< of a parameter's range, for one that matters only beside another
constexpr double kOutside = 2.0;                  ///< of the robot's length, for places outside the robot
constexpr double kTooMuch = 1.5;                  ///< of the residual
constexpr double kVisible = 1e-3;                 ///< of the residual
constexpr std::array kOtherOrders = {0.1, 0.01};  ///< of a shape's usual value
constexpr double kNeverReached = 10.0;            ///< of the usual speed
constexpr std::array kNearSpeeds = {1.5, 3.0};    ///< of the usual speed

/// The longest way between two joints or centres of mass, m.
double size_of(const RobotSpec& robot) {
  std::vector<Eigen::Vector3d> points;
  for (const JointSpec& joint : robot.joints) points.push_back(joint.anchor);
  for (const BodySpec& body : robot.bodies) points.push_back(body.position + body.orientation * body.com);
  double longest = 0.0;
  for (const Eigen::Vector3d& one : points)
    for (const Eigen::Vector3d& other : points) longest = std::max(longest, (one - other).norm());
  return longest;
}

/// Finds the distance from its neutral value at which a parameter matters.
class Climber {
 public:
  Climber(const Hypothesis& hypothesis, const OwnResiduals& simulate, const WantedChange& wanted)
      : hypothesis_(hypothesis),
        simulate_(simulate),
        wanted_(wanted),
        space_(hypothesis.definition.free),
        robot_size_(size_of(hypothesis.definition.structure.robot)),
        others_(hypothesis.neutral) {
    valid_ = simulate_(hypothesis_.neutral, calm_);
    residual_ = std::max(1.0, root_mean_square(calm_));
  }

  bool valid() const { return valid_; }
  /// Values of the other parameters during the search for one; neutral at first.
  void set_others(const std::vector<double>& others) { others_ = others; }

  /// Whether a negative size has no meaning: that way is closed, or was tried first and changes nothing.
  bool one_sided(std::size_t i) const { return direction_ < 0.0 || !(room(i, 1.0) > 0.0 && room(i, -1.0) > 0.0); }

  /// The value a small step up (1) or down (−1) from its neutral value towards a bound. A place is tried a little
  /// beyond the robot's size only: from afar all places act alike.
  double beside(std::size_t i, double direction) const {
    double way = kBeside * room(i, direction);
    if (robot_size_ > 0.0 && has_place(hypothesis_) && is_length(hypothesis_.definition.free[hypothesis_.own[i]]))
      way = std::min(way, kOutside * robot_size_);
    return space_.to_value(static_cast<Eigen::Index>(hypothesis_.own[i]), neutral(i) + direction * way);
  }

  /// The value of parameter `i`, the others as set, that changes the prediction by about as much as the residual, or by
  /// as much as the parameter can. Tries values above, and values below where nothing above changes the prediction (a
  /// limit that is out of reach). Nothing where neither does.
  std::optional<double> size(std::size_t i) {
    for (const double direction : {1.0, -1.0}) {
      direction_ = direction;
      if (!(room(i, direction) > 0.0)) continue;
      if (const std::optional<double> found = size_on_the_way(i)) return found;
    }
    return std::nullopt;
  }
  /// Whether that size reaches the residual, rather than the most that the parameter can do.
  bool is_enough() const { return is_enough_; }

 private:
  std::optional<double> size_on_the_way(std::size_t i) {
    is_enough_ = false;
    const double range = room(i, direction_);
    double below = 0.0, above = range, way = kFirst * range, best = 0.0, most = 0.0;
    std::vector<std::pair<double, double>> jumps;  // distances and changes that are too large
    for (int trial = 0; trial < kTrials && way > 0.0; ++trial) {
      const std::optional<double> change = changed_by(i, way);
      if (change && *change > most && *change <= kTooMuch * residual_) {
        most = *change;
        best = way;
      }
      is_enough_ = change && *change >= wanted_.enough * residual_ && *change <= kTooMuch * residual_;
      if (is_enough_) return value(i, way);
      if (change && *change > kTooMuch * residual_) jumps.emplace_back(way, *change);
      const bool small = change && *change < wanted_.enough * residual_;
      if (small && way >= range) break;
      (small ? below : above) = way;
      way = next_way(below, above, range, way, change);
    }
    if (most >= kVisible) return value(i, best);
    return wanted_.may_jump && !jumps.empty() ? std::optional(value(i, beyond_jump(jumps))) : std::nullopt;
  }

  /// Among distances that all change too much, the largest at which the smooth change is still below the jump.
  static double beyond_jump(const std::vector<std::pair<double, double>>& jumps) {
    double least = jumps.front().second, furthest = 0.0;
    for (const auto& [way, change] : jumps) least = std::min(least, change);
    for (const auto& [way, change] : jumps)
      if (change <= 2.0 * least) furthest = std::max(furthest, way);
    return furthest;
  }
  double neutral(std::size_t i) const {
    return space_.to_coordinate(static_cast<Eigen::Index>(hypothesis_.own[i]), hypothesis_.neutral[i]);
  }
  double room(std::size_t i, double direction) const {
    const auto j = static_cast<Eigen::Index>(hypothesis_.own[i]);
    return direction > 0.0 ? space_.upper()(j) - neutral(i) : neutral(i) - space_.lower()(j);
  }
  double value(std::size_t i, double way) const {
    return space_.to_value(static_cast<Eigen::Index>(hypothesis_.own[i]), neutral(i) + direction_ * way);
  }

  /// RMS change of the prediction, in multiples of the sensor noise; nothing where it cannot be simulated.
  std::optional<double> changed_by(std::size_t i, double way) {
    std::vector<double> own = others_;
    own[i] = value(i, way);
    if (!simulate_(own, moved_)) return std::nullopt;
    for (std::size_t k = 0; k < calm_.size(); ++k) moved_[k] -= calm_[k];
    return root_mean_square(moved_);
  }

  /// Scales in proportion to the wanted change, between a value that is too small and one that is too large.
  double next_way(double below, double above, double range, double way, const std::optional<double>& change) const {
    const double wanted = !change ? 0.1 * way
                          : *change > 0.0
                              ? way * std::clamp(wanted_.aimed_at * residual_ / *change, 1.0 / kStride, kStride)
                              : way * kStride;
    if (wanted > below && wanted < above) return wanted;
    if (wanted >= above && above >= range) return range;
    return below > 0.0 ? std::sqrt(below * above) : above / kStride;
  }

  const Hypothesis& hypothesis_;
  const OwnResiduals& simulate_;
  const WantedChange& wanted_;
  ParameterSpace space_;
  double robot_size_;       ///< m; 0: all at one point
  double residual_ = 1.0;   ///< on these segments, multiples of the sensor noise
  double direction_ = 1.0;  ///< direction of the search: up or down
  bool is_enough_ = false;  ///< the size that was found last
  std::vector<double> others_;
  bool valid_ = false;
  std::vector<Eigen::VectorXd> calm_, moved_;
};

/// Sizes each parameter that matters by itself; the others go to `shapes`. Whether any changes as much as the residual.
bool climb(Climber& climber, const std::vector<double>& others, std::vector<SizedProbe>& probes,
           std::vector<std::size_t>& shapes) {
  bool enough = false;
  climber.set_others(others);
  for (std::size_t i = 0; i < others.size(); ++i) {
    const std::optional<double> size = climber.size(i);
    if (!size) {
      shapes.push_back(i);
      continue;
    }
    enough = enough || climber.is_enough();
    SizedProbe probe{others, i, climber.one_sided(i)};
    probe.own[i] = *size;
    probes.push_back(std::move(probe));
  }
  return enough;
}

/// Parameters that matter only where another one is not neutral, such as a payload's mass and its place: a mass on the
/// axis of a hinge has no effect. Places are set and the other parameters searched, not the reverse: beside a huge mass
/// the place would be found almost at zero.
void climb_beside(Climber& climber, const Hypothesis& hypothesis, std::vector<SizedProbe>& probes) {
  const std::vector<double>& neutral = hypothesis.neutral;
  const bool only_places = has_place(hypothesis);
  std::vector<std::size_t> unused;
  for (std::size_t i = 0; i < neutral.size() && neutral.size() > 1; ++i)
    for (const double side : {1.0, -1.0}) {
      if (only_places && !is_length(hypothesis.definition.free[hypothesis.own[i]])) continue;
      std::vector<double> others = neutral;
      others[i] = climber.beside(i, side);
      if (others[i] != neutral[i]) climb(climber, others, probes, unused);
    }
}

/// Sizes at places between the axes: directions between two axes are as likely as the axes.
void climb_between_axes(Climber& climber, const Hypothesis& hypothesis, std::vector<SizedProbe>& probes) {
  constexpr unsigned kCorners = 8;
  std::vector<std::size_t> unused;
  for (unsigned corner = 0; corner < kCorners; ++corner) {
    std::vector<double> others = hypothesis.neutral;
    unsigned axis = 0;
    for (std::size_t i = 0; i < others.size(); ++i)
      if (is_length(hypothesis.definition.free[hypothesis.own[i]]))
        others[i] = climber.beside(i, (corner >> axis++ & 1U) != 0 ? 1.0 : -1.0);
    climb(climber, others, probes, unused);
  }
}

/// Sizes with another value of a parameter that only shapes the effect and for which the data suggest no value: a soft
/// stop begins earlier than a stiff one.
void climb_at_other_orders(Climber& climber, const Hypothesis& hypothesis, std::size_t shape,
                           const std::map<std::string, double>& scales, std::vector<SizedProbe>& probes) {
  const FreeValue& free = hypothesis.definition.free[hypothesis.own[shape]];
  if (free.scale != Scale::logarithmic || !shapes_to_try(free.unit, scales).empty()) return;
  std::vector<std::size_t> unused;
  for (const double order : kOtherOrders) {
    std::vector<double> others = hypothesis.defaults;
    others[shape] = std::clamp(order * others[shape], free.lower, free.upper);
    climb(climber, others, probes, unused);
  }
}

/// Parameters that matter only beside a speed that is never reached: a motor's torque falls near its no-load speed.
void climb_near_speeds(Climber& climber, const Hypothesis& hypothesis, const std::map<std::string, double>& scales,
                       std::vector<SizedProbe>& probes) {
  std::vector<std::size_t> unused;
  for (std::size_t i = 0; i < hypothesis.own.size() && hypothesis.own.size() > 1; ++i) {
    const FreeValue& free = hypothesis.definition.free[hypothesis.own[i]];
    const auto usual = scales.find(free.unit);
    if (usual == scales.end() || !free.unit.ends_with("/s") || !(usual->second > 0.0)) continue;
    if (hypothesis.defaults[i] < kNeverReached * usual->second) continue;
    for (const double times : kNearSpeeds) {
      std::vector<double> others = hypothesis.defaults;
      others[i] = std::clamp(times * usual->second, free.lower, free.upper);
      climb(climber, others, probes, unused);
    }
  }
}

/// Probes before their responses are known.
std::vector<SizedProbe> sized_probes(Climber& climber, const Hypothesis& hypothesis,
                                     const std::map<std::string, double>& scales) {
  std::vector<SizedProbe> probes;
  std::vector<std::size_t> shapes, unused;
  const bool enough = climb(climber, hypothesis.neutral, probes, shapes);
  if (!enough || has_place(hypothesis)) climb_beside(climber, hypothesis, probes);
  if (has_place(hypothesis)) climb_between_axes(climber, hypothesis, probes);
  if (hypothesis.defaults != hypothesis.neutral) {
    probes.push_back({hypothesis.defaults, std::nullopt, true});
    climb(climber, hypothesis.defaults, probes, unused);
  }
  for (const std::size_t shape : shapes) climb_at_other_orders(climber, hypothesis, shape, scales, probes);
  climb_near_speeds(climber, hypothesis, scales, probes);
  const std::size_t switched_on = probes.size();
  for (const std::size_t shape : shapes) {
    const FreeValue& free = hypothesis.definition.free[hypothesis.own[shape]];
    for (const double size : shapes_to_try(free.unit, scales))
      for (const double value : {size, -size}) {
        if (value == hypothesis.defaults[shape] || value < free.lower || value > free.upper) continue;
        for (std::size_t p = 0; p < switched_on; ++p) {
          SizedProbe probe = probes[p];
          probe.own[shape] = value;
          probes.push_back(std::move(probe));
        }
      }
  }
  return probes;
}

}  // namespace

std::vector<SizedProbe> size_probes(const Hypothesis& hypothesis, const OwnResiduals& simulate,
                                    const WantedChange& wanted, const std::map<std::string, double>& scales) {
  Climber climber(hypothesis, simulate, wanted);
  return climber.valid() ? sized_probes(climber, hypothesis, scales) : std::vector<SizedProbe>();
}

}  // namespace lacuna
