#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/rounds/round.h"

#include <string>

namespace lacuna {

/// A sentence where most of the noise that a diagnosis found comes from random forces and the experiment declares none,
/// and how to declare them: `compare` knows of no other noise than what is declared and that of the sensors, so it
/// calls a right model bad there. Else empty.
std::string undeclared_force(const Diagnosis& diagnosis, const Contender& contender, const Round& last);

}  // namespace lacuna
