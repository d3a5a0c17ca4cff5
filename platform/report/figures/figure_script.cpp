#include "report/figures/figure_script.h"

#include "report/figures/figure_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kLeast = 0.09, kRight = 0.98;  // of the figure's width, where panels begin at least, and end
constexpr double kFontSize = 13.0;              // pt
constexpr double kCharacter = 7.5;              // px, its width
constexpr double kTickCharacter = 9.75;         // px, what gnuplot keeps free for each of a y axis's numbers
constexpr double kRoomForLabel = 46.0;          // px, between a figure's edge and the numbers of its y axis
constexpr double kRoomForNames = 30.0;          // px, beside names of a y axis
constexpr double kMostForNames = 0.6;           // of the figure's width
constexpr double kRoomForTitle = 45.0;          // px, above everything else
constexpr double kKeyRow = 20.0;                // px
constexpr double kAbovePanel = 6.0;             // px, between a panel and its legend
constexpr double kRoomBelow = 66.0;             // px, for the ticks of the x axis and its label

std::string tick_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{} {}", i ? ", " : "", quoted_tick(names[i]), i);
  return fmt::format("set xtics ({}) rotate by -20\nset xrange [-0.5:{}]\n", text,
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

/// Of the longest number beside a y axis: the digits before the point, and as many behind it as tell some five ticks
/// apart.
int tick_characters(const Range& range) {
  constexpr int kFewest = 3, kMost = 9;
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (!(range.low <= range.high) || !(largest > 0.0)) return kFewest;
  const double span = range.high > range.low ? range.high - range.low : largest;
  const int before = std::max(1, static_cast<int>(std::floor(std::log10(largest))) + 1);
  const int behind = std::max(0, static_cast<int>(-std::floor(std::log10(span / 5.0))));
  return std::clamp((range.low < 0.0 ? 1 : 0) + before + (behind > 0 ? 1 + behind : 0), kFewest, kMost);
}

/// Names at 0, 1, ... downwards.
std::string y_tick_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{} {}", i ? ", " : "", quoted_tick(names[i]), i);
  return fmt::format("set ytics ({})\nset yrange [{}:-0.5]\n", text, static_cast<double>(names.size()) - 0.5);
}

constexpr int kPowerOfTen = 5;  ///< characters of "1e-06"

/// Powers of ten are written as such.
std::string scales(const Figure& figure, const Panel& panel) {
  std::string text = panel.log_y ? "set logscale y\nset format y \"%.0e\"\n" : "";
  if (figure.log_x) text += "set logscale x\nset format x \"%.0e\"\n";
  return text;
}

std::string scales_undone(const Figure& figure, const Panel& panel) {
  return panel.log_y || figure.log_x ? "unset logscale\nset format y \"%g\"\n" : "";
}

/// Where panels begin, as a share of the figure's width: the same for all, behind their longest numbers and the label.
double left_of(const Figure& figure) {
  int characters = 0;
  double named = 0.0;
  for (const Panel& panel : figure.panels) {
    characters = std::max(characters, panel.log_y ? kPowerOfTen : tick_characters(y_range(panel)));
    for (const std::string& name : panel.y_names)
      named = std::max(named, kCharacter * static_cast<double>(name.size()));
  }
  if (named > 0.0) return std::min(kMostForNames, (kRoomForNames + named) / figure.width);
  return std::max(kLeast, (kRoomForLabel + kTickCharacter * characters) / figure.width);
}

