#include "report/figures/figure_script.h"

#include "report/figures/figure_room.h"
#include "report/figures/figure_series.h"
#include "report/figures/text_lines.h"
#include "report/figures/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kTitleMiddle = 22.5;  // px, of its first line
constexpr double kKeyRow = 20.0;       // px
constexpr double kAbovePanel = 6.0;    // px, between a panel and its legend

std::string tick_names(const std::vector<std::string>& names, int turn) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{} {}", i ? ", " : "", quoted_tick(names[i]), i);
  return fmt::format("set xtics ({}) {}\nset xrange [-0.5:{}]\n", text,
                     turn > 0 ? fmt::format("rotate by -{}", turn) : "norotate",
                     static_cast<double>(names.size()) - 0.5);
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void hold(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  /// As wide as `width`, about the same middle.
  Range widened(double width) const {
    const double middle = 0.5 * (low + high);
    return {middle - 0.5 * width, middle + 0.5 * width};
  }
};

Range y_range(const Panel& panel) {
  Range range;
  for (const Series& series : panel.series) {
    range.hold(series.y);
    range.hold(series.y2);
  }
  return range;
}

/// One range for the y axes of all panels.
std::string common_y_range(const Figure& figure) {
  Range all;
  for (const Panel& panel : figure.panels) {
    const Range one = y_range(panel);
    all.hold({one.low, one.high});
  }
  if (!(all.low < all.high)) return {};
  const Range shown = all.widened(1.05 * (all.high - all.low));
  return fmt::format("set yrange [{:.9g}:{:.9g}]\n", shown.low, shown.high);
}

/// Names at 0, 1, ... downwards.
std::string y_tick_names(const Figure& figure, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{} {}", i ? ", " : "", quoted_tick_lines(y_name_lines(figure, names[i])), i);
  return fmt::format("set ytics ({})\nset yrange [{}:-0.5]\n", text, static_cast<double>(names.size()) - 0.5);
}

/// Logarithmic axes of a panel, whose y axis is `height` px long and x axis `width`; the x axis is numbered below the
/// lowest panel alone.
std::string scales(const Figure& figure, const Panel& panel, double width, double height, bool numbered) {
  std::string text;
  if (panel.log_y) {
    const auto range = panel.y_range ? panel.y_range : range_along_y(panel, true);
    if (range) text += log_axis('y', (*range)[0], (*range)[1], height, true);
  }
  if (figure.log_x)
    if (const auto range = range_along_x(figure, true))
      text += log_axis('x', (*range)[0], (*range)[1], width, numbered);
  return text;
}

std::string scales_undone(const Figure& figure, const Panel& panel) {
  if (!panel.log_y && !figure.log_x) return "";
  return "unset logscale\nset ytics auto\nset yrange [*:*]\nset format y \"%g\"\n";
}

/// A label of an axis ("x" or "y") that is `length` px long, in smaller letters where it is longer than that.
std::string axis_label(const char* axis, const std::string& text, double length) {
  constexpr double kSmallest = 7.0;  // pt
  const double needed = kLetter * static_cast<double>(letters_of(text));
  const double size = std::max(kSmallest, kPicturedFont * std::min(1.0, length / std::max(needed, 1.0)));
  const double letter = kLetter * size / kPicturedFont;
  const auto lines = lines_of(text, static_cast<std::size_t>(std::ceil(length / letter)));
  return fmt::format("set {}label {} font \",{:.3g}\"\n", axis, quoted_lines(lines), size);
}

/// Between the ticks of an axis that counts: 1, 2, 5, 10, 20 ...; at most twenty ticks.
long whole_tick(const Figure& figure) {
  double largest = 0.0;
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series)
      for (const double x : series.x) largest = std::max(largest, x);
  long tick = 1;
  for (int i = 0; largest / static_cast<double>(tick) > 20.0; ++i) tick = i % 3 == 1 ? tick / 2 * 5 : tick * 2;
  return tick;
}

/// A legend has what is to be seen.
bool is_listed(const Series& series) { return !series.label.empty() && is_visible(series); }

/// How many rows the largest legend of a figure has, beside or below each other in so many px: all in one, or one each.
int rows_of_key(const Figure& figure, double room) {
  constexpr double kSample = 80.0;  // px: a line and the space beside it
  int most = 1;
  for (const Panel& panel : figure.panels) {
    double longest = 0.0;
    int labelled = 0;
    for (const Series& series : panel.series) {
      if (!is_listed(series)) continue;
      longest = std::max(longest, kSample + kLetter * static_cast<double>(letters_of(series.label)));
      ++labelled;
    }
    if (longest * labelled > room) most = std::max(most, labelled);
  }
  return most;
}

