#include "dirty/choose_effects.h"

#include "cases/scales_of.h"
#include "cases/turns.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

constexpr int kMostCandidates = 14;

/// Picks an item with a chance in proportion to its weight, and takes it out.
PlacedKind take_by_weight(std::vector<PlacedKind>& from, RigDraw& draw) {
  // A kind that has many places is no likelier for that.
  std::vector<double> weights;
  double sum = 0.0;
  for (const PlacedKind& one : from) {
    const auto places =
        std::count_if(from.begin(), from.end(), [&](const PlacedKind& o) { return o.kind == one.kind; });
    weights.push_back(one.kind->weight / static_cast<double>(places));
    sum += weights.back();
  }
  double left = sum * draw.uniform();
  std::size_t k = 0;
  while (k + 1 < from.size() && (left -= weights[k]) > 0.0) ++k;
  const PlacedKind taken = from[k];
  from.erase(from.begin() + static_cast<std::ptrdiff_t>(k));
  return taken;
}

Shape draw_shape(RigDraw& draw) {
  Shape shape;
  for (double& number : shape) number = draw.uniform();
  return shape;
}

/// Draws the effects of a case one after the other.
class EffectChooser {
 public:
  EffectChooser(const DirtyPlan& plan, const DirtyRig& rig, const SizingBench& bench, RigDraw& draw)
      : plan_(plan), rig_(rig), bench_(bench), draw_(draw) {}

  std::vector<DirtyEffect> run() {
    choose_mains();
    choose_misstated();
    choose_small();
    return std::move(effects_);
  }

 private:
  bool is_quiet() const { return plan_.mains == 0; }

  std::vector<std::string> accepted_by(const PlacedKind& placed) const {
    return accepted_at(placed.kind->accepted, rig_.stated,
                       joint_of(rig_.stated, placed.kind->law.place, placed.element));
  }