/// A label of an axis ("x" or "y") that is `length` px long, in smaller letters where it is longer than that.
std::string axis_label(const char* axis, const std::string& text, double length) {
  constexpr double kSmallest = 7.0;  // pt
  const double needed = kCharacter * static_cast<double>(text.size());
  const double size = std::max(kSmallest, kFontSize * std::min(1.0, length / std::max(needed, 1.0)));
  return fmt::format("set {}label {} font \",{:.3g}\"\n", axis, quoted(text), size);
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

/// How many rows the largest legend of a figure has, beside or below each other in so many px: all in one, or one each.
int rows_of_key(const Figure& figure, double room) {
  constexpr double kSample = 80.0;  // px: a line and the space beside it
  int most = 1;
  for (const Panel& panel : figure.panels) {
    double longest = 0.0;
    int labelled = 0;
    for (const Series& series : panel.series) {
      if (series.label.empty()) continue;
      longest = std::max(longest, kSample + kCharacter * static_cast<double>(series.label.size()));
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
std::string map_ranges(const Figure& figure, const Panel& panel, double height_share) {
  Range x, y;
  for (const Series& series : panel.series) {
    x.hold(series.x);
    y.hold(series.y);
  }
  if (!(x.low <= x.high) || !(y.low <= y.high)) return {};
  constexpr double kRoom = 1.1;  ///< around what is drawn
  const double width = (kRight - left_of(figure)) * figure.width, height = height_share * figure.height;
  double per_pixel = kRoom * std::max((x.high - x.low) / width, (y.high - y.low) / height);
  if (!(per_pixel > 0.0)) per_pixel = 1.0 / width;
  const Range across = x.widened(per_pixel * width), up = y.widened(per_pixel * height);
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", across.low, across.high, up.low, up.high);
}

std::string plot_command(const Panel& panel, std::size_t index) {
  std::string clauses;
  for (std::size_t s = 0; s < panel.series.size(); ++s)
    clauses += (s ? ", \\\n  " : "") + plot_clause(panel.series[s], block_name(index, s));
  std::string plot = "plot " + clauses + "\nunset label 1\n";
  if (!panel.y_range) return plot;
  const auto [low, high] = *panel.y_range;
  return fmt::format("set yrange [{:.9g}:{:.9g}]\n{}set yrange [*:*]\n", low, high, plot);
}

/// Few enough ticks on a narrow x axis that their numbers stay apart.
std::string narrow_ticks(const Panel& panel, double width) {
  Range range;
  for (const Series& series : panel.series) range.hold(series.x);
  if (!(range.low < range.high)) return {};
  const double apart = (range.high - range.low) * kTickCharacter * (tick_characters(range) + 2) / width;
  double tick = std::pow(10.0, std::floor(std::log10(apart)));
  for (const double factor : {2.0, 2.5, 2.0})  // 2, 5, 10 times
    if (tick < apart) tick *= factor;
  return fmt::format("set xtics {:.9g}\n", tick);
}

std::string panel_commands(const Figure& figure, std::size_t index, double top, double bottom, int key_rows) {
  const Panel& panel = figure.panels[index];
  const bool labelled = figure.maps || index + 1 == figure.panels.size();
  std::string text = fmt::format("set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n", top, bottom);
  text += key_above(top + kAbovePanel / figure.height, key_rows);
  text += axis_label("y", panel.y_label, (top - bottom) * figure.height);
  text += labelled ? "set xlabel " + quoted(figure.x_label) + "\nset format x \"%g\"\n"
                   : "unset xlabel\nset format x \"\"\n";
  if (figure.maps) text += map_ranges(figure, panel, top - bottom);
  if (!panel.x_names.empty()) text += tick_names(panel.x_names);
  if (!panel.y_names.empty()) text += y_tick_names(panel.y_names);
  if (figure.whole_x) text += whole_axis(figure);
  return text + scales(figure, panel) + plot_command(panel, index) + scales_undone(figure, panel);
}

bool is_labelled(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [](const Series& series) { return !series.label.empty(); });
}

/// One panel's legend stands for all where no other has one.
bool has_one_key(const Figure& figure) {
  return std::count_if(figure.panels.begin(), figure.panels.end(), is_labelled) == 1;
}

/// Panels in rows, each with its own axes.
std::string grid_commands(const Figure& figure) {
  constexpr double kBetweenRows = 62.0, kBetweenColumns = 84.0;  // px
  const int key_rows = has_one_key(figure) ? rows_of_key(figure, 0.8 * figure.width / figure.columns) : 0;
  const double top_of_grid = 1.0 - (kRoomForTitle + kKeyRow * key_rows) / figure.height;
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
    if (!panel.x_names.empty()) text += tick_names(panel.x_names);
    text += plot_command(panel, p);
  }
  return text;
}

}  // namespace

std::string gnuplot_script(const Figure& figure) {
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
  const bool named = std::any_of(figure.panels.begin(), figure.panels.end(),
                                 [](const Panel& panel) { return !panel.x_names.empty(); });
  text += fmt::format("set lmargin at screen {}\nset rmargin at screen {}\n", left_of(figure), named ? 0.93 : kRight);
  text += fmt::format("set label 1 {} at screen {:.4f}, screen {:.4f} left font \",15\"\nset multiplot\n",
                      quoted(figure.title), left_of(figure), 1.0 - 0.5 * kRoomForTitle / figure.height);
  if (figure.columns > 1) return text + grid_commands(figure) + "unset multiplot\nunset output\n";
  double total = 0.0;
  for (const Panel& panel : figure.panels) total += panel.share;
  const int key_rows = rows_of_key(figure, (kRight - left_of(figure)) * figure.width);
  const double top_of_panels = 1.0 - (kRoomForTitle + kKeyRow * key_rows + kAbovePanel) / figure.height;
  const double further_rows = kKeyRow * (key_rows - 1) / figure.height;
  const double space = (figure.maps ? 0.16 : 0.075) + further_rows;  // there the upper one's x axis may be written
  // Room for ticks and label, or for slanted names, in a low figure too.
  const double bottom_margin = std::max(named ? 0.26 : 0.12, kRoomBelow / figure.height);
  const double height = top_of_panels - bottom_margin - space * (static_cast<double>(figure.panels.size()) - 1.0);
  double top = top_of_panels;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const double bottom = top - height * figure.panels[p].share / total;
    text += panel_commands(figure, p, top, bottom, key_rows);
    top = bottom - space;
  }
  return text + "unset multiplot\nunset output\n";
}

}  // namespace lacuna
