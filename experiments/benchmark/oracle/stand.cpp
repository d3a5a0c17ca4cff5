#include "oracle/stand.h"

#include "oracle/kalman_whitener.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kSmallestSize = 0.02, kLargestSize = 50.0;
constexpr double kLeastFactor = 0.1, kMostFactor = 10.0;  ///< from one size to the next
constexpr int kMostSizes = 3;

Start start_at_rest(const PlantSpec& spec) {
  const auto joints = static_cast<Eigen::Index>(spec.joints.size());
  return {Coordinates::Zero(joints), Coordinates::Zero(joints)};
}

std::vector<Excitation> excitations_of(const std::vector<FittedTrial>& trials) {
  std::vector<Excitation> all;
  for (const FittedTrial& trial : trials) all.push_back(trial.excitation);
  return all;
}

}  // namespace

TrueData::TrueData(const MadeCase& made, const OracleOptions& options) : made_(made), options_(options) {
  const Start start = start_at_rest(made.truth.spec);
  const Laws laws = made.truth.laws_at(made.truth_values);
  std::vector<TrueTrial> true_trials;
  for (const MadeTrial& trial : made.trials) {
    if (trial.held_out) continue;
    FittedTrial data = trial.noise_free();
    Simulation plant(made.truth.spec_at(made.truth_values), laws, data.excitation, options.step);
    motions_.push_back(simulate(plant, start, data.excitation.samples(), 1));
    data.readings = read_sensors(plant.spec(), laws, motions_.back());
    true_trials.push_back({data.excitation, start});
    trials_.push_back(std::move(data));
    starts_.push_back(start);
  }
  whiten_ = kalman_whitener(made.truth, made.truth_values, true_trials, made.noise, options.step);
}

Explanation TrueData::truth() const {
  Explanation at{made_.truth, made_.truth_values, starts_, 0.0};
  const auto frees = static_cast<Eigen::Index>(at.model.free.size());
  const double interval = trials_.front().excitation.interval;
  at.model.free.push_back(
      {kTiming, 0.0, -interval, interval, [](PlantSpec& spec) -> double& { return spec.lateness; }});
  at.values.resize(made_.truth_values.size() + 1);
  at.values << made_.truth_values.head(frees), 0.0, made_.truth_values.tail(made_.truth_values.size() - frees);
  return at;
}

Scales TrueData::scales(const PlacedLaw& law) const {
  return scales_of(made_.truth.spec, law.kind->place, law.element, excitations_of(trials_), motions_);
}

Question TrueData::question(const Explanation& at) const {
  return {at.model, at.values, trials_, at.starts, whiten_, options_.step};
}

std::optional<Explanation> TrueData::refitted(Explanation from, double settled, double hopeless) const {
  FitOptions options;
  options.most_iterations = options_.most_iterations;
  options.enough = 1e-5;
  options.step = options_.step;
  options.settled = settled;
  options.hopeless = hopeless;
  options.wants_information = false;
  Bounds bounds = bounds_of(from.model);
  options.lower = std::move(bounds.lower);
  options.upper = std::move(bounds.upper);
  PlantFit fit = fit_plant(from.model, trials_, from.values, from.starts, whiten_, options);
  if (!fit.valid) return std::nullopt;
  return Explanation{std::move(from.model), std::move(fit.values), std::move(fit.starts), fit.deviance};
}

Footing::Footing(const TrueData& data, Explanation kept, Nuisances nuisances)
    : data_(data),
      kept_(std::move(kept)),
      nuisances_(std::move(nuisances)),
      without_(whitened_residuals(data.question(kept_))),
      lacking_(nuisances_.projected(without_)) {}

Explanation Footing::with(const PlacedLaw& rival, const std::vector<double>& parameters) const {
  Explanation at = kept_;
  at.model.laws.push_back(rival);
  at.values.resize(kept_.values.size() + static_cast<Eigen::Index>(parameters.size()));
  at.values << kept_.values,
      Eigen::Map<const Eigen::VectorXd>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
  return at;
}

