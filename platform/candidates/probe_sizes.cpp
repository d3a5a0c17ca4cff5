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
constexpr double kBeside = 0.01;                  ///< of a parameter's range, where one matters only beside another
constexpr double kOutside = 2.0;                  ///< of the robot's length, where nothing of it gets
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

/// How far a parameter must go from its neutral value to matter.
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
  /// What the other parameters are while one climbs; at first neutral.
  void set_others(const std::vector<double>& others) { others_ = others; }

  /// Whether a size of the other sign has no meaning: the way there is closed, or was climbed first and changes
  /// nothing.
  bool one_sided(std::size_t i) const { return direction_ < 0.0 || !(room(i, 1.0) > 0.0 && room(i, -1.0) > 0.0); }

  /// The value a little of the way up (1) or down (−1) from its neutral value to a bound. A place is further from the
  /// origin than the robot is long, but not much: from afar all places are alike.
  double beside(std::size_t i, double direction) const {
    double way = kBeside * room(i, direction);
    if (robot_size_ > 0.0 && has_place(hypothesis_) && is_length(hypothesis_.definition.free[hypothesis_.own[i]]))
      way = std::min(way, kOutside * robot_size_);
    return space_.to_value(static_cast<Eigen::Index>(hypothesis_.own[i]), neutral(i) + direction * way);
  }

  /// The value at which parameter `i`, the others as set, changes the prediction by about as much as the residual;
  /// failing that, by as much as it can. It goes up, and down where nothing above changes anything (a limit that is out
  /// of reach). Nothing where neither does.
  std::optional<double> size(std::size_t i) {
    for (const double direction : {1.0, -1.0}) {
      direction_ = direction;
      if (!(room(i, direction) > 0.0)) continue;
      if (const std::optional<double> found = size_on_the_way(i)) return found;
    }
    return std::nullopt;
  }
  /// Whether that size changes as much as the residual, rather than as much as can be.
  bool is_enough() const { return is_enough_; }

 private:
  std::optional<double> size_on_the_way(std::size_t i) {
    is_enough_ = false;
    const double range = room(i, direction_);
    double below = 0.0, above = range, way = kFirst * range, best = 0.0, most = 0.0;
    std::vector<std::pair<double, double>> jumps;  // ways and changes, too large
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

  /// Of ways that all change too much, the furthest on which what grows with the way does not yet outgrow the jump.
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

  /// As far as a change in proportion would need, between what is too little and what is too much.
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
  double robot_size_;       ///< m; 0: a single point
  double residual_ = 1.0;   ///< on these segments, multiples of the sensor noise
  double direction_ = 1.0;  ///< of the way that is climbed: up or down
  bool is_enough_ = false;  ///< the size that was found last
  std::vector<double> others_;
  bool valid_ = false;
  std::vector<Eigen::VectorXd> calm_, moved_;
};

/// Each parameter that matters by itself; the others go to `shapes`. Whether any matters as much as the residual does.
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
/// axis of a hinge turns nothing. Where there are places, those are where the others are climbed, not the other way
/// round: beside a huge mass its place would come out as next to nothing.
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

/// Sizes at places between the axes, where there are places: the directions from one axis to the next are as likely.
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

/// Parameters that matter, where one that only shapes the effect, of which the data suggest no value, is of another
/// order: a soft stop begins earlier than a stiff one.
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

/// Parameters that matter only beside a velocity that is never reached: what a motor can do falls with the speed where
/// that comes near its speed without load.
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

/// Probes without their responses.
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
