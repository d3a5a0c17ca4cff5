#include "dirty/dirty_plan.h"

#include "cases/turns.h"
#include "plant/draw.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

struct DirtySet {
  const char* name;
  std::uint64_t seed;
  int count;
  bool of_values = false;  ///< in each the main effect is a value of the robot file, and nothing small is round it
};

/// The seeds of `dirty-reporting` belong to the figures alone: no case of it is looked at while the method changes.
constexpr DirtySet kDirtySets[] = {{"dirty-tuning", 51207, 300},
                                   {"dirty-reporting", 90481, 300},
                                   {"dirty-quick", 61803, 60},
                                   {"dirty-values", 27183, 40, true}};

constexpr double kLeastStrength = 2.0, kLargestStrength = 100.0;

/// Of twenty cases four have no main effect, nine one, five two and two a gross error of the robot file.
struct Mains {
  int count;
  bool gross;
};

std::vector<Mains> all_mains() {
  std::vector<Mains> all;
  all.insert(all.end(), 4, {0, false});
  all.insert(all.end(), 9, {1, false});
  all.insert(all.end(), 5, {2, false});
  all.insert(all.end(), 2, {1, true});
  return all;
}

std::vector<DirtyPlan> plan_of(const DirtySet& set) {
  Draw draw(set.seed, 1);
  Turns<Mains> mains(set.of_values ? std::vector<Mains>{{1, true}} : all_mains(), draw);
  std::vector<DirtyPlan> plans;
  for (int k = 0; k < set.count; ++k) {
    DirtyPlan& plan = plans.emplace_back();
    plan.set = set.name;
    plan.number = k;
    plan.seed = mixed(set.seed, 1000 + static_cast<std::uint64_t>(k));
    plan.family = families()[static_cast<std::size_t>(k) % families().size()];
    const Mains& wanted = mains.next();
    Draw own(plan.seed, 1);
    plan.mains = wanted.count;
    plan.gross = wanted.gross;
    plan.strength = kLeastStrength * std::pow(kLargestStrength / kLeastStrength, own.uniform());
    plan.small = 2 + static_cast<int>(own.below(3));
    plan.misstated = static_cast<int>(own.below(3));
    if (set.of_values) plan.small = plan.misstated = 0;
  }
  return plans;
}

}  // namespace

std::string DirtyPlan::name() const {
  char text[16];
  std::snprintf(text, sizeof text, "-%04d", number);
  return set + text;
}

bool is_dirty_set(const std::string& set) {
  for (const DirtySet& one : kDirtySets)
    if (set == one.name) return true;
  return false;
}

std::vector<DirtyPlan> plan_dirty_cases(const std::string& set) {
  for (const DirtySet& one : kDirtySets)
    if (set == one.name) return plan_of(one);
  throw std::invalid_argument("no dirty set is called " + set);
}

}  // namespace hidden_effects::dirty
