#include "residual_law/joint_laws.h"

#include "foundation/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

constexpr std::array kRidges = {0.001, 0.01, 0.1, 1.0};
constexpr double kTermRidge = 1e-6;
constexpr std::size_t kMostTerms = 3;
constexpr double kWorthATerm = 0.1;                ///< of the law's gain
constexpr std::array kSlices = {0.03, 0.5, 0.97};  ///< of the positions, at which the force is drawn over velocity ...
constexpr double kDriving = 0.1;                   ///< correlation of a force with the velocity
constexpr int kSliceKnots = 9;                     ///< ... at so many velocities
constexpr double kNear = 0.1, kSeen = 0.05;        ///< of the range of positions; of the velocities there
constexpr const char* kMotion = "position and velocity";
constexpr const char* kWhole = "position, velocity, command, time and the past of the motion";

std::vector<std::size_t> numbers(std::size_t first, std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), first);
  return all;
}

bool is_of_motion(const LawFamily& family) {
  return family.kind.starts_with("position") || family.kind.starts_with("velocity");
}

double quantile(std::vector<double> values, double share) { return quantile_of(values, share); }

/// The points at which the curve of a family of one quantity is evaluated.
std::vector<JointMoment> moments_at(const LawFamily& family) {
  std::vector<JointMoment> moments(family.places.size());
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i].*family.of = family.places[i];
  return moments;
}

/// The law with the additional term that lowers its cost most.
std::optional<FittedLaw> longer_by_one(const LawContext& context, const FittedLaw& law, std::size_t terms) {
  std::optional<FittedLaw> best;
  for (std::size_t term = 0; term < terms; ++term) {
    if (std::find(law.functions.begin(), law.functions.end(), term) != law.functions.end()) continue;
    std::vector<std::size_t> functions = law.functions;
    functions.push_back(term);
    FittedLaw longer = context.fit("", functions, kTermRidge);
    if (!best || longer.judged.cost.cost < best->judged.cost.cost) best = std::move(longer);
  }
  return best;
}

}  // namespace

Gain in_nats(const CostGain& gain) {
  constexpr double kBeyond = kWithin95;  // standard errors
  return {gain.nats, gain.error, gain.nats - kBeyond * gain.error, gain.nats + kBeyond * gain.error};
}

JointLaws::JointLaws(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder,
                     const LinearPrediction& linear, const JointCourse& course)
    : ladder_(ladder),
      linear_(linear),
      model_(model),
      course_(course),
      pulses_(force_pulses(data, model, ladder, course)) {
  if (pulses_.responses.empty()) return;
  families_ = law_families(course);
  for (const LawFamily& family : families_) {
    functions_.insert(functions_.end(), family.functions.begin(), family.functions.end());
    is_of_velocity_.resize(functions_.size(), family.follows_velocity ? 1 : 0);
  }
  context_.emplace(ladder_, linear_, model_.fit.bounds, course_, pulses_, functions_);
  plain_ = context_->fit("", {}, 0.0);
  std::vector<std::size_t> of_motion;
  std::size_t first = 0;
  for (const LawFamily& family : families_) {
    const std::vector<std::size_t> own = numbers(first, family.functions.size());
    add(family.kind, own);
    if (is_of_motion(family)) of_motion.insert(of_motion.end(), own.begin(), own.end());
    first += family.functions.size();
  }
  add(kMotion, of_motion);
  add(kWhole, numbers(0, first));
}

void JointLaws::add(const std::string& kind, const std::vector<std::size_t>& functions) {
  for (FittedLaw& law : context_->fits(kind, functions, kRidges)) laws_.push_back(std::move(law));
}

const FittedLaw& JointLaws::best_of(const std::string& kind) const {
  return *std::min_element(laws_.begin(), laws_.end(), [&](const FittedLaw& a, const FittedLaw& b) {
    if ((a.kind == kind) != (b.kind == kind)) return a.kind == kind;
    return a.judged.cost.cost < b.judged.cost.cost;
  });
}

bool JointLaws::drives(const FittedLaw& law) const {
  const Eigen::VectorXd sizes = context_->sizes(law);
  double power = 0.0, force_squares = 0.0, velocity_squares = 0.0;
  for (const std::vector<JointMoment>& moments : course_.trials)
    for (const JointMoment& moment : moments) {
      double force = 0.0;
      for (std::size_t f = 0; f < law.functions.size(); ++f)
        if (is_of_velocity_[law.functions[f]])
          force += sizes(static_cast<Eigen::Index>(f)) * functions_[law.functions[f]](moment);
      power += force * moment.velocity;
      force_squares += force * force;
      velocity_squares += moment.velocity * moment.velocity;
    }
  return power > kDriving * std::sqrt(force_squares * velocity_squares);
}

