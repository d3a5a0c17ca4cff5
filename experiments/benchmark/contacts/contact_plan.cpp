#include "contacts/contact_plan.h"

#include "cases/turns.h"
#include "contacts/contact_rig.h"

namespace hidden_effects {
namespace {

struct ContactSet {
  const char* name;
  std::uint64_t seed;
  int count;
};

/// The seed of `reporting` belongs to the figures alone.
constexpr ContactSet kSets[] = {{"tuning", 30260, 6}, {"reporting", 87003, 60}};
constexpr int kNothing = 5;        ///< every so manyth case hides nothing
constexpr int kOtherOfHopper = 3;  ///< of the hopper, every so manyth law has a form that the library does not have
constexpr int kOther = 6;          ///< of the others, which have such forms of commands alone

/// Numbers of a rig's laws, in turns.
class LawTurns {
 public:
  LawTurns(const ContactRig& rig, Draw& draw)
      : every_(rig.name == "hopper" ? kOtherOfHopper : kOther),
        library_(numbers(rig, true), draw),
        other_(numbers(rig, false), draw) {}

  int next() { return ++turn_ % every_ == 0 ? other_.next() : library_.next(); }

 private:
  static std::vector<int> numbers(const ContactRig& rig, bool library_form) {
    std::vector<int> all;
    for (std::size_t l = 0; l < rig.laws.size(); ++l)
      if (rig.laws[l].library_form() == library_form) all.push_back(static_cast<int>(l));
    return all;
  }

  int every_, turn_ = 0;
  Turns<int> library_, other_;
};

std::vector<CasePlan> plan_set(const ContactSet& set, int first) {
  Draw draw(set.seed, 1);
  Turns<Cell> cells(all_cells(), draw);
  const std::vector<ContactRig>& rigs = contact_rigs();
  std::vector<LawTurns> laws;
  for (const ContactRig& rig : rigs) laws.emplace_back(rig, draw);
  std::vector<CasePlan> plans;
  for (int k = 0; k < set.count; ++k) {
    const std::size_t r = static_cast<std::size_t>(k) % rigs.size();
    const Cell cell = cells.next();
    CasePlan& plan = plans.emplace_back();
    plan.set = set.name;
    plan.number = first + k;
    plan.group = "contact";
    plan.rig = rigs[r].name;
    plan.noise = cell.noise;
    plan.duration = rigs[r].duration;
    plan.seed = mixed(set.seed, 1000 + static_cast<std::uint64_t>(k));
    if (k % kNothing == kNothing - 1) continue;
    plan.strength = cell.strength;
    const int law = laws[r].next();
    plan.hidden = {{rigs[r].laws[static_cast<std::size_t>(law)].name, law}};
  }
  return plans;
}

}  // namespace

std::vector<CasePlan> plan_contact_cases(const std::string& set, int first) {
  for (const ContactSet& one : kSets)
    if (set == one.name) return plan_set(one, first);
  return {};
}

std::vector<CasePlan> plan_all_cases(const std::string& set) {
  std::vector<CasePlan> plans = plan_cases(set);
  const std::vector<CasePlan> contacts = plan_contact_cases(set, static_cast<int>(plans.size()));
  plans.insert(plans.end(), contacts.begin(), contacts.end());
  return plans;
}

}  // namespace hidden_effects
