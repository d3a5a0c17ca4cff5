#pragma once

#include "answer/diagnosis.h"

#include <string>

namespace lacuna {

/// "effect_found · P 0.93 (uncalibrated)", or what it was calibrated on; `cannot_tell` states no probability.
std::string verdict_text(const Diagnosis& diagnosis);

/// "torque" for a force in N*m, on a hinge; "force" for one in N, on a slider.
const char* force_word(const std::string& unit);

/// Verdict, errors by horizon, ranking with gains and look-alikes, values, findings, what could not be tested. `file`:
/// the experiment's, for the command to go on with; `options`: what to type behind it, as in " --db rig.db".
/// `correction`: lines that a data check proposes for the file before an effect is added; empty: none.
std::string diagnosis_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options = "",
                           const std::string& correction = "");

}  // namespace lacuna
