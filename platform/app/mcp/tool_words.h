#pragma once

#include "app/mcp/tool.h"
#include "foundation/files/allowed_files.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace lacuna {

/// The command line, without the program's name, that carries a tool out with these arguments. Every value stands
/// where the command line takes it as a value, whatever it begins with. Throws `BadInput` with all that is wrong:
/// unknown, missing and mistyped arguments, and names of files that lie elsewhere.
std::vector<std::string> words_of_call(const Tool& tool, const nlohmann::ordered_json& arguments,
                                       const AllowedFiles& allowed);

}  // namespace lacuna
