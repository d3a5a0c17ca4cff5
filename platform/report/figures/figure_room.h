#pragma once

#include "report/figures/figure.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr double kPanelRight = 0.98;    ///< of a figure's width, where panels end at most
inline constexpr double kLetter = 7.5;         ///< px, the width of one
inline constexpr double kTickLetter = 9.75;    ///< px, what gnuplot keeps free for each of a y axis's numbers
inline constexpr double kPicturedFont = 13.0;  ///< pt

/// The room that the texts of a figure take.
struct FigureRoom {
  double left = 0.0, right = kPanelRight;  ///< where panels begin and end, shares of the width
  std::vector<std::string> title;          ///< its lines
  double title_left = 0.0;                 ///< share of the width
  double above = 0.0;                      ///< px, of the title
  double below = 0.0;                      ///< px, of the lowest x axis's ticks and label
  std::vector<std::string> x_label;        ///< its lines
  int name_turn = 0;                       ///< degrees by which names of an x axis are turned
};

/// Finds the room that texts need, and makes the figure higher by what is not there.
FigureRoom make_room(Figure& figure);

/// A name of a y axis in lines.
std::vector<std::string> y_name_lines(const Figure& figure, const std::string& name);

/// Of the values of panels along an axis; nothing where no value is finite.
std::optional<std::array<double, 2>> range_along_y(const Panel& panel, bool above_zero);
std::optional<std::array<double, 2>> range_along_x(const Figure& figure, bool above_zero);

/// Of the longest number beside a y axis from `low` to `high`: the digits before the point, and as many behind it as
/// tell some five ticks apart.
int tick_letters(double low, double high);

/// Whether anything is to be seen of a series.
bool is_visible(const Series& series);

}  // namespace lacuna
