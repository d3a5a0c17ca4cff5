#include "foundation/text/json_depth.h"

#include <lacuna/error.h>

#include <fmt/format.h>

namespace lacuna {
namespace {

/// One past the string whose quotation mark is at `at`.
std::size_t end_of_string(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at)
    if (json[at] == '\\') ++at;
  return at + 1;
}

}  // namespace

bool nests_too_deep(std::string_view json) {
  int depth = 0;
  for (std::size_t at = 0; at < json.size();) {
    const char c = json[at];
    if (c == '"') {
      at = end_of_string(json, at);
      continue;
    }
    if ((c == '[' || c == '{') && ++depth > kDeepestJson) return true;
    if (c == ']' || c == '}') --depth;
    ++at;
  }
  return false;
}

const std::string& shallow_json(const std::string& json) {
  if (nests_too_deep(json))
    throw Error(fmt::format("JSON nests arrays and objects more than {} levels deep; use fewer levels", kDeepestJson));
  return json;
}

}  // namespace lacuna
