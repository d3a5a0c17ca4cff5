#pragma once

#include "report/figure.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// The commands with which gnuplot draws a figure into an SVG file.
std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file);

}  // namespace lacuna
