#pragma once

#include "data_checks/data_warning.h"
#include "answer/diagnosis.h"

#include <vector>

namespace lacuna {

/// Adds the sentences of the data checks to a diagnosis, faults first. A fault changes neither the verdict
/// `effect_found` nor its answer. With faulty data, however, `nothing_missing` cannot be concluded, and no probability
/// is stated because the calibration has no such cases.
void add_doubts(const std::vector<DataWarning>& doubts, Diagnosis& result);

}  // namespace lacuna
