#pragma once

#include "formula/expression.h"
#include "foundation/text/problem.h"

#include <set>
#include <string>

namespace lacuna {

/// Complains where a formula could be infinite or undefined for some motion: a divisor that may be zero, a root or a
/// fractional power of an expression that may be negative. `positive` names the parameters whose bounds keep them above
/// zero.
void check_finite(const Expression& formula, const std::set<std::string>& positive, ProblemList& problems);

}  // namespace lacuna
