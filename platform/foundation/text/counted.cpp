#include "foundation/text/counted.h"

namespace lacuna {

std::string counted(std::size_t count, const std::string& noun) {
  const std::string head = std::to_string(count) + " ";
  if (count == 1) return head + noun;
  if (noun.ends_with('y')) return head + noun.substr(0, noun.size() - 1) + "ies";
  return head + noun + (noun.ends_with('s') ? "es" : "s");
}

}  // namespace lacuna
