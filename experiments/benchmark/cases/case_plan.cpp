#include "cases/case_plan.h"

#include "cases/scales_of.h"
#include "cases/turns.h"
#include "laws/law_kind.h"
#include "rigs/rig.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace hidden_effects {
namespace {

struct Group {
  const char* name;
  int count;
};

struct SetPlan {
  const char* name;
  std::uint64_t seed;
  double duration;  ///< s, of each trial
  std::vector<Group> groups;
};

/// The seeds of `reporting` belong to the figures alone: no case of it is looked at while the method changes.
const std::vector<SetPlan>& sets() {
  static const std::vector<SetPlan> all = {
      {"tuning",
       20260,
       5.0,
       {{"one_joint", 62}, {"two_joint", 20}, {"nothing", 40}, {"two_effects", 10}, {"withheld", 10}}},
      {"reporting",
       77003,
       5.0,
       {{"one_joint", 600}, {"two_joint", 200}, {"nothing", 400}, {"two_effects", 100}, {"withheld", 100}}},
      {"fixed", 4001, 2.0, {{"one_joint", 30}, {"nothing", 10}}}};
  return all;
}

constexpr double kFixedAway = 0.25;  ///< of the cases: a damping is known instead of free

std::vector<std::string> rigs_with(std::size_t joints) {
  std::vector<std::string> names;
  for (const Rig& rig : planar_rigs())
    if (joints == 0 || rig.nominal.joints.size() == joints) names.push_back(rig.name);
  return names;
}

std::vector<const LawKind*> kinds(bool library_form) {
  std::vector<const LawKind*> all;
  for (const LawKind& kind : all_laws())
    if (kind.library_form == library_form) all.push_back(&kind);
  return all;
}

/// Where a law can stand on a rig.
std::vector<int> places_of(const LawKind& kind, const PlantSpec& spec) {
  std::vector<int> elements;
  for (int e = 0; e < elements_of(spec, kind.place); ++e)
    if (kind.applies(spec, e)) elements.push_back(e);
  return elements;
}

/// A free damping that would be the hidden law under another name.
bool is_same(const LawKind& kind, int element, const PlantSpec& spec, const std::string& address) {
  const bool damps = kind.effect == "viscous_friction" || kind.effect == "linear_drag";
  return damps && address == "joint." + spec.joints[static_cast<std::size_t>(element)].name + ".damping";
}

/// Hands out the cases of a set, group by group.
class Planner {
 public:
  explicit Planner(const SetPlan& set)
      : set_(set),
        draw_(set.seed, 1),
        cells_(all_cells(), draw_),
        library_(kinds(true), draw_),
        other_(kinds(false), draw_),
        one_joint_(rigs_with(1), draw_),
        two_joint_(rigs_with(2), draw_),
        any_(rigs_with(0), draw_),
        short_(std::none_of(set.groups.begin(), set.groups.end(),
                            [](const Group& group) { return std::string(group.name) == "two_joint"; })) {}

  std::vector<CasePlan> all() {
    std::vector<CasePlan> plans;
    for (const Group& group : set_.groups)
      for (int k = 0; k < group.count; ++k) plans.push_back(next(group.name, static_cast<int>(plans.size())));
    return plans;
  }

 private:
  CasePlan next(const std::string& group, int number) {
    CasePlan plan;
    plan.set = set_.name;
    plan.number = number;
    plan.group = group;
    plan.duration = set_.duration;
    plan.seed = mixed(set_.seed, 1000 + static_cast<std::uint64_t>(number));
    const Cell cell = cells_.next();
    plan.noise = cell.noise;
    if (group == "nothing") {
      plan.rig = (short_ ? one_joint_ : any_).next();
    } else {
      plan.strength = cell.strength;
      hide_one(plan);
      if (group == "two_effects") hide_another(plan);
    }
    choose_known(plan);
    return plan;
  }

  std::string next_rig(const std::string& group) {
    if (group == "one_joint") return one_joint_.next();
    return group == "two_joint" ? two_joint_.next() : any_.next();
  }

  /// Every third law has a form that the library does not have.
  void hide_one(CasePlan& plan) {
    const LawKind& kind = *(turn_++ % 3 == 2 ? other_.next() : library_.next());
    for (int attempt = 0; attempt < 20; ++attempt) {
      plan.rig = next_rig(plan.group);
      const std::vector<int> elements = places_of(kind, rig_named(plan.rig).nominal);
      if (elements.empty()) continue;
      plan.hidden.push_back({kind.name, elements[draw_.below(elements.size())]});
      return;
    }
    throw std::logic_error("no rig can hide " + kind.name);
  }

  void hide_another(CasePlan& plan) {
    const PlantSpec& spec = rig_named(plan.rig).nominal;
    for (;;) {
      const LawKind& kind = *library_.next();
      const std::vector<int> elements = places_of(kind, spec);
      if (elements.empty() || kind.effect == law_kind(plan.hidden.front().law).effect) continue;
      plan.hidden.push_back({kind.name, elements[draw_.below(elements.size())]});
      return;
    }
  }

  void choose_known(CasePlan& plan) {
    const Rig& rig = rig_named(plan.rig);
    for (const FreeValue& value : rig.free) {
      bool known = value.address.ends_with(".damping") && draw_.uniform() < kFixedAway;
      for (const HiddenLaw& hidden : plan.hidden)
        known = known || is_same(law_kind(hidden.law), hidden.element, rig.nominal, value.address);
      if (known) plan.known.push_back(value.address);
    }
  }

  const SetPlan& set_;
  Draw draw_;
  Turns<Cell> cells_;
  Turns<const LawKind*> library_, other_;
  Turns<std::string> one_joint_, two_joint_, any_;
  bool short_;  ///< a set without rigs of two joints
  int turn_ = 0;
};

}  // namespace

std::string_view to_string(NoiseLevel level) {
  switch (level) {
    case NoiseLevel::white: return "white";
    case NoiseLevel::coloured: return "coloured";
    case NoiseLevel::disturbed: break;
  }
  return "disturbed";
}

std::string CasePlan::name() const {
  char digits[16];
  std::snprintf(digits, sizeof digits, "-%04d", number);
  return set + digits;
}

std::vector<CasePlan> plan_cases(const std::string& set) {
  for (const SetPlan& one : sets())
    if (set == one.name) return Planner(one).all();
  throw std::invalid_argument("no set of cases is called " + set + "; there are tuning, reporting and fixed");
}

}  // namespace hidden_effects