std::optional<Eigen::VectorXd> Footing::effect(const PlacedLaw& rival, const std::vector<double>& parameters) const {
  try {
    const Explanation changed = with(rival, parameters);
    std::vector<Eigen::VectorXd> changes = whitened_residuals(data_.question(changed));
    for (std::size_t t = 0; t < changes.size(); ++t) changes[t] = without_[t] - changes[t];
    Eigen::VectorXd projected = nuisances_.projected(changes);
    if (!projected.allFinite()) return std::nullopt;
    return projected;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

Stand::Stand(const TrueData& data, const Explanation& at, std::size_t law) : data_(data) {
  auto first = static_cast<Eigen::Index>(at.model.free.size());
  for (std::size_t l = 0; l < law; ++l) first += static_cast<Eigen::Index>(at.model.laws[l].kind->parameters.size());
  const auto count = static_cast<Eigen::Index>(at.model.laws[law].kind->parameters.size());
  taken_ = at.model.laws[law];
  taken_parameters_.assign(at.values.data() + first, at.values.data() + first + count);
  Explanation kept = at;
  kept.model.laws.erase(kept.model.laws.begin() + static_cast<std::ptrdiff_t>(law));
  kept.values.resize(at.values.size() - count);
  kept.values << at.values.head(first), at.values.tail(at.values.size() - first - count);
  footings_.emplace_back(data, kept, Nuisances(data.question(at)).without(first, count));
  without_ = data.refitted(kept, 0.0, 0.01);
  if (without_) footings_.emplace_back(data, *without_, Nuisances(data.question(*without_)));
}

namespace {

/// Sizes of a law such that it explains as much as it can of what is lacking: its own size times its share in that,
/// over and over.
class OracleSizes {
 public:
  OracleSizes(const Footing& footing, const PlacedLaw& rival, const Scales& scales)
      : footing_(footing), rival_(rival), scales_(scales) {}

  struct Found {
    std::vector<double> parameters;
    double left = 0.0;
  };

  /// The best size of a shape; nothing where the plant always runs away.
  std::optional<Found> run(const Shape& shape) {
    return run([&](double size) { return rival_.kind->at_size(size, scales_, shape); });
  }

  std::optional<Found> run(const std::function<std::vector<double>(double)>& at_size) {
    std::optional<Found> best;
    double size = 1.0;
    for (int i = 0; i < kMostSizes; ++i) {
      const std::vector<double> parameters = at_size(size);
      double factor = kLeastFactor;
      if (const auto found = attempt(parameters)) {
        if (!best || found->left < best->left) best = found;
        factor = factor_of(effects.back());
      }
      const double next = std::clamp(size * factor, kSmallestSize, kLargestSize);
      if (std::abs(std::log(next / size)) < 0.1) break;
      size = next;
    }
    return best;
  }

  std::optional<Found> attempt(const std::vector<double>& parameters) {
    const std::optional<Eigen::VectorXd> change = footing_.effect(rival_, parameters);
    if (!change) return std::nullopt;
    effects.push_back(*change);
    return Found{parameters, (footing_.lacking() - *change).squaredNorm()};
  }

  std::vector<Eigen::VectorXd> effects;  ///< of all that was tried

 private:
  /// How many times larger it should be.
  double factor_of(const Eigen::VectorXd& change) const {
    const double own = change.squaredNorm();
    return own > 0.0 ? std::clamp(change.dot(footing_.lacking()) / own, kLeastFactor, kMostFactor) : kMostFactor;
  }

  const Footing& footing_;
  const PlacedLaw& rival_;
  const Scales& scales_;
};

/// What is left of `lacking` by all effects together, each of any size.
double left_by_all(const Eigen::VectorXd& lacking, const std::vector<Eigen::VectorXd>& effects) {
  if (effects.empty()) return lacking.squaredNorm();
  Eigen::MatrixXd columns(lacking.size(), static_cast<Eigen::Index>(effects.size()));
  for (std::size_t i = 0; i < effects.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = effects[i];
  return lacking.squaredNorm() - (orthonormal(columns).transpose() * lacking).squaredNorm();
}

}  // namespace

Stand::Screened Stand::screen(const PlacedLaw& rival) const {
  Screened screened{{}, std::numeric_limits<double>::infinity()};
  const Scales scales = data_.scales(rival);
  const bool elsewhere = rival.kind == taken_.kind;
  const std::vector<double> limit =
      elsewhere ? taken_parameters_ : friction_limit(rival, taken_, taken_parameters_, scales);
  for (const Footing& footing : footings_) {
    OracleSizes search(footing, rival, scales);
    const auto keep = [&](const std::optional<OracleSizes::Found>& found) {
      if (found) screened.attempts.push_back({footing.with(rival, found->parameters), found->left});
    };
    for (const Shape& shape : first_shapes(*rival.kind, scales, data_.options().most_shapes)) keep(search.run(shape));
    for (const auto& at_size : like_gravity(rival, data_.spec(), scales)) keep(search.run(at_size));
    if (!limit.empty()) keep(search.attempt(limit));
    screened.lower_estimate = std::min(screened.lower_estimate, left_by_all(footing.lacking(), search.effects));
  }
  std::sort(screened.attempts.begin(), screened.attempts.end(),
            [](const Attempt& a, const Attempt& b) { return a.left < b.left; });
  return screened;
}

std::vector<Stand::Attempt> Stand::known_attempts(const PlacedLaw& rival) const {
  std::vector<Attempt> attempts;
  const Scales scales = data_.scales(rival);
  for (const Footing& footing : footings_) {
    OracleSizes search(footing, rival, scales);
    std::optional<OracleSizes::Found> best;
    for (const KnownStart& known : data_.options().known) {
      if (known.law != rival) continue;
      const auto found = search.attempt(known.parameters);
      if (found && (!best || found->left < best->left)) best = found;
    }
    if (best) attempts.push_back({footing.with(rival, best->parameters), best->left});
  }
  return attempts;
}

std::vector<Stand::Attempt> Stand::foremost(Screened screened) const {
  if (screened.attempts.size() > data_.options().most_refined)
    screened.attempts.resize(data_.options().most_refined, screened.attempts.front());
  return std::move(screened.attempts);
}

std::optional<Explanation> Stand::refine(const std::vector<Attempt>& attempts, double settled, double hopeless) const {
  std::optional<Explanation> best;
  for (const Attempt& attempt : attempts) {
    auto fitted = data_.refitted(attempt.from, settled, hopeless);
    if (fitted && (!best || fitted->deviance < best->deviance)) best = std::move(fitted);
    if (best && best->deviance < settled) break;
  }
  return best;
}

std::optional<Explanation> Stand::best(const PlacedLaw& law) const { return refine(foremost(screen(law)), 0.0, 0.0); }

Rival Stand::judge(const PlacedLaw& law, double reference) const {
  const OracleOptions& options = data_.options();
  Screened screened = screen(law);
  Rival rival{law, screened.lower_estimate, false, true};
  const double base = footings_.back().lacking().squaredNorm();
  const double told = reference + kToldApart;
  std::vector<Attempt> attempts = known_attempts(law);
  const double hopeless = attempts.empty() ? options.hopeless : 0.0;
  if (screened.lower_estimate <= std::max(reference + options.refined_below, options.refined_share * base))
    for (Attempt& own : foremost(std::move(screened))) attempts.push_back(std::move(own));
  const auto fitted = refine(attempts, told, hopeless);
  if (!fitted) return rival;
  rival.non_centrality = fitted->deviance;
  rival.told_apart = fitted->deviance >= told;
  rival.refined = true;
  return rival;
}

}  // namespace hidden_effects
