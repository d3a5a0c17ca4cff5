#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// A unit as people read it: "N*m*s^2/rad^2", as files write it, becomes "N·m·s²/rad²". The pages of a report have the
/// same in TypeScript (report/pages/web/src/kit/format.ts). `parse_unit` reads both spellings.
std::string unit_text(std::string_view unit);

/// The same with a blank before it; empty for "1".
std::string unit_after_number(std::string_view unit);

/// The other way: "N·m·s²" as "N*m*s^2".
std::string typed_unit(std::string_view text);

}  // namespace lacuna
