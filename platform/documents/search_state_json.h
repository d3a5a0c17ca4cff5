#pragma once

#include "diagnosis/rounds/search_state.h"

#include <optional>
#include <string>

namespace lacuna {

/// One JSON document, from which `read_search_state` makes the same state, digit for digit.
std::string search_state_json(const SearchState& state);

/// Nothing where another version of the program, whose search goes another way, has written it, or a figure of it is
/// not finite.
std::optional<SearchState> read_search_state(const std::string& document);

}  // namespace lacuna
