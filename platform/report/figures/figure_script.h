#pragma once

#include "report/figures/figure.h"

#include <string>

namespace lacuna {

/// The commands with which gnuplot draws a figure as SVG on its standard output. No text of the figure is one of them,
/// or part of one (`quoted`).
std::string gnuplot_script(const Figure& figure);

}  // namespace lacuna
