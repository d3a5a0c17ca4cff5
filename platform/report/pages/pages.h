#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace lacuna {

/// Whether this program was built with the pages of `lacuna report` and `lacuna serve`; without Node they are missing.
bool has_pages();
/// Throws `Error` where it was not, with a sentence that says what to do.
void require_pages();

/// The pages as one HTML file around a copy of a database (page_database.h): opens from disk without server or network.
std::string report_page(std::span<const std::byte> database);

/// The pages as the server hands them out; they ask it for everything.
std::string served_page();

}  // namespace lacuna
