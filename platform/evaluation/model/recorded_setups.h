#pragma once

#include "evaluation/model/complaints.h"
#include "evaluation/model/model_definition.h"
#include "foundation/recording_source.h"

namespace lacuna {

/// Gives the model the setups of the recordings: the set values of each, and a free value for each of its own unknown
/// values, with the bounds and the start that the address has in all recordings. A value that no fit recording shares
/// any more is no longer free. The effects must be placed. Complains of addresses without a match, impossible values,
/// missing bounds, and values that no recording determines.
void add_setups(ModelDefinition& definition, const RecordingSource& source, Complaints& complaints);

}  // namespace lacuna
