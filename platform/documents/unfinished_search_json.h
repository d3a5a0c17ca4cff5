#pragma once

#include "search/unfinished_search.h"

#include <optional>
#include <string>

namespace lacuna {

/// One JSON document, from which `read_unfinished_search` makes the same search, digit for digit.
std::string unfinished_search_json(const UnfinishedSearch& search);

/// Nothing where another version of the program, whose search goes another way, has written it, or a figure of it is
/// not finite.
std::optional<UnfinishedSearch> read_unfinished_search(const std::string& document);

}  // namespace lacuna