/// A legend that stands above `bottom` and grows upwards, at the figure's right.
std::string key_above(double bottom, int rows) {
  return fmt::format("set key at screen 0.98, screen {:.4f} right bottom {}\n", bottom,
                     rows > 1 ? "vertical" : "horizontal");
}

/// An axis that counts, with room beside what is counted first and last.
std::string whole_axis(const Figure& figure) {
  Range range;
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series) range.hold(series.x);
  if (!(range.low <= range.high)) return {};
  constexpr double kBeside = 0.5;
  return fmt::format("set xtics {}\nset xrange [{:.9g}:{:.9g}]\n", whole_tick(figure), range.low - kBeside,
                     range.high + kBeside);
}

/// Ranges under which a metre is as long on the x axis as on the y axis.
std::string map_ranges(const Figure& figure, const FigureRoom& room, const Panel& panel, double height_share) {
  Range x, y;
  for (const Series& series : panel.series) {
    x.hold(series.x);
    y.hold(series.y);
  }
  if (!(x.low <= x.high) || !(y.low <= y.high)) return {};
  constexpr double kRoom = 1.1;  ///< around what is drawn
  const double width = (room.right - room.left) * figure.width, height = height_share * figure.height;
  double per_pixel = kRoom * std::max((x.high - x.low) / width, (y.high - y.low) / height);
  if (!(per_pixel > 0.0)) per_pixel = 1.0 / width;
  const Range across = x.widened(per_pixel * width), up = y.widened(per_pixel * height);
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", across.low, across.high, up.low, up.high);
}

std::string plot_command(const Panel& panel, std::size_t index) {
  std::string clauses;
  for (std::size_t s = 0; s < panel.series.size(); ++s)
    if (is_visible(panel.series[s]))
      clauses += (clauses.empty() ? "" : ", \\\n  ") + plot_clause(panel.series[s], block_name(index, s));
  if (clauses.empty()) clauses = "[][0:1] -1 notitle";  // axes alone
  std::string plot = "plot " + clauses + "\nunset label 1\n";
  if (!panel.y_range || panel.log_y) return plot;
  const auto [low, high] = *panel.y_range;
  return fmt::format("set yrange [{:.9g}:{:.9g}]\n{}set yrange [*:*]\n", low, high, plot);
}

/// Few enough ticks on a narrow x axis that their numbers stay apart.
std::string narrow_ticks(const Panel& panel, double width) {
  Range range;
  for (const Series& series : panel.series) range.hold(series.x);
  if (!(range.low < range.high)) return {};
  const double apart = (range.high - range.low) * kTickLetter * (tick_letters(range.low, range.high) + 2) / width;
  double tick = std::pow(10.0, std::floor(std::log10(apart)));
  for (const double factor : {2.0, 2.5, 2.0})  // 2, 5, 10 times
    if (tick < apart) tick *= factor;
  return fmt::format("set xtics {:.9g}\n", tick);
}

std::string panel_commands(const Figure& figure, const FigureRoom& room, std::size_t index, double top, double bottom,
                           int key_rows) {
  const Panel& panel = figure.panels[index];
  const bool labelled = figure.maps || index + 1 == figure.panels.size();
  std::string text = fmt::format("set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n", top, bottom);
  text += key_above(top + kAbovePanel / figure.height, key_rows);
  text += axis_label("y", panel.y_label, (top - bottom) * figure.height);
  text += labelled ? "set xlabel " + quoted_lines(room.x_label) + "\nset format x \"%g\"\n"
                   : "unset xlabel\nset format x \"\"\n";
  if (figure.maps) text += map_ranges(figure, room, panel, top - bottom);
  if (!panel.x_names.empty()) text += tick_names(panel.x_names, room.name_turn);
  if (!panel.y_names.empty()) text += y_tick_names(figure, panel.y_names);
  if (figure.whole_x) text += whole_axis(figure);
  text += scales(figure, panel, (room.right - room.left) * figure.width, (top - bottom) * figure.height, labelled);
  return text + plot_command(panel, index) + scales_undone(figure, panel);
}

bool is_labelled(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& series) { return is_listed(series); });
}

