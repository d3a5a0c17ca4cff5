#pragma once

#include "where_it_fails/where_it_fails.h"

#include <string>

namespace lacuna {

/// "|velocity| < 50 mrad/s, within 0.21 s after a reversal"
std::string conditions_text(const std::vector<Condition>& conditions, const FeatureTable& table);

/// A finding as a sentence without its full stop: "61 % of the squared error is in 11 % of the samples: |velocity| <
/// 50 mrad/s".
std::string finding_text(const Finding& finding, const FeatureTable& table);

/// The lines of `compare` that say where the model fails, the largest findings first; empty where nothing was scored.
std::string where_text(const WhereItFails& where);

}  // namespace lacuna
