#pragma once

#include "laws/law_kind.h"

#include <vector>

namespace hidden_effects::dirty {

/// Laws of other forms than the library's, beside those of `all_laws`: what real friction, springs and drives do.
std::vector<LawKind> other_friction_laws();
std::vector<LawKind> other_spring_laws();
std::vector<LawKind> other_drive_laws();

}  // namespace hidden_effects::dirty
