#pragma once

#include <nlohmann/json.hpp>

namespace lacuna {

/// A result for somebody who reads it whole: lists of more than 32 numbers, and of more than 200 of anything else, are
/// replaced by or end with a sentence that says how long they are. What is still longer than 256 kB becomes a sentence.
nlohmann::ordered_json shortened(const nlohmann::ordered_json& result);

}  // namespace lacuna
