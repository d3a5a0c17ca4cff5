#pragma once

#include "app/workspace/rig_draft.h"

#include <string>

namespace lacuna {

/// [target] of the drafted experiment: the recordings, the clock, and the columns of sensors and commands.
std::string target_text(const RigDraft& draft);

}  // namespace lacuna
