#pragma once

#include <string_view>

namespace lacuna {

/// Ends the sentence about a plugin that failed in one of its calls.
inline constexpr std::string_view kFaultOfPlugin =
    "; this is a fault of the plugin: repair it or leave this component out";

/// Whether a sentence reports a failure of a plugin, not its refusal of a request.
inline bool blames_plugin(std::string_view reason) {
  return reason.find("this is a fault of the plugin") != std::string_view::npos ||
         reason.find("repair the plugin") != std::string_view::npos;
}

}  // namespace lacuna
