#pragma once

#include "evaluation/model/complaints.h"
#include "evaluation/model/model_definition.h"
#include "foundation/recording_source.h"

namespace lacuna {

/// Gives the model the setups of the recordings: what each sets, and a free value for what is unknown and its own, with
/// the bounds and the start that the address has in all recordings. A value that no recording to be fitted shares any
/// more is no longer free. The effects must be placed. Complains of addresses that match nothing, impossible values,
/// bounds that nobody gives, and values that no recording can tell.
void add_setups(ModelDefinition& definition, const RecordingSource& source, Complaints& complaints);

}  // namespace lacuna
