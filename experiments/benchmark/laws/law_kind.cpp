#include "laws/law_kind.h"

#include <algorithm>
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

int elements_of(const PlantSpec& spec, Place place) {
  switch (place) {
    case Place::joint: return static_cast<int>(spec.joints.size());
    case Place::body: return static_cast<int>(spec.bodies.size());
    case Place::drive: return static_cast<int>(spec.drives.size());
    case Place::sensor: return static_cast<int>(spec.sensors.size());
    case Place::world: break;
  }
  return 1;
}

bool is_even(const LawKind& kind, const std::string& parameter) {
  return std::find(kind.even.begin(), kind.even.end(), parameter) != kind.even.end();
}

const LawKind& law_kind(const std::string& name) {
  for (const LawKind& kind : all_laws())
    if (kind.name == name) return kind;
  throw std::invalid_argument("no law is called " + name);
}

}  // namespace hidden_effects