/// If only one panel has a legend, it is the legend of all.
bool has_one_key(const Figure& figure) {
  return std::count_if(figure.panels.begin(), figure.panels.end(), is_labelled) == 1;
}

/// Panels in rows, each with its own axes.
std::string grid_commands(const Figure& figure, const FigureRoom& room) {
  constexpr double kBetweenRows = 62.0, kBetweenColumns = 84.0;  // px
  const int key_rows = has_one_key(figure) ? rows_of_key(figure, 0.8 * figure.width / figure.columns) : 0;
  const double top_of_grid = 1.0 - (room.above + kKeyRow * key_rows) / figure.height;
  const auto columns = static_cast<std::size_t>(figure.columns);
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  const double cell_width = 1.0 / figure.columns, cell_height = top_of_grid / static_cast<double>(rows);
  std::string text = figure.same_y ? common_y_range(figure) : "";
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const Panel& panel = figure.panels[p];
    const std::size_t row = p / columns;
    const double left = cell_width * static_cast<double>(p % columns) + kBetweenColumns / figure.width;
    const double top = top_of_grid - cell_height * static_cast<double>(row) - kAbovePanel / figure.height;
    const double right = cell_width * static_cast<double>(p % columns + 1) - 14.0 / figure.width;
    const double bottom = top - cell_height + (kBetweenRows + kAbovePanel) / figure.height;
    text += fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", left, right);
    text += fmt::format("set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n", top, bottom);
    text += !is_labelled(panel) ? "unset key\n"
            : key_rows > 0      ? key_above(top_of_grid, key_rows)
                                : "set key inside right top vertical\n";
    text += axis_label("y", p % columns == 0 ? panel.y_label : "", (top - bottom) * figure.height);
    text += axis_label("x", panel.x_label, (right - left) * figure.width) + "set xtics auto\nset xrange [*:*]\n";
    text += narrow_ticks(panel, (right - left) * figure.width);
    if (!panel.x_names.empty()) text += tick_names(panel.x_names, room.name_turn);
    text += scales(figure, panel, (right - left) * figure.width, (top - bottom) * figure.height, true);
    text += plot_command(panel, p) + scales_undone(figure, panel);
  }
  return text;
}

}  // namespace

std::string gnuplot_script(const Figure& asked) {
  Figure figure = asked;
  const FigureRoom room = make_room(figure);
  std::string text = "set encoding utf8\n";
  for (std::size_t p = 0; p < figure.panels.size(); ++p)
    for (std::size_t s = 0; s < figure.panels[p].series.size(); ++s)
      if (figure.panels[p].series[s].mark != Mark::level)
        text += data_block(figure.panels[p].series[s], block_name(p, s));
  text += fmt::format("set terminal svg size {},{} font \"sans-serif,13\" background \"white\" noenhanced\n",
                      figure.width, figure.height);
  text +=
      "set datafile missing \"NaN\"\nset grid lc rgb \"#E4E4E4\" lt 1\nset border 3 lc rgb \"#7A7A7A\"\nset tics "
      "nomirror\n";
  text += fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", room.left, room.right);
  text += fmt::format("set label 1 {} at screen {:.4f}, screen {:.4f} left font \",15\"\nset multiplot\n",
                      quoted_lines(room.title), room.title_left, 1.0 - kTitleMiddle / figure.height);
  if (figure.columns > 1) return text + grid_commands(figure, room) + "unset multiplot\nunset output\n";
  double total = 0.0;
  for (const Panel& panel : figure.panels) total += panel.share;
  const int key_rows = rows_of_key(figure, (kPanelRight - room.left) * figure.width);
  const double top_of_panels = 1.0 - (room.above + kKeyRow * key_rows + kAbovePanel) / figure.height;
  const double further_rows = kKeyRow * (key_rows - 1) / figure.height;
  const double space = (figure.maps ? 0.16 : 0.075) + further_rows;  // there the upper one's x axis may be written
  const double bottom_margin = room.below / figure.height;
  const double height = top_of_panels - bottom_margin - space * (static_cast<double>(figure.panels.size()) - 1.0);
  double top = top_of_panels;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const double bottom = top - height * figure.panels[p].share / total;
    text += panel_commands(figure, room, p, top, bottom, key_rows);
    top = bottom - space;
  }
  return text + "unset multiplot\nunset output\n";
}

}  // namespace lacuna
