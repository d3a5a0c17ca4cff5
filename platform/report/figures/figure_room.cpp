#include "report/figures/figure_room.h"

#include "report/figures/figure_series.h"
#include "report/figures/text_lines.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kPanelLeft = 0.09;       // of the figure's width, where panels begin at least
constexpr double kRoomForLabel = 46.0;    // px, between a figure's edge and the numbers of its y axis
constexpr double kRoomForNames = 30.0;    // px, beside names of a y axis
constexpr double kMostForNames = 0.45;    // of the figure's width
constexpr double kNameLine = 17.0;        // px, its height
constexpr double kBetweenNames = 10.0;    // px
constexpr double kTitleLetter = 8.7;      // px
constexpr double kTitleLine = 20.0;       // px
constexpr double kTitleLeft = 0.02;       // of the figure's width, where a long title begins
constexpr double kRoomForTitle = 45.0;    // px, above everything else
constexpr double kRoomBelow = 66.0;       // px, for the ticks of the x axis and its label
constexpr double kUsuallyBelow = 0.12;    // of the figure's height
constexpr double kUsuallyNamed = 0.26;    // the same, below an axis of names
constexpr int kTurned = 40;               // degrees
constexpr int kPowerOfTen = 6;            // letters of "0.0001"
constexpr double kRadian = 57.295779513;  // degrees

std::size_t letters_in(double pixels, double letter) {
  return static_cast<std::size_t>(std::max(pixels / letter, 1.0));
}

void hold(std::optional<std::array<double, 2>>& range, const std::vector<double>& values, bool above_zero) {
  for (const double value : values) {
    if (!std::isfinite(value) || (above_zero && !(value > 0.0))) continue;
    if (!range) range = {{value, value}};
    (*range)[0] = std::min((*range)[0], value);
    (*range)[1] = std::max((*range)[1], value);
  }
}

/// Where panels begin: the same for all, behind their longest numbers and the label, or their names.
double left_of(const Figure& figure) {
  int letters = 0;
  double named = 0.0;
  for (const Panel& panel : figure.panels) {
    const auto range = range_along_y(panel, false);
    letters = std::max(letters, panel.log_y ? kPowerOfTen : range ? tick_letters((*range)[0], (*range)[1]) : 0);
    for (const std::string& name : panel.y_names)
      named = std::max(named, kLetter * static_cast<double>(longest_of(y_name_lines(figure, name))));
  }
  if (named > 0.0) return (kRoomForNames + named) / figure.width;
  return std::max(kPanelLeft, (kRoomForLabel + kTickLetter * letters) / figure.width);
}

void set_title(Figure& figure, FigureRoom& room) {
  const double beside = (kPanelRight - room.left) * figure.width;
  const bool fits = kTitleLetter * static_cast<double>(letters_of(figure.title)) <= beside;
  room.title_left = fits ? room.left : kTitleLeft;
  room.title = lines_of(figure.title, letters_in((kPanelRight - room.title_left) * figure.width, kTitleLetter));
  const double further = kTitleLine * static_cast<double>(room.title.size() - 1);
  room.above = kRoomForTitle + further;
  figure.height += static_cast<int>(further);
}

/// Where an axis has to end for its turned names to end within the figure.
double right_of_turned(const Figure& figure, const std::vector<std::string>& names, double left) {
  constexpr double kLeast = 0.5;
  double right = kPanelRight;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double length = kLetter * static_cast<double>(letters_of(names[i])) * std::cos(kTurned / kRadian);
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(names.size());
    right = std::min(right, left + (1.0 - left - (length + kBetweenNames) / figure.width) / place);
  }
  return std::max(right, kLeast);
}

/// The room of names below an x axis, px; turns them where they would not fit beside each other.
double room_for_x_names(const Figure& figure, FigureRoom& room) {
  double below = 0.0;
  for (const Panel& panel : figure.panels) {
    if (panel.x_names.empty()) continue;
    const double longest = kLetter * static_cast<double>(longest_of(panel.x_names));
    const double slot = (kPanelRight - room.left) * figure.width / static_cast<double>(panel.x_names.size());
    below = std::max(below, kNameLine + kBetweenNames);
    if (longest + kLetter <= slot) continue;
    room.name_turn = kTurned;
    below = std::max(below, longest * std::sin(kTurned / kRadian) + kNameLine + kBetweenNames);
    room.right = std::min(room.right, right_of_turned(figure, panel.x_names, room.left));
  }
  return below;
}

void set_room_below(Figure& figure, FigureRoom& room) {
  const double names = room_for_x_names(figure, room);
  room.x_label = lines_of(figure.x_label, letters_in((room.right - room.left) * figure.width, kLetter));
  const double further = kNameLine * static_cast<double>(room.x_label.size() - 1);
  const double usual = (names > 0.0 ? kUsuallyNamed : kUsuallyBelow) * figure.height;
  const double label = figure.x_label.empty() ? 0.0 : kNameLine;
  room.below = std::max({usual, kRoomBelow, names + label}) + further;
  figure.height += static_cast<int>(room.below - std::max(usual, kRoomBelow));
}

/// Rows are as high as their names.
void grow_for_y_names(Figure& figure, const FigureRoom& room) {
  double total = 0.0, needed = 0.0;
  for (const Panel& panel : figure.panels) total += panel.share;
  for (const Panel& panel : figure.panels) {
    std::size_t lines = 0;
    for (const std::string& name : panel.y_names) lines = std::max(lines, y_name_lines(figure, name).size());
    const double rows = static_cast<double>(panel.y_names.size());
    const double height = rows * (kNameLine * static_cast<double>(lines) + kBetweenNames);
    needed = std::max(needed, height * total / panel.share);
  }
  const double there = figure.height - room.above - room.below;
  figure.height += static_cast<int>(std::max(0.0, needed - there));
}

}  // namespace

std::optional<std::array<double, 2>> range_along_y(const Panel& panel, bool above_zero) {
  std::optional<std::array<double, 2>> range;
  for (const Series& series : panel.series) {
    hold(range, series.y, above_zero);
    if (series.mark != Mark::bars) hold(range, series.y2, above_zero);
  }
  return range;
}

std::optional<std::array<double, 2>> range_along_x(const Figure& figure, bool above_zero) {
  std::optional<std::array<double, 2>> range;
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series) hold(range, series.x, above_zero);
  return range;
}

int tick_letters(double low, double high) {
  constexpr int kFewest = 3, kMost = 9;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (!(low <= high) || !(largest > 0.0)) return kFewest;
  const double span = high > low ? high - low : largest;
  const int before = std::max(1, static_cast<int>(std::floor(std::log10(largest))) + 1);
  const int behind = std::max(0, static_cast<int>(-std::floor(std::log10(span / 5.0))));
  return std::clamp((low < 0.0 ? 1 : 0) + before + (behind > 0 ? 1 + behind : 0), kFewest, kMost);
}

bool is_visible(const Series& series) {
  if (series.mark == Mark::level) return !series.y.empty() && std::isfinite(series.y.front());
  for (std::size_t i = 0; i < series.y.size(); ++i)
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]) &&
        (!reaches(series.mark) || std::isfinite(series.y2[i])))
      return true;
  return false;
}

std::vector<std::string> y_name_lines(const Figure& figure, const std::string& name) {
  return lines_of(name, letters_in(kMostForNames * figure.width - kRoomForNames, kLetter));
}

FigureRoom make_room(Figure& figure) {
  FigureRoom room;
  room.left = left_of(figure);
  set_title(figure, room);
  set_room_below(figure, room);
  grow_for_y_names(figure, room);
  return room;
}

}  // namespace lacuna
