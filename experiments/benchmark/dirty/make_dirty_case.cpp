#include "dirty/choose_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

constexpr int kAttempts = 8, kRounds = 5;
constexpr double kNeededShare = 0.22, kMostSmall = 0.13;  ///< a little inside what shares have to keep
constexpr double kMostQuiet = 0.8;                        ///< of the noise: all that a case without main effects hides

PlantSpec true_values(const DirtyRig& rig, RigDraw& draw) {
  PlantSpec spec = rig.stated;
  for (const OwnerFree& one : rig.free) one.value.in(spec) *= 1.0 + one.spread * draw.between(-1.0, 1.0);
  return spec;
}

/// One attempt at a case.
class DirtyMaker {
 public:
  DirtyMaker(const DirtyPlan& plan, int attempt)
      : draw_(plan.seed, 7000 + static_cast<std::uint64_t>(attempt)), rig_(draw_rig(plan)) {
    // Where predictions are too sensitive for any effect to come out, shorter ones may do.
    if (attempt >= kAttempts / 2) rig_.longest *= std::pow(0.7, attempt - kAttempts / 2 + 1);
    made_.plan = plan;
    made_.rig = rig_;
    if (attempt >= kAttempts / 2) made_.plan.mains = std::min(1, plan.mains);  // one rig in a hundred shows only one
    true_spec_ = true_values(rig_, draw_);
    seed_ = mixed(plan.seed, 8000 + static_cast<std::uint64_t>(attempt));
  }

  DirtyCase run() {
    SizingBench bench(rig_, true_spec_, seed_, is_quiet());
    made_.recording = draw_recording(rig_, bench.range(), bench.speed(), seed_);
    made_.recording.logs_reference = made_.plan.disturbance > 0.0;
    made_.noise = reading_noise(made_.recording, rig_, bench.speed());
    bench.set_noise(made_.noise);
    made_.effects = choose_effects(made_.plan, rig_, bench, draw_);
    settle_shares(bench);
    record_all(bench);
    return std::move(made_);
  }

 private:
  /// A case that hides nothing is quiet at all lengths of prediction.
  bool is_quiet() const { return made_.plan.mains == 0; }

  std::vector<TrueTrial> carry_out_all(const Disturbance& disturbance = {}) const {
    std::vector<TrueTrial> trials;
    for (std::size_t t = 0; t < rig_.trials.size(); ++t)
      trials.push_back(
          carry_out(rig_, made_.truth, rig_.trials[t], made_.recording.white, mixed(seed_, 40 + t), disturbance));
    return trials;
  }

  /// Of the plan's share of what the drives exert when nothing disturbs them; where none does, of what moves the
  /// joints.
  Disturbance draw_disturbance(const SizingBench& bench) {
    Disturbance disturbance{std::vector<double>(rig_.stated.joints.size(), 0.0), 0.0};
    for (std::size_t j = 0; rig_.stated.drives.empty() && j < disturbance.forces.size(); ++j)
      disturbance.forces[j] =
          made_.plan.disturbance * bench.scales({&dirty_kind("coulomb_friction"), static_cast<int>(j)}).force;
    for (std::size_t d = 0; d < rig_.stated.drives.size(); ++d) {
      double squares = 0.0, count = 0.0;
      for (const TrueTrial& trial : trials_)
        for (const double force : trial.applied.commands[d]) squares += force * force, count += 1.0;
      disturbance.forces[static_cast<std::size_t>(rig_.stated.drives[d].joint)] =
          made_.plan.disturbance * std::sqrt(squares / count);
    }
    disturbance.memory = draw_.log_between(2.0 * rig_.interval, 1.0 / rig_.rate);
    return disturbance;
  }

  /// The base with one effect taken in.
  double error_with(const OwnerError& error, std::size_t effect, const DenseData& data) const {
    const DirtyEffect& one = made_.effects[effect];
    OwnerModel model{rig_.stated, {}, {}, 1};
    if (!one.kind) {
      one.value.in(model.spec) *= one.factor;
      return error.of(model, data);
    }
    if (one.kind->law.place == Place::sensor)
      return error.of(model, clean_readings(made_.truth, trials_, one.law.get()));
    const auto at = std::find(made_.truth.laws.begin(), made_.truth.laws.end(), one.law);
    model.laws = {one.law};
    model.of_truth = {static_cast<std::size_t>(at - made_.truth.laws.begin())};
    model.finer = one.kind->finer;
    return error.of(model, data);
  }

