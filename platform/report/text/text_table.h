#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// Rows of cells, aligned in columns for a terminal: the first `left` columns to the left, the
/// others to the right. Widths count characters, not bytes. A cell of several lines, as a
/// stranger's names may have, becomes one.
std::string text_table(std::vector<std::vector<std::string>> rows, std::size_t left = 1);

/// A bar of eighths of blocks, `share` of `width` characters long.
std::string text_bar(double share, int width);

}  // namespace lacuna
