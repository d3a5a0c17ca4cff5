#pragma once

#include "storage/queries/page_query.h"

#include <nlohmann/json.hpp>

#include <string>

namespace lacuna {

/// The value of a query's parameter.
PageCell page_cell_of(const nlohmann::json& value);

/// The rows of an answer as JSON. Of what a user typed (`typed`) every value is told, as text where JSON has no such
/// number; a page's own questions get null. Throws `Error` where it would have more than `most_bytes`.
std::string page_json(const PageTable& table, bool typed, std::size_t most_bytes);

/// Any JSON as text; bytes that are no UTF-8 are replaced.
std::string page_json(const nlohmann::json& value);

}  // namespace lacuna
