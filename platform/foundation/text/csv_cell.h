#pragma once

#include <string>

namespace lacuna {

/// A text as one cell of a table in CSV, after RFC 4180: in quotes where it has a comma, a quote or a line break.
std::string csv_cell(const std::string& text);

}  // namespace lacuna
