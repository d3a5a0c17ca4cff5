#include "contacts/contact_rig.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {

double ContactLaw::at_size(double size) const {
  switch (rule) {
    case SizeRule::grows: return std::min(most, unit * size);
    case SizeRule::yields: return std::min(most, unit / size);
    case SizeRule::fades: break;
  }
  return std::exp(-unit * size);
}

int ContactRig::samples() const { return static_cast<int>(std::lround(duration / interval)) + 1; }

const std::vector<ContactRig>& contact_rigs() {
  static const std::vector<ContactRig> all = {wheeled_base(), hopper(), quadruped()};
  return all;
}

const ContactRig& contact_rig_named(const std::string& name) {
  for (const ContactRig& rig : contact_rigs())
    if (rig.name == name) return rig;
  throw std::invalid_argument("no rig with contacts is called " + name);
}

const ContactLaw& contact_law(const ContactRig& rig, const std::string& name, const std::string& where) {
  for (const ContactLaw& law : rig.laws)
    if (law.name == name && law.where == where) return law;
  throw std::invalid_argument("the " + rig.name + " has no law " + name + " at " + where);
}

}  // namespace hidden_effects
