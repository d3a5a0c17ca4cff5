#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lacuna {

/// Room that texts take in a figure, and texts that take no more than there is.

/// Characters, however many bytes each has.
std::size_t letters_of(const std::string& text);
std::size_t longest_of(const std::vector<std::string>& texts);

/// Lines of at most so many letters, which end behind a space, or in a long word behind "_", "." or
/// "*", where that is possible; at least one.
std::vector<std::string> lines_of(const std::string& text, std::size_t letters);

/// The lines as one text of gnuplot's, each as `quoted`; of ticks as `quoted_tick`.
std::string quoted_lines(const std::vector<std::string>& lines);
std::string quoted_tick_lines(const std::vector<std::string>& lines);

}  // namespace lacuna