  void measure(const SizingBench& bench) {
    made_.truth = bench.truth_with(made_.effects);
    trials_ = carry_out_all();
    const OwnerError error(rig_, made_.truth, trials_, made_.noise, {.worst = is_quiet()});
    const DenseData data = clean_readings(made_.truth, trials_);
    made_.error = error.of({rig_.stated, {}, {}, 1}, data);
    for (std::size_t i = 0; i < made_.effects.size(); ++i) {
      const double without = error_with(error, i, data);
      made_.effects[i].share = 1.0 - without * without / (made_.error * made_.error);
    }
  }

  /// Sizes are changed, small effects left out, until shares are what their roles say.
  void settle_shares(const SizingBench& bench) {
    for (int round = 0;; ++round) {
      measure(bench);
      const bool last = round + 1 >= kRounds;
      if (!change_sizes(bench, last)) return;
      if (round > kRounds + 6) throw std::runtime_error("the shares do not come out");
    }
  }

  /// False where nothing has to be changed.
  bool change_sizes(const SizingBench& bench, bool drop) {
    if (is_quiet()) return quieten(bench, drop);
    const bool one_is_weak = std::any_of(made_.effects.begin(), made_.effects.end(), [](const DirtyEffect& one) {
      return one.role == Role::main && one.share < kNeededShare;
    });
    bool changed = one_is_weak;
    std::vector<DirtyEffect> kept;
    for (DirtyEffect& one : made_.effects) {
      if (one.role == Role::main) {
        if (one_is_weak && (drop || !one.kind)) throw std::runtime_error("a main effect explains too little");
        kept.push_back(one_is_weak ? resized(bench, one, one.share < kNeededShare ? 1.4 : 0.7) : one);
        continue;
      }
      const bool loud = one.share > kMostSmall;
      changed = changed || loud;
      if (loud && drop) continue;
      kept.push_back(loud ? resized(bench, one, 0.5) : one);
    }
    made_.effects = std::move(kept);
    if (!changed && made_.error < kLeastMain) throw std::runtime_error("the main effects hide each other");
    return changed;
  }

  bool quieten(const SizingBench& bench, bool drop) {
    if (made_.error < kMostQuiet) return false;
    if (made_.effects.empty()) throw std::runtime_error("the rig without effects is off");
    if (drop) {
      made_.effects.pop_back();
      return true;
    }
    for (DirtyEffect& one : made_.effects) one = resized(bench, one, 0.6);
    return true;
  }

  DirtyEffect resized(const SizingBench& bench, const DirtyEffect& one, double times) const {
    DirtyEffect changed = one;
    if (one.kind) {
      changed = bench.sized({one.kind, one.element}, one.shape, std::min(one.size * times, one.kind->most_size));
      changed.role = one.role;
    } else {
      const double off = std::max(0.01, times * std::abs(one.factor - 1.0));
      changed.factor = 1.0 + std::copysign(off, one.factor - 1.0);
    }
    return changed;
  }

  /// Shares are those of the undisturbed trials; what is recorded may be disturbed.
  void record_all(const SizingBench& bench) {
    if (made_.plan.disturbance > 0.0) trials_ = carry_out_all(draw_disturbance(bench));
    for (std::size_t t = 0; t < trials_.size(); ++t)
      made_.recorded.push_back(
          record(rig_, made_.truth, trials_[t], rig_.trials[t], made_.recording, mixed(seed_, 60 + t)));
  }

  RigDraw draw_;
  DirtyRig rig_;
  DirtyCase made_;
  PlantSpec true_spec_;
  std::uint64_t seed_ = 0;
  std::vector<TrueTrial> trials_;
};

}  // namespace

DirtyCase make_dirty_case(const DirtyPlan& plan) {
  std::string reason;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    try {
      return DirtyMaker(plan, attempt).run();
    } catch (const std::runtime_error& error) {
      reason = error.what();
    }
  }
  throw std::runtime_error(fmt::format("{} cannot be made: {}", plan.name(), reason));
}

}  // namespace hidden_effects::dirty
