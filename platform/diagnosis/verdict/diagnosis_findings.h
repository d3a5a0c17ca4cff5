#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/rounds/round.h"

#include <string>
#include <vector>

namespace lacuna {

/// The model's values before anything was added.
struct BaseValues {
  std::vector<FreeValue> free;
  std::vector<double> fitted;  ///< SI, in the order of `free`
};

/// Sentences about a finished diagnosis, the most telling first: what of the error is left, and which of the model's
/// values had soaked up what was missing (those that moved by more than two standard errors). `last`: the round that
/// found nothing more to add to `contender`.
std::vector<std::string> findings_of(const Diagnosis& diagnosis, const BaseValues& base, const Contender& contender,
                                     const Round& last);

}  // namespace lacuna
