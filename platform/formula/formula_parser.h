#pragma once

#include "formula/expression.h"
#include "foundation/text/problem.h"

#include <optional>

namespace lacuna {

/// Reads a formula (docs/reference/formulas.md): sums, products, quotients, powers with a number as exponent, the
/// variables q, v and u, functions of one argument, and names of parameters. Parts without variables and names become
/// one number. Problems have the column in the text; invalid words, names and functions are all reported at once, of a
/// faulty structure only the first fault. Returns nothing if there is a problem.
std::optional<Expression> parse_formula(const std::string& text, ProblemList& problems);

}  // namespace lacuna
