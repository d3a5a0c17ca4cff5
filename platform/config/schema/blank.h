#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// What stands in a drafted file where its user must put a value: `mass = "FILL IN kg"`, `unit = "FILL IN"`,
/// `parent = "FILL IN world or arm"`.
inline constexpr const char* kBlank = "FILL IN";

bool is_blank(std::string_view text);

/// What a blank that was left asks for, with its unit and an example: "is still blank: write a mass in kg, as in
/// \"0.5 kg\"". `unit`: what stands behind the blank, or else what the key is declared in.
std::string blank_complaint(std::string_view text, const std::string& unit);

}  // namespace lacuna
