#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// Largest nesting of arrays and objects in foreign JSON. Our own documents have a tenth of it; copying or writing
/// deeper ones takes as many nested calls, which may overflow the stack.
inline constexpr int kDeepestJson = 100;

/// Whether a text nests deeper, checked before parsing. For invalid JSON the count may go beyond the point where a
/// parser stops.
bool nests_too_deep(std::string_view json);

/// The text, to be parsed. Throws `Error` where it nests too deeply.
const std::string& shallow_json(const std::string& json);

}  // namespace lacuna
