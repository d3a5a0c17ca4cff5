#pragma once

#include "diagnosis/rounds/present_effects.h"
#include "diagnosis/verdict/diagnosis_findings.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace lacuna {

/// What a search ends with. Everything referred to must live until `conclude` returns.
struct SearchOutcome {
  const Contender& answer;
  BaseValues first;                 ///< of the model without any effect
  const Round& last;                ///< of the answer: it found nothing more to add
  std::optional<double> law_ahead;  ///< nats: nothing more was looked for, since a formula outdoes the library by these
  /// Of the experiment's model; asked for where something seems to be missing.
  std::function<std::optional<PresentEffects>()> present;
  std::uint64_t seed = 1;  ///< of the bootstrap
};

/// Ends a diagnosis with verdict, probabilities and findings. `diagnosis`: what its rounds found, its findings about
/// effects that are still in the answer.
void conclude(Diagnosis& diagnosis, const SearchOutcome& outcome);

}  // namespace lacuna
