#pragma once

#include "diagnosis/diagnosis_findings.h"
#include "diagnosis/present_effects.h"

#include <cstdint>
#include <optional>

namespace lacuna {

/// What a search ends with. Everything referred to must live until `conclude` returns.
struct SearchOutcome {
  const Contender& answer;
  BaseValues first;                       ///< of the model without any effect
  const Round& last;                      ///< of the answer: it found nothing more to add
  bool outdone_by_law = false;            ///< nothing more was looked for, since a formula outdoes the library
  std::optional<PresentEffects> present;  ///< that the experiment's model has
  std::uint64_t seed = 1;                 ///< of the bootstrap
};

/// Ends a diagnosis with verdict, probabilities and findings. `diagnosis`: what its rounds found, its findings about
/// effects that are still in the answer.
void conclude(Diagnosis& diagnosis, const SearchOutcome& outcome);

}  // namespace lacuna
