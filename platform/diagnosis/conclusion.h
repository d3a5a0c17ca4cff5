#pragma once

#include "diagnosis/diagnosis_findings.h"

#include <cstdint>

namespace lacuna {

/// Ends a diagnosis with verdict, probabilities and findings. `diagnosis`: what its rounds found, its findings about
/// effects that are still in the answer; `first`: the model without any effect; `last`: the round that found nothing
/// more to add to `contender`; `outdone_by_law`: nothing more was looked for, since a formula outdoes the library;
/// `seed`: of the bootstrap.
void conclude(Diagnosis& diagnosis, const Contender& contender, const BaseValues& first, const Round& last,
              bool outdone_by_law, std::uint64_t seed);

}  // namespace lacuna
