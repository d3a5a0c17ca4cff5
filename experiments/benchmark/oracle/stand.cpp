#include "oracle/stand.h"

#include "oracle/kalman_whitener.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kSmallestSize = 0.02, kLargestSize = 50.0;
constexpr int kMostSizes = 3;
constexpr double kHopeless = 0.1;  ///< of the deviance an iteration: slower fits do not get to the noise

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

Candidate TrueData::truth() const { return {made_.truth, made_.truth_values, starts_, 0.0}; }

Scales TrueData::scales(const PlacedLaw& law) const {
  return scales_of(made_.truth.spec, law.kind->place, law.element, excitations_of(trials_), motions_);
}

Question TrueData::question(const Candidate& at) const {
  return {at.model, at.values, trials_, at.starts, whiten_, options_.step};
}

std::optional<Candidate> TrueData::refitted(Candidate from, double settled) const {
  FitOptions options;
  options.most_iterations = options_.most_iterations;
  options.enough = 1e-5;
  options.step = options_.step;
  options.settled = settled;
  options.hopeless = kHopeless;
  options.wants_information = false;
  Bounds bounds = bounds_of(from.model);
  options.lower = std::move(bounds.lower);
  options.upper = std::move(bounds.upper);
  PlantFit fit = fit_plant(from.model, trials_, from.values, from.starts, whiten_, options);
  if (!fit.valid) return std::nullopt;
  return Candidate{std::move(from.model), std::move(fit.values), std::move(fit.starts), fit.deviance};
}

Stand::Stand(const TrueData& data, const Candidate& at, std::size_t law) : data_(data), kept_(at) {
  auto first = static_cast<Eigen::Index>(at.model.free.size());
  for (std::size_t l = 0; l < law; ++l) first += static_cast<Eigen::Index>(at.model.laws[l].kind->parameters.size());
  const auto count = static_cast<Eigen::Index>(at.model.laws[law].kind->parameters.size());
  nuisances_ = std::make_unique<Nuisances>(Nuisances(data.question(at)).without(first, count));
  kept_.model.laws.erase(kept_.model.laws.begin() + static_cast<std::ptrdiff_t>(law));
  kept_.values.resize(at.values.size() - count);
  kept_.values << at.values.head(first), at.values.tail(at.values.size() - first - count);
  without_ = whitened_residuals(data.question(kept_));
  lacking_ = nuisances_->projected(without_);
}

Candidate Stand::with(const PlacedLaw& rival, const std::vector<double>& parameters) const {
  Candidate at = kept_;
  at.model.laws.push_back(rival);
  at.values.resize(kept_.values.size() + static_cast<Eigen::Index>(parameters.size()));
  at.values << kept_.values,
      Eigen::Map<const Eigen::VectorXd>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
  return at;
}

/// What the rival changes, projected; nothing where the plant runs away.
std::optional<Eigen::VectorXd> Stand::effect(const PlacedLaw& rival, const std::vector<double>& parameters) const {
  try {
    std::vector<Eigen::VectorXd> changes = whitened_residuals(data_.question(with(rival, parameters)));
    for (std::size_t t = 0; t < changes.size(); ++t) changes[t] = without_[t] - changes[t];
    Eigen::VectorXd projected = nuisances_->projected(changes);
    if (!projected.allFinite()) return std::nullopt;
    return projected;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// Makes the law as large as its share in what is lacking says, twice over.
void Stand::search_size(const PlacedLaw& rival, const Scales& scales, const Shape& shape,
                        std::vector<Attempt>& attempts, std::vector<Eigen::VectorXd>& effects) const {
  double size = 1.0;
  for (int i = 0; i < kMostSizes; ++i) {
    const std::vector<double> parameters = rival.kind->at_size(size, scales, shape);
    const std::optional<Eigen::VectorXd> change = effect(rival, parameters);
    double wanted = 0.1;  // smaller, where it runs away
    if (change) {
      const double own = change->squaredNorm(), share = own > 0.0 ? change->dot(lacking_) / own : kLargestSize;
      attempts.push_back({parameters, (lacking_ - *change).squaredNorm()});
      effects.push_back(*change);
      wanted = std::clamp(share, 0.1, 10.0);
    }
    const double next = std::clamp(size * wanted, kSmallestSize, kLargestSize);
    if (std::abs(std::log(next / size)) < 0.1) return;
    size = next;
  }
}

Stand::Screened Stand::screen(const PlacedLaw& rival) const {
  Screened screened;
  std::vector<Eigen::VectorXd> effects;
  const Scales scales = data_.scales(rival);
  for (const Shape& shape : first_shapes(*rival.kind, scales, data_.options().most_shapes))
    search_size(rival, scales, shape, screened.attempts, effects);
  screened.lower_estimate = lacking_.squaredNorm();
  if (effects.empty()) return screened;
  Eigen::MatrixXd columns(lacking_.size(), static_cast<Eigen::Index>(effects.size()));
  for (std::size_t i = 0; i < effects.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = effects[i];
  screened.lower_estimate -= (orthonormal(columns).transpose() * lacking_).squaredNorm();
  std::sort(screened.attempts.begin(), screened.attempts.end(),
            [](const Attempt& a, const Attempt& b) { return a.left < b.left; });
  return screened;
}

Rival Stand::judge(const PlacedLaw& law, double settled) {
  const Screened screened = screen(law);
  const OracleOptions& options = data_.options();
  Rival rival{law, screened.lower_estimate, false, true};
  best_.reset();
  if (screened.lower_estimate > std::max(options.refined_below, options.refined_share * lacking_.squaredNorm()))
    return rival;
  for (std::size_t i = 0; i < std::min(options.most_refined, screened.attempts.size()); ++i) {
    const auto fitted = data_.refitted(with(law, screened.attempts[i].parameters), settled);
    if (fitted && (!best_ || fitted->deviance < best_->deviance)) best_ = fitted;
    if (best_ && best_->deviance < settled) break;
  }
  if (!best_) return rival;
  rival.non_centrality = best_->deviance;
  rival.refined = true;
  return rival;
}

}  // namespace hidden_effects
