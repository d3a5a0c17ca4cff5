#pragma once

#include "formula/expression.h"
#include "foundation/text/problem.h"

#include <optional>

namespace lacuna {

/// Reads a formula (docs/reference/formulas.md): sums, products, quotients, powers with a number as exponent, the
/// variables q, v and u, functions of one argument, and names of parameters. Parts without variable and name come
/// back as one number. Problems have the column in the text; words that are none, names and functions that are
/// none, are told all at once, of a faulty structure the first fault. Nothing is returned if there is any.
std::optional<Expression> parse_formula(const std::string& text, ProblemList& problems);

}  // namespace lacuna
