#pragma once

#include "where_it_fails/where_it_fails.h"
#include "report/text/advice_text.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace lacuna {

/// The findings: an array, the largest share first, each with a sentence.
nlohmann::ordered_json findings_json(const WhereItFails& where);

/// Features, whiteness, and for each view its tests with statistics, bands and bins, the tree and its regimes.
nlohmann::ordered_json where_json(const WhereItFails& where);

/// Both, JSON, with the stretches of time that findings and regimes speak of, and with the advice that follows from the
/// comparison: for the database.
std::string where_document(const WhereItFails& where, const Comparison& comparison, const Advice& advice);

}  // namespace lacuna
