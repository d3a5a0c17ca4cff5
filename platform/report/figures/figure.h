#pragma once

#include "foundation/processes/stop.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A picture as data, drawn by gnuplot. Values are in the unit that the axis label names.

enum class Mark {
  line,
  points,
  line_points,
  path,      ///< a line whose x may go back and forth
  band,      ///< filled between `y` and `y2`
  whiskers,  ///< a vertical line from `y` to `y2` at each x
  borders,   ///< the same, dotted: what lies left of it and right of it belongs apart
  bars,      ///< a horizontal bar from 0 to x at each y, `y2` high
  level      ///< a horizontal line at `y[0]`
};

inline constexpr double kThin = 1.4;   ///< px, of lines
inline constexpr double kBroad = 4.0;  ///< of one that is to be seen below another where the two coincide

struct Series {
  std::string label;  ///< in the legend; empty: not listed
  Mark mark = Mark::line;
  std::string colour;  ///< as "#0072B2"
  std::vector<double> x;
  std::vector<double> y;   ///< NaN leaves a gap
  std::vector<double> y2;  ///< for bands, whiskers and borders
  double width = kThin;    ///< px, of a line or path
};

/// One pair of axes. Panels of a figure stand below each other and share the x axis, unless they are maps or stand in
/// several columns.
struct Panel {
  std::string y_label;
  std::vector<Series> series;
  double share = 1.0;                     ///< of the figure's height, relative to the other panels
  std::vector<std::string> x_names;       ///< non-empty: x counts from 0 and these are written at 0, 1, ...
  std::vector<std::string> y_names = {};  ///< the same for y, downwards
  std::string x_label = {};               ///< of a panel in a column of several
  bool log_y = false;                     ///< powers of ten apart; values must be above 0
  /// Lower and upper end of the y axis; without, around what is drawn.
  std::optional<std::array<double, 2>> y_range = {};
};

struct Figure {
  std::string title;
  std::string x_label;
  std::vector<Panel> panels;
  bool whole_x = false;  ///< x counts something: ticks at whole numbers only
  bool maps = false;     ///< x and y are places: one scale for both, and each panel has its own x axis
  int columns = 1;       ///< more: panels fill rows of so many, each with its own x axis
  bool same_y = false;   ///< panels in several columns have one range of y
  bool log_x = false;    ///< powers of ten apart, of panels below each other; values must be above 0
  int width = 1000;      ///< px
  int height = 640;
};

/// Colours that people with any colour vision can tell apart (Okabe and Ito 2008).
inline constexpr const char* kInk = "#3A3A3A";
inline constexpr const char* kBlue = "#0072B2";
inline constexpr const char* kOrange = "#D55E00";
inline constexpr const char* kGreen = "#009E73";
inline constexpr const char* kGrey = "#9A9A9A";

/// The figure as SVG. Texts may be of any origin: they stand there as they are, with a space for each control character
/// and U+FFFD for what is not UTF-8. Long lines are thinned to their extremes per pixel column. Throws `Error` where
/// gnuplot is missing or fails, and `Interrupted`.
std::string svg_of(const Figure& figure, const Stop& stop = {});

/// Writes the figure into a file whose name we chose in the user's folder, which is made where it is missing.
void write_svg(const Figure& figure, const std::filesystem::path& file, const Stop& stop = {});

}  // namespace lacuna
