#pragma once

#include "foundation/processes/guarded_call.h"
#include "plugin_checks/check_result.h"

#include <string>

namespace lacuna {

/// Reasons of failures other than the finding of a check.
inline constexpr const char* kThrownReason = "an exception";
inline constexpr const char* kEndedReason = "an end";
inline constexpr const char* kRefusedReason = "a refusal";

/// A failed check: `finding` says what, a clause; why it matters and what to do follow from the reason, one of the
/// above or the name of a check.
CheckResult failed(const std::string& check, const std::string& reason, const std::string& finding);
/// For the check's own reason.
inline CheckResult failed_check(const std::string& check, const std::string& finding) {
  return failed(check, check, finding);
}

/// "a call threw std::domain_error (too large)" for the current exception. Only inside a `catch` block.
std::string thrown_by_call(const ComponentOrigin& origin);

}  // namespace lacuna
