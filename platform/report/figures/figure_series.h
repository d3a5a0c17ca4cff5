#pragma once

#include "report/figures/figure.h"

#include <cstddef>
#include <string>

namespace lacuna {

/// A text of any origin as gnuplot takes it: in quotes, within which nothing but letters, digits and spaces stands for
/// itself; all else is written as the number of its byte. So no character means anything to gnuplot, which runs what
/// stands between backticks in such quotes, and the picture shows the text as it is.
std::string quoted(const std::string& text);

/// The same for the name of a tick, which gnuplot takes for the format of a number.
std::string quoted_tick(const std::string& text);

/// Data blocks are named by panel and series, and stand before the plot commands.
std::string block_name(std::size_t panel, std::size_t series);

/// Whether a mark needs `y2`.
bool reaches(Mark mark);

/// A series' values as the data block of that name; long lines are thinned.
std::string data_block(const Series& series, const std::string& name);

/// How a plot command draws the series of that block.
std::string plot_clause(const Series& series, const std::string& block);

}  // namespace lacuna
