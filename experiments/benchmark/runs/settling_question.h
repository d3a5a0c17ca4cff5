#pragma once

#include "runs/records.h"

#include <optional>
#include <string>
#include <vector>

namespace hidden_effects {

/// Which of two effects is it? The answer of a diagnosis (the last effect of its first model) or its closest
/// look-alike.
struct SettlingQuestion {
  EffectAt answer, rival;
  std::vector<std::string> among;  ///< names of all that the answer has, and of the look-alike
};

/// What a diagnosis leaves open and proposes a test for; nothing where it does not.
std::optional<SettlingQuestion> question_of(const DiagnosisRecord& diagnosis);

/// The one of the two that a diagnosis names, as an effect of its first model or as a look-alike, without naming the
/// other. Without an effect where it names both, neither, or does not say `effect_found`: the question is open.
EffectAt remaining(const SettlingQuestion& question, const DiagnosisRecord& diagnosis);

}  // namespace hidden_effects
