#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace hidden_effects {

/// Refuses an empty text, which is most often a variable of the shell that was not set.
inline CLI::Validator not_empty() {
  return {[](std::string& given) { return given.empty() ? std::string("is empty") : std::string(); }, ""};
}

}  // namespace hidden_effects
