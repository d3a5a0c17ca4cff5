#pragma once

namespace hidden_effects {

/// What `--set` takes, in the help of the commands.
inline constexpr const char* kSets =
    "tuning, reporting, fixed, dirty-tuning, dirty-reporting, dirty-quick, dirty-values, dirty-loops or "
    "dirty-withheld";

}  // namespace hidden_effects
