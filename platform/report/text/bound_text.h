#pragma once

#include "fitting/fit.h"

#include <string>

namespace lacuna {

/// For each fitted value that rests on a bound one line that says which value, which bound and what that
/// means: the data do not want the effect, or the bound is too tight for them. Empty where none does.
std::string bound_text(const FitResult& fit);

}  // namespace lacuna
