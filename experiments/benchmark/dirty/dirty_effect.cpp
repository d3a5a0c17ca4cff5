#include "dirty/dirty_case.h"

#include "cases/scales_of.h"

namespace hidden_effects::dirty {

const char* to_string(Role role) {
  switch (role) {
    case Role::main: return "main";
    case Role::small: return "small";
    case Role::misstated: return "misstated";
    case Role::reading: return "reading";
  }
  return "";
}

std::string DirtyEffect::what(const PlantSpec& stated) const {
  return kind ? kind->law.name : "value " + value.address(stated);
}

std::string DirtyEffect::place(const PlantSpec& stated) const {
  if (kind) return place_text(*kind, element, stated);
  const std::string address = value.address(stated);
  return address.substr(0, address.find('.', address.find('.') + 1));
}

std::string DirtyEffect::effect(const PlantSpec& stated) const { return kind ? kind->law.effect : what(stated); }

std::vector<std::string> DirtyEffect::accepted(const PlantSpec& stated) const {
  if (!kind) return accepted_for(value, factor, stated);
  return accepted_at(kind->accepted, stated, joint_of(stated, kind->law.place, element));
}

}  // namespace hidden_effects::dirty
