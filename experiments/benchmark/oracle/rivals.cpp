#include "oracle/rivals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hidden_effects {
namespace {

constexpr std::size_t kShapesOfRival = 16;

/// Evenly spread in as many dimensions as a shape has (M. Roberts' generalised golden ratio).
Shape spread_shape(std::size_t number) {
  constexpr double kRatio = 1.0850702;  // the root of x^9 = x + 1
  Shape shape;
  double step = 1.0;
  for (double& one : shape) {
    step /= kRatio;
    const double place = 0.25 + step * static_cast<double>(number);
    one = place - std::floor(place);
  }
  return shape;
}

/// The library lets a cubic spring push away.
bool may_be_negative(const LawKind& kind, std::size_t parameter) {
  return kind.effect == "cubic_stiffness" && parameter == 0;
}

std::vector<bool> positive_parameters(const LawKind& kind) {
  std::vector<bool> positive(kind.parameters.size(), true);
  for (std::size_t n = 0; n < kShapesOfRival; ++n)
    for (const double size : {0.1, 1.0, 5.0}) {
      const std::vector<double> values = kind.at_size(size, Scales{}, spread_shape(n));
      for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] <= 0.0 || may_be_negative(kind, i)) positive[i] = false;
    }
  return positive;
}

/// What laws of dry friction have in common.
struct DryFriction {
  double level = 0.0;     ///< when sliding fast, N·m or N
  double excess = 0.0;    ///< at break-away
  double velocity = 0.0;  ///< over which the excess falls, rad/s or m/s
  double bending = 0.0;   ///< way over which it turns round, rad or m
};

std::optional<DryFriction> dry_friction(const std::string& effect, const std::vector<double>& p, const Scales& scales) {
  constexpr double kShort = 1e-5, kSlow = 0.1;  // of the motion's range and velocity
  DryFriction dry{p[0], 1e-3 * p[0], kSlow * scales.velocity, kShort * scales.position};
  if (effect == "coulomb_friction" || effect == "position_friction") return dry;
  if (effect == "directional_friction") dry.level = 0.5 * (p[0] + p[1]);
  if (effect == "hysteresis") dry.bending = p[1];
  if (effect == "stribeck_friction" || effect == "lugre_friction") dry.excess = p[1], dry.velocity = p[2];
  if (effect == "lugre_friction") dry.bending = p[0] / p[3];
  if (effect.ends_with("_friction") || effect == "hysteresis") return dry;
  return std::nullopt;
}

}  // namespace

std::vector<double> friction_limit(const PlacedLaw& rival, const PlacedLaw& law, const std::vector<double>& parameters,
                                   const Scales& scales) {
  const std::string& effect = rival.kind->effect;
  const auto viscous = [](const std::string& name) { return name == "viscous_friction" || name == "load_friction"; };
  if (law.kind->place != Place::joint || rival.element != law.element || viscous(law.kind->effect)) return {};
  const std::optional<DryFriction> dry = dry_friction(law.kind->effect, parameters, scales);
  if (!dry || rival.kind->place != Place::joint) return {};
  constexpr double kTraceable = 1e-4;  // of the range; a shorter distance makes the torque of hysteresis chatter
  const double c = dry->level;
  if (effect == "coulomb_friction") return {c};
  if (effect == "directional_friction") return {c, c};
  if (effect == "stribeck_friction") return {c, dry->excess, dry->velocity};
  if (effect == "position_friction") return {c, 1e-3 * c, 1e-3 * c, 1.0 / scales.position};
  if (effect == "hysteresis") return {c, std::max(dry->bending, kTraceable * scales.position), 0.5};
  const double stiffness = c / dry->bending;
  if (effect == "lugre_friction")
    return {c, dry->excess, dry->velocity, stiffness, 0.2 * std::sqrt(stiffness * scales.inertia)};
  return {};
}

std::vector<std::function<std::vector<double>(double size)>> like_gravity(const PlacedLaw& rival, const PlantSpec& spec,
                                                                          const Scales& scales) {
  if (rival.kind->effect != "cogging" || rival.element == kEverywhere) return {};
  if (spec.joints[static_cast<std::size_t>(rival.element)].slides) return {};
  const double wave = 0.1 * scales.force;
  return {[=](double size) {
            return std::vector{size * wave, 0.0, 1.0};
          },
          [=](double size) {
            return std::vector{0.0, size * wave, 1.0};
          }};
}

std::vector<PlacedLaw> library_laws(const PlantSpec& spec) {
  std::vector<PlacedLaw> laws;
  for (const LawKind& kind : all_laws()) {
    if (!kind.library_form) continue;
    const int elements = elements_of(spec, kind.place);
    int applies = 0;
    for (int e = 0; e < elements; ++e)
      if (kind.applies(spec, e)) laws.push_back({&kind, e}), ++applies;
    if (elements > 1 && applies == elements) laws.push_back({&kind, kEverywhere});
  }
  return laws;
}

PlacedLaw library_form(const PlacedLaw& law) { return {&law_kind(law.kind->effect), law.element}; }

Bounds bounds_of(const PlantModel& model) {
  constexpr double kFar = std::numeric_limits<double>::max(), kAlmostZero = 1e-9;
  const auto count = static_cast<Eigen::Index>(model.size());
  Bounds bounds{Eigen::VectorXd::Constant(count, -kFar), Eigen::VectorXd::Constant(count, kFar)};
  PlantSpec nominal = model.spec;
  Eigen::Index next = 0;
  for (const FreeValue& value : model.free) {
    const double unit = value.of(nominal) == 0.0 ? 1.0 : value.of(nominal);
    bounds.lower[next] = value.lower * unit;
    bounds.upper[next++] = value.upper * unit;
  }
  for (const PlacedLaw& law : model.laws)
    for (const bool positive : positive_parameters(*law.kind)) {
      if (positive) bounds.lower[next] = kAlmostZero;
      ++next;
    }
  return bounds;
}

std::vector<Shape> first_shapes(const LawKind& kind, const Scales& scales, std::size_t most) {
  std::vector<Shape> shapes;
  std::vector<std::vector<double>> known;
  for (std::size_t n = 0; n < most; ++n) {
    const std::vector<double> values = kind.at_size(1.0, scales, spread_shape(n));
    if (std::find(known.begin(), known.end(), values) != known.end()) continue;
    known.push_back(values);
    shapes.push_back(spread_shape(n));
  }
  return shapes;
}

}  // namespace hidden_effects
