#pragma once

#include "where_it_fails/where_it_fails.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "report/text/comparison_text.h"

#include <string>

namespace lacuna {

/// The comparison, its fit and where the model fails as one JSON object, SI units throughout; unknown figures are null.
/// `advice`: what follows from it (`advice_text`).
std::string comparison_json(const ComparisonHeading& heading, const Comparison& comparison, const FitResult& fit,
                            const WhereItFails& where, const std::string& advice = {});
std::string fit_json(const std::string& experiment, const FitResult& fit);

/// The scores as CSV: one row a trial and channel.
std::string comparison_csv(const Comparison& comparison);

}  // namespace lacuna