std::vector<ForceCurve> JointLaws::curves() const {
  std::vector<ForceCurve> all;
  for (const LawFamily& family : families_)
    if (const FittedLaw& law = best_of(family.kind); family.of && gain(law).is_told())
      all.push_back(curve_over(family, law));
  const FittedLaw& motion = best_of(kMotion);
  if (!gain(motion).is_told()) return all;
  const std::vector<double> positions = course_.all(&JointMoment::position);
  for (const double share : kSlices)
    if (std::optional<ForceCurve> slice = slice_at(quantile(positions, share), motion))
      all.push_back(std::move(*slice));
  return all;
}

std::vector<ForceCurve> JointLaws::curves_beside(const LinearPrediction& part) const {
  std::vector<ForceCurve> all;
  if (!context_) return all;
  const LawContext other(ladder_, part, model_.fit.bounds, course_, pulses_, functions_);
  for (const LawFamily& family : families_) {
    const FittedLaw& law = best_of(family.kind);
    if (!family.of || !gain(law).is_told()) continue;
    all.push_back(curve_over(family, law));
    const Eigen::VectorXd sizes = other.sizes(other.fit(law.kind, law.functions, law.ridge));
    for (const JointMoment& moment : moments_at(family))
      all.back().by_answer.push_back(functions_at(law, moment).dot(sizes));
  }
  return all;
}

Eigen::VectorXd JointLaws::functions_at(const FittedLaw& law, const JointMoment& moment) const {
  Eigen::VectorXd at(static_cast<Eigen::Index>(law.functions.size()));
  for (std::size_t f = 0; f < law.functions.size(); ++f)
    at(static_cast<Eigen::Index>(f)) = functions_[law.functions[f]](moment);
  return at;
}

void JointLaws::trace(const FittedLaw& law, const std::vector<JointMoment>& moments, ForceCurve& curve) const {
  const Eigen::VectorXd sizes = context_->sizes(law);
  const Eigen::MatrixXd covariance = context_->covariance(law);
  for (const JointMoment& moment : moments) {
    const Eigen::VectorXd at = functions_at(law, moment);
    curve.force.push_back(at.dot(sizes));
    curve.standard_error.push_back(std::sqrt(std::max(0.0, at.dot(covariance * at))));
  }
}

ForceCurve JointLaws::curve_over(const LawFamily& family, const FittedLaw& law) const {
  ForceCurve curve{course_.joint, family.quantity, family.unit, course_.force_unit, family.places, {}, {}};
  trace(law, moments_at(family), curve);
  return curve;
}

/// The force over velocity, as far as the joint reached such velocities near that position.
std::optional<ForceCurve> JointLaws::slice_at(double position, const FittedLaw& law) const {
  const std::vector<double> positions = course_.all(&JointMoment::position),
                            velocities = course_.all(&JointMoment::velocity);
  const double near = kNear * (quantile(positions, 1.0) - quantile(positions, 0.0));
  std::vector<double> seen;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (std::abs(positions[i] - position) <= near) seen.push_back(velocities[i]);
  const double low = quantile(seen, kSeen), high = quantile(seen, 1.0 - kSeen);
  if (!(low < high)) return std::nullopt;
  ForceCurve slice{course_.joint, "velocity", course_.position_unit + "/s", course_.force_unit, {}, {}, {}, position};
  std::vector<JointMoment> moments;
  for (int i = 0; i < kSliceKnots; ++i) {
    moments.push_back(
        {.position = position, .velocity = std::lerp(low, high, static_cast<double>(i) / (kSliceKnots - 1))});
    slice.at.push_back(moments.back().velocity);
  }
  trace(law, moments, slice);
  return slice;
}

std::vector<ForceFormula> JointLaws::formulas(double whole_gain) const {
  const std::vector<ForceTerm> terms = force_terms(course_);
  LawContext::Functions functions;
  for (const ForceTerm& term : terms) functions.push_back(term.of);
  const LawContext context(ladder_, linear_, model_.fit.bounds, course_, pulses_, functions);
  FittedLaw law = context.fit("", {}, kTermRidge);
  while (law.functions.size() < kMostTerms) {
    std::optional<FittedLaw> longer = longer_by_one(context, law, terms.size());
    if (!longer) break;
    const CostGain more = gain_of(longer->judged, law.judged);
    if (!more.is_told() || more.nats < kWorthATerm * whole_gain) break;
    law = std::move(*longer);
  }
  if (law.functions.empty()) return {};
  return {formula_of(context, law, terms)};
}

ForceFormula JointLaws::formula_of(const LawContext& context, const FittedLaw& law,
                                   const std::vector<ForceTerm>& terms) const {
  ForceFormula formula{course_.joint, course_.force_unit, {}, in_nats(gain(law))};
  const Eigen::VectorXd sizes = context.sizes(law);
  const Eigen::VectorXd errors = context.covariance(law).diagonal().cwiseMax(0.0).cwiseSqrt();
  for (std::size_t i = 0; i < law.functions.size(); ++i) {
    const ForceTerm& term = terms[law.functions[i]];
    const auto at = static_cast<Eigen::Index>(i);
    formula.terms.push_back({term.text, term.unit, sizes(at), errors(at)});
  }
  return formula;
}

}  // namespace lacuna
