#pragma once

#include "storage/files/raw_file.h"

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace lacuna {

/// Random numbers of commits (log_content.h), without those that came before them.
using Marks = std::set<std::string, std::less<>>;

void add_marks(std::string_view bytes, Marks& marks);
/// Those that stand in one page of a database file, counted from 1.
Marks marks_of_page(const RawFile& file, std::uint32_t page, std::uint32_t page_size);
/// Those of the whole file, which is read from its beginning to its end.
Marks all_marks(const RawFile& file);

}  // namespace lacuna
