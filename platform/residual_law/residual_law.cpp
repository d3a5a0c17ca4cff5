#include "residual_law/residual_law.h"

#include "criterion/evidence.h"
#include "foundation/parallel.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kLeastShare = 0.05;
constexpr double kWorthNaming = 0.05;  ///< nats at one length, as for an effect (criterion/decision.cpp)
constexpr double kOfNoise = 1.2;       ///< mean square of whitened residuals, below which no law is looked for
constexpr double kLeastSpan = 8.0;     ///< consecutive shortest lengths: a law explains an error that persists
constexpr std::uint64_t kSeed = 1;     ///< random sign draws

struct BestLaw {
  const JointLaws* joint = nullptr;
  const FittedLaw* law = nullptr;
  double p = 1.0;

  const CandidateSet& judged() const { return law->judged; }
};

BestLaw best_law(const std::vector<std::unique_ptr<JointLaws>>& joints, const CandidateSet* candidate) {
  BestLaw best;
  double most = 0.0;
  std::vector<Eigen::VectorXd> gains;
  for (const std::unique_ptr<JointLaws>& joint : joints)
    for (const FittedLaw& law : joint->laws()) {
      if (joint->drives(law)) continue;
      gains.push_back((candidate ? *candidate : joint->plain().judged).cost.by_block() - law.judged.cost.by_block());
      const double gain = gains.back().sum();
      if (!best.law || gain > most) best = {joint.get(), &law, 1.0}, most = gain;
    }
  if (best.law) best.p = sign_probability(gains, kSeed);
  return best;
}

/// Whether the recordings are long enough to tell a force from a persistent error of the readings.
bool are_long_enough(const std::vector<Trial>& trials, double length) {
  double seconds = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out) seconds += trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0);
  return seconds >= kLeastSpan * length;
}

/// The largest mean square of all lengths and channels.
double most_left(const PredictionLadder& ladder, const LinearPrediction& linear) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(linear.products.values());
  return cost_at(ladder.layout, linear.products, none).mean_square.maxCoeff();
}

}  // namespace

ResidualLaws::ResidualLaws(const SearchResult& found, const FittedModel& beside) : found_(found), beside_(beside) {
  const SearchData& data = *found.data;
  if (data.plain().definition.structure.robot.contact.ground) return;
  const PredictionLadder& ladder = found.by_all_lengths ? data.ladder() : data.deciding();
  if (!are_long_enough(data.task().trials, ladder.lengths.front())) return;
  courses_ = joint_courses(data);
  const ModelContext context = data.bench_for(beside.model);
  LadderPredictions predictions(ladder, context.predictor(), context.space(), data.starts(),
                                changes_readings(beside.model.definition));
  linear_ = predictions.linearise(beside.fit.point);
  if (!linear_ || most_left(ladder, *linear_) < kOfNoise) return;
  joints_.resize(courses_.size());
  parallel_for(joints_.size(), data.task().work.threads, [&](std::size_t joint, int) {
    joints_[joint] = std::make_unique<JointLaws>(data, beside, ladder, *linear_, courses_[joint]);
  });
}

ResidualLaw ResidualLaws::best(const FittedModel* candidate) const {
  ResidualLaw result;
  const BestLaw best = best_law(joints_, candidate ? &candidate->judged : nullptr);
  if (!best.law) return result;
  const CandidateSet& over = candidate ? candidate->judged : best.joint->plain().judged;
  result.p = best.p;
  result.gain = gain_of(best.judged(), over);
  result.joint = best.joint->course().joint;
  result.kind = best.law->kind;
  const double of_law = std::max(0.0, result.gain.nats);
  const double of_set =
      std::max(0.0, gain_of(candidate ? candidate->judged : beside_.judged, found_.sets.front().judged).nats);
  result.share = of_law > 0.0 ? of_law / (of_set + of_law) : 0.0;
  result.is_minor = is_minor(best.judged(), over, found_.sets.front().judged, of_set + of_law);
  result.is_present = result.p < kPresent && result.gain.is_told() && result.share > kLeastShare &&
                      gain_elsewhere(best.judged(), over).is_told() && largest_gain(best.judged(), over) > kWorthNaming;
  if (!result.is_present) return result;
  result.curves = best.joint->curves();
  result.formulas = best.joint->formulas(of_law);
  return result;
}

}  // namespace lacuna
