#pragma once

#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// An effect that explains this share of the owner's error has to be named; one that explains the second may be; and
/// where the error is less than the third, in units of the noise, nothing has to be.
inline constexpr double kNeededShare = 0.20, kPresentShare = 0.02, kLeastError = 1.0;

enum class DirtyGrade {
  right,      ///< everything needed is named, with one stranger at most; or nothing is needed and nothing is missing
  half,       ///< something needed is named; or `not_in_library` where a needed law has another form than the library's
  undecided,  ///< `cannot_tell`
  wrong,      ///< everything else
  failed      ///< no answer
};
const char* to_string(DirtyGrade grade);

/// Whether "effect @ place" or "value address" is what an answer says; "joint.*" stands for each joint.
bool names_effect(const EffectAt& said, const std::string& accepted);

/// What has to be named in a case.
std::vector<const DirtyEffectRecord*> needed_effects(const CaseResult& result);

/// How good the first diagnosis is. A needed effect is named by an effect of the first model or by one of its
/// look-alikes. A stranger is an effect of the first model that names nothing that is present, beyond those that stand
/// for a needed effect which only a look-alike names.
DirtyGrade grade_of(const CaseResult& result);

/// Whether a verdict with a probability is true: everything needed is named, or the library ends where it says so.
bool is_true(const CaseResult& result);

/// Brier's score of the stated probabilities, of answers but `cannot_tell`; of those that a calibration without the
/// case's family of rigs would state; and of the constant that fits best. NaN where none is stated.
struct BrierScores {
  double stated = kUnknown, left_out = kUnknown, constant = kUnknown;
  int count = 0;
};
BrierScores brier_of(const std::vector<CaseResult>& results);

/// The library's name that is needed most often in these cases, and how an answer that always says it alone, at the
/// right place, would be graded.
std::string commonest_effect(const std::vector<CaseResult>& results);
DirtyGrade grade_of_constant(const CaseResult& result, const std::string& effect);

}  // namespace hidden_effects
