#pragma once

#include "evaluation/model/known_setups.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lacuna {

/// `name`, all `names`, `set` (value and unit by address), `own`, the addresses of what is fitted to it alone, and
/// its `recordings`.
nlohmann::ordered_json setup_json(const KnownSetup& setup);
/// All of them; an empty array where no recording has one.
nlohmann::ordered_json setups_json(const std::vector<KnownSetup>& setups);
/// What `setup_json` wrote.
KnownSetup setup_of(const nlohmann::ordered_json& json);

}  // namespace lacuna
