#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// Arrays and objects within each other that JSON of others may have. Our own documents have a tenth of it; to copy or
/// write what nests deeper takes as many calls within each other, which ends where the stack does.
inline constexpr int kDeepestJson = 100;

/// Whether a text nests deeper, seen before it is parsed. What is not JSON counts up to where a parser would stop, or
/// further.
bool nests_too_deep(std::string_view json);

/// The text, to be parsed. Throws `Error` where it nests too deep.
const std::string& shallow_json(const std::string& json);

}  // namespace lacuna
