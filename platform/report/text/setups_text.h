#pragma once

#include "evaluation/model/known_setups.h"

#include <string>
#include <vector>

namespace lacuna {

/// One line a setup: "setup heavy: body.load.mass = 0.49 kg · heavy.csv, heavy-2.csv". Empty where no recording has
/// one.
std::string setups_text(const std::vector<KnownSetup>& setups);

}  // namespace lacuna