  /// Whether one of these names names an effect that is there already.
  bool has(const std::vector<std::string>& names) const {
    return std::any_of(effects_.begin(), effects_.end(), [&](const DirtyEffect& one) {
      const std::vector<std::string> there = one.accepted(rig_.stated);
      return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return std::find(there.begin(), there.end(), name) != there.end();
      });
    });
  }

  void choose_mains() {
    if (is_quiet()) {
      main_error_ = 0.0;
      return;
    }
    if (!plan_.gross || !choose_gross()) {
      if (plan_.must_be_gross) throw std::runtime_error("no value of the robot file shows");
      choose_laws();
    }
    main_error_ = bench_.error(effects_);
    if (!(main_error_ >= kLeastMain) || main_error_ > 1e4) throw std::runtime_error("no main effect comes out");
  }

  bool choose_gross() {
    std::vector<DirtyEffect> tries;
    for (const RobotValue& value : rig_.fixed)
      for (const double factor : {0.5, 2.0, 6.0}) {
        DirtyEffect wrong;
        wrong.value = value;
        wrong.factor = factor;
        tries.push_back(wrong);
      }
    shuffle(tries, draw_);
    if (tries.size() > 10) tries.resize(10);
    for (const DirtyEffect& wrong : tries) {
      const double error = bench_.error({wrong});
      if (error < kLeastMain || error > 3000.0) continue;
      effects_ = {wrong};
      return true;
    }
    return false;
  }

  /// A law that was tried as a main effect, and what it leaves of the owner's error.
  struct TriedLaw {
    DirtyEffect effect;
    double reached = 0.0;
  };

  /// Laws that reach the strength; where too few do, those that come nearest to it.
  void choose_laws() {
    std::vector<PlacedKind> candidates = placed_kinds(rig_);
    if (plan_.must_be_force)
      std::erase_if(candidates, [](const PlacedKind& one) { return goes_with(*one.kind).empty(); });
    std::vector<TriedLaw> spare;
    const double part = plan_.mains == 2 ? draw_.between(0.35, 0.65) : 1.0;
    const int most = rig_.stated.joints.size() > 3 ? kMostCandidates / 2 : kMostCandidates;
    for (int tries = 0; tries < most && !candidates.empty() && lacks_mains(); ++tries) {
      const PlacedKind placed = take_by_weight(candidates, draw_);
      const Shape shape = draw_shape(draw_);
      if (has(accepted_by(placed))) continue;
      const double share = effects_.empty() ? part : 1.0 - part;
      const double aim = std::sqrt(share) * (effects_.empty() ? plan_.strength : first_error_ / std::sqrt(part));
      TriedLaw tried;
      tried.effect = sized_for(bench_, placed, shape, aim, kLeastMain * std::sqrt(share), tried.reached);
      if (!(tried.reached >= kLeastMain * std::sqrt(share)) || tried.reached > 2.0 * aim) continue;
      if (tried.reached >= 0.6 * aim)
        take_main(tried);
      else
        spare.push_back(std::move(tried));
    }
    std::sort(spare.begin(), spare.end(), [](const TriedLaw& a, const TriedLaw& b) { return a.reached > b.reached; });
    for (const TriedLaw& one : spare)
      if (lacks_mains() && !has(one.effect.accepted(rig_.stated)) && one.reached >= 0.6 * first_error_) take_main(one);
    if (lacks_mains()) throw std::runtime_error("no law comes out at its strength");
  }

  bool lacks_mains() const { return static_cast<int>(effects_.size()) < plan_.mains; }

  void take_main(const TriedLaw& tried) {
    if (effects_.empty()) first_error_ = tried.reached;
    effects_.push_back(tried.effect);
  }

  /// What a small effect may leave at most: an eighth of the main ones' error, or a part of the noise.
  double quiet() const { return is_quiet() ? 0.35 : 0.1 * main_error_; }

  void choose_misstated() {
    std::vector<RobotValue> values = rig_.fixed;
    shuffle(values, draw_);
    int left = plan_.misstated;
    for (const RobotValue& value : values) {
      if (left == 0) return;
      if (std::any_of(effects_.begin(), effects_.end(),
                      [&](const DirtyEffect& one) { return !one.kind && one.value == value; }))
        continue;
      DirtyEffect wrong;
      wrong.role = Role::misstated;
      wrong.value = value;
      double off = draw_.log_between(0.01, 0.1);
      const double sign = draw_.sign();
      wrong.factor = 1.0 + sign * off;
      const double error = bench_.error({wrong});
      if (error > quiet()) {
        off *= 0.8 * quiet() / error;
        if (off < 0.01) continue;
        wrong.factor = 1.0 + sign * off;
      }
      effects_.push_back(wrong);
      --left;
    }
  }

  void choose_small() {
    std::vector<PlacedKind> laws, readings;
    for (const PlacedKind& one : placed_kinds(rig_)) {
      const std::string& name = one.kind->law.name;
      if (one.kind->finer > 1 || name == "hard_stop" || name == "torque_saturation") continue;
      (one.kind->reading ? readings : laws).push_back(one);
    }
    add_small(laws, plan_.small, Role::small);
    if (plan_.small > 0 && draw_.chance(0.5)) add_small(readings, 1, Role::reading);
  }

  void add_small(std::vector<PlacedKind>& from, int wanted, Role role) {
    for (int tries = 0; tries < 10 && wanted > 0 && !from.empty(); ++tries) {
      const PlacedKind placed = take_by_weight(from, draw_);
      const double aim = draw_.log_between(0.12, 1.0) * quiet();
      if (has(accepted_by(placed))) continue;
      DirtyEffect effect = one_small(placed, aim);
      if (!effect.kind) continue;
      effect.role = role;
      effects_.push_back(std::move(effect));
      --wanted;
    }
  }

  /// A law that leaves about `aim`, found in two steps since small errors grow in proportion; none where that fails.
  DirtyEffect one_small(const PlacedKind& placed, double aim) {
    const Shape shape = draw_shape(draw_);
    double size = 0.3;
    for (int step = 0; step < 4; ++step) {
      DirtyEffect effect = bench_.sized(placed, shape, size);
      const double error = bench_.error({effect});
      const double floor = 0.011;  // where the error ends in numerical ones
      if (error < 1.6 * aim && error > 0.6 * aim && error < 1.05 * quiet()) return effect;
      if (error < floor && aim > 3.0 * floor && step > 0) return {};
      size *= std::clamp(aim / std::max(error, floor), 0.02, 20.0);
      if (size > 4.0 || size < 1e-7) return {};
    }
    return {};
  }

  const DirtyPlan& plan_;
  const DirtyRig& rig_;
  const SizingBench& bench_;
  RigDraw& draw_;
  std::vector<DirtyEffect> effects_;
  double main_error_ = 0.0, first_error_ = 0.0;
};

}  // namespace

std::vector<DirtyEffect> choose_effects(const DirtyPlan& plan, const DirtyRig& rig, const SizingBench& bench,
                                        RigDraw& draw) {
  return EffectChooser(plan, rig, bench, draw).run();
}

}  // namespace hidden_effects::dirty
