#include "foundation/text/counted.h"

#include <string_view>

namespace lacuna {

std::string counted(std::size_t count, const std::string& noun) {
  const std::string head = std::to_string(count) + " ";
  if (count == 1) return head + noun;
  if (noun.ends_with('y')) return head + noun.substr(0, noun.size() - 1) + "ies";
  return head + noun + (noun.ends_with('s') ? "es" : "s");
}

std::string with_article(const std::string& noun) {
  const bool is_vowel = !noun.empty() && std::string_view("aeioAEIO").find(noun.front()) != std::string_view::npos;
  return (is_vowel ? "an " : "a ") + noun;
}

}  // namespace lacuna
