#include "contacts/contact_case.h"

#include "contacts/contact_strength.h"
#include "contacts/write_contact_case.h"
#include "plant/draw.h"

namespace hidden_effects {
namespace {

constexpr double kAbsorbed = 1.05;  ///< a strength below which the base explains what is hidden
constexpr std::uint64_t kTrueValues = 1;

class ContactMaker {
 public:
  ContactMaker(const CasePlan& plan, const std::filesystem::path& folder)
      : folder_(folder), rig_(contact_rig_named(plan.rig)), base_(rig_, folder, Integration::owner, {}) {
    made_.plan = plan;
    made_.rig = &rig_;
    made_.free_value = rig_.nominal * (1.0 + rig_.spread * Draw(plan.seed, kTrueValues).between(-1.0, 1.0));
  }

  MadeContactCase run() {
    const ContactLeft floor = left_by_refitted(rig_, base_, record({}, rig_.fit_trials));
    const auto strength_with = [&](const std::vector<SizedContactLaw>& laws) {
      return strength_of(left_by_refitted(rig_, base_, record(laws, rig_.fit_trials)), floor);
    };
    if (const std::optional<ContactLaw> law = hidden_law(made_.plan))
      made_.hidden =
          SizedContactLaw{*law, value_of_strength(*law, made_.plan.strength,
                                                  [&](const SizedContactLaw& one) { return strength_with({one}); })};
    const std::vector<SizedContactLaw> laws =
        made_.hidden ? std::vector{*made_.hidden} : std::vector<SizedContactLaw>{};
    made_.trials = record(laws, rig_.fit_trials + rig_.held_out_trials);
    made_.strength = strength_with(laws);
    made_.absorbed = made_.hidden && made_.strength < kAbsorbed;
    return std::move(made_);
  }

 private:
  std::vector<ContactTrial> record(const std::vector<SizedContactLaw>& laws, int count) const {
    const ContactBench bench(rig_, folder_, laws, made_.free_value, made_.plan.noise, made_.plan.seed);
    std::vector<ContactTrial> trials;
    for (int number = 0; number < count; ++number) trials.push_back(bench.record(number));
    return trials;
  }

  std::filesystem::path folder_;
  const ContactRig& rig_;
  EngineModel base_;
  MadeContactCase made_;
};

}  // namespace

bool is_contact_case(const CasePlan& plan) { return plan.group == "contact"; }

std::optional<ContactLaw> hidden_law(const CasePlan& plan) {
  if (plan.hidden.empty()) return std::nullopt;
  return contact_rig_named(plan.rig).laws.at(static_cast<std::size_t>(plan.hidden.front().element));
}

MadeContactCase make_contact_case(const CasePlan& plan, const std::filesystem::path& folder) {
  write_contact_robot(contact_rig_named(plan.rig), folder);
  MadeContactCase made = ContactMaker(plan, folder).run();
  write_contact_case(made, folder);
  return made;
}

}  // namespace hidden_effects
