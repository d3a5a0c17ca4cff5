#pragma once

#include "app/mcp/tool.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace lacuna {

/// What a call of a tool came to.
struct CallOutcome {
  int exit_code = 0;
  nlohmann::ordered_json result;   ///< as the command's --json has it; null where it has none
  std::string printed;             ///< on standard output
  std::vector<std::string> notes;  ///< lines of standard error, those about progress left out
};

/// The answer to `tools/call`: what may be concluded and what to do next (`structuredContent`), and the same as text
/// with what the command prints. Long lists of numbers are left out of the result. `arguments`: of the call.
nlohmann::ordered_json call_answer(const Tool& tool, const nlohmann::ordered_json& arguments,
                                   const CallOutcome& outcome);

}  // namespace lacuna
