#pragma once

#include "app/workspace/rig_draft.h"

#include <string>

namespace lacuna {

/// Lines of an experiment file about columns that seem to be what a controller followed, beside the command that it
/// sent: `[target.controllers]`, commented out, with gains fitted to the beginning of the first recording (`u = P e +
/// I ∫e dt − D dy/dt`, least squares) where they explain all but a tenth of the command, else blank. Empty where there
/// is no such column.
std::string controllers_text(const RigDraft& draft);

/// Whether that draft has a column as a set point.
bool is_drafted_set_point(const RigDraft& draft, const GuessedColumn& column);

}  // namespace lacuna
