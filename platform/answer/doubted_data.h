#pragma once

#include "data_checks/doubt.h"
#include "answer/diagnosis.h"

#include <vector>

namespace lacuna {

/// Says the doubts beside a verdict, faults first. A fault makes no verdict and takes no answer away; but of faulty
/// data nobody can say that nothing is missing, and no probability is stated, for no case of the calibration has such
/// data.
void add_doubts(const std::vector<Doubt>& doubts, Diagnosis& result);

}  // namespace lacuna
