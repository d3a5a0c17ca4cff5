#pragma once

#include "evaluation/known_setups.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lacuna {

/// One line a setup: "setup heavy: body.load.mass = 0.49 kg · heavy.csv, heavy-2.csv". Empty where no recording has
/// one.
std::string setups_text(const std::vector<KnownSetup>& setups);

/// `name`, `set` (value and unit by address) and `own`, the addresses of what is fitted to it alone.
nlohmann::ordered_json setup_json(const KnownSetup& setup);
/// All of them, each with its `recordings`; an empty array where no recording has one.
nlohmann::ordered_json setups_json(const std::vector<KnownSetup>& setups);
/// What `setup_json` wrote.
KnownSetup setup_of(const nlohmann::ordered_json& json);

}  // namespace lacuna
