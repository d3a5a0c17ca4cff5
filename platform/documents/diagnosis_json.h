#pragma once

#include "answer/diagnosis.h"

#include <string>

namespace lacuna {

/// One JSON document; schema in docs/reference/commands.md. SI units; NaN is null.
std::string diagnosis_json(const Diagnosis& diagnosis);

/// What `diagnosis_json` has written.
Diagnosis read_diagnosis(const std::string& document);

}  // namespace lacuna
