#pragma once

#include "baselines/answer.h"

#include <cstdint>

namespace hidden_effects {

/// What else somebody could do with the same data: cross-validated refits, BIC with an effective sample size, stepwise
/// regression on inverse dynamics, the residual's correlation with effect signals, and guessing. All choose among the
/// library's effects at all places of the rig, with the same free values, the starts of the trials free.
///
/// Their simulator is the plant's own, with which the data were made (at a finer step): faster than an engine and
/// without an integration error of another kind, which is to their advantage. The two that refit take the twelve
/// candidates whose signals, the base's directions projected out, correlate best with the residual, so that all five
/// together need about the time of a diagnosis. The seconds of an answer are those that it would need alone; steps that
/// several share count for each.
std::vector<BaselineAnswer> run_baselines(const Observed& seen, std::uint64_t seed);

/// The same of a case's recorded side; effects that are withheld from the library are no candidates.
std::vector<BaselineAnswer> run_baselines(const MadeCase& made, const std::vector<std::string>& withheld = {});

}  // namespace hidden_effects
