#include "laws/law_kind.h"

#include <stdexcept>

namespace hidden_effects {

const std::vector<LawKind>& all_laws() {
  static const std::vector<LawKind> all = [] {
    std::vector<LawKind> laws;
    for (const auto& family : {friction_laws(), joint_laws(), body_laws(), drive_laws(), sensor_laws()})
      laws.insert(laws.end(), family.begin(), family.end());
    return laws;
  }();
  return all;
}

const LawKind& law_kind(const std::string& name) {
  for (const LawKind& kind : all_laws())
    if (kind.name == name) return kind;
  throw std::invalid_argument("no law is called " + name);
}

}  // namespace hidden_effects
