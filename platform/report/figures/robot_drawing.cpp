#include "report/figures/robot_drawing.h"

#include "foundation/text/plain_text.h"
#include "foundation/files/whole_file.h"
#include "report/figures/robot_sketch.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

using Eigen::AlignedBox2d;

constexpr double kMargin = 12.0, kTop = 46.0, kLegendRow = 20.0;  // px
constexpr double kLabel = 28.0, kCaption = 20.0;                  // px above drawings
constexpr double kAround = 8.0;                                   // px about a drawing
constexpr double kLeastWidth = 640.0;                             // px, which the title takes
constexpr double kLetter = 7.0, kBoldLetter = 9.0;                // px, their width

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : plain_text(text))
    safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return safe;
}

std::string text_at(double x, double y, const std::string& text, int size, const char* weight = "normal") {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"{}\" font-weight=\"{}\">{}</text>\n", x, y, size,
                     weight, escaped(text));
}

/// A sketch with what stands above it.
struct Drawing {
  explicit Drawing(const DrawnRobot& drawn) : sketch(drawn.robot), caption(drawn.caption) {
    if (sketch.scale() < 1.0) caption += fmt::format(" (scale {:.2g})", sketch.scale());
  }
  RobotSketch sketch;
  std::string caption;
};

/// Drawings in rows and columns that are as high and wide as what is in them.
class Sheet {
 public:
  explicit Sheet(const std::vector<RobotRow>& rows) : rows_(rows) {
    for (const RobotRow& row : rows) {
      std::vector<Drawing>& drawings = drawings_.emplace_back();
      AlignedBox2d& high = heights_.emplace_back();
      for (const DrawnRobot& robot : row.robots) {
        const AlignedBox2d box = drawings.emplace_back(robot).sketch.box();
        high.extend(box);
        if (columns_.size() < drawings.size()) columns_.emplace_back();
        Column& column = columns_[drawings.size() - 1];
        column.box.extend(box);
        column.caption = std::max(column.caption, kLetter * static_cast<double>(drawings.back().caption.size()));
      }
    }
  }

  double width() const {
    double width = 2.0 * kMargin;
    for (const Column& column : columns_) width += column.width();
    for (const RobotRow& row : rows_)
      width = std::max(width, 2.0 * kMargin + kBoldLetter * static_cast<double>(row.label.size()));
    return std::max(kLeastWidth, width);
  }

  /// Draws from `top` on, and moves it below the last row.
  std::string svg(double& top) const {
    std::string text;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      text += text_at(kMargin, top + 18.0, rows_[row].label, 13, "bold");
      top += kLabel;
      double left = kMargin;
      for (std::size_t column = 0; column < drawings_[row].size(); ++column) {
        const Drawing& drawing = drawings_[row][column];
        const double across = columns_[column].width();
        text += text_at(left, top + 13.0, drawing.caption, 12);
        text += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n",
                            left + 0.5 * across - columns_[column].box.center().x(),
                            top + kCaption + kAround - heights_[row].min().y(), drawing.sketch.svg());
        left += across;
      }
      top += kCaption + (drawings_[row].empty() ? 0.0 : heights_[row].sizes().y() + 2.0 * kAround);
    }
    return text;
  }

 private:
  struct Column {
    AlignedBox2d box;
    double caption = 0.0;  ///< length of the longest, px
    double width() const { return 2.0 * kAround + std::max(caption, box.sizes().x()); }
  };

  const std::vector<RobotRow>& rows_;
  std::vector<std::vector<Drawing>> drawings_;
  std::vector<AlignedBox2d> heights_;  ///< of rows
  std::vector<Column> columns_;
};

struct LegendEntry {
  std::string text;
  std::string sign;  ///< some 20 px wide, from 0
};

/// Names of parts by index, as the first robot has them that has so many; a sign of what is below the ground, and of
/// beacons where there are some.
std::vector<LegendEntry> legend_of(const std::vector<RobotRow>& rows) {
  std::vector<LegendEntry> entries;
  const auto stroke = [](const char* colour, double opacity) {
    return svg_line({0, 0}, {18, 0}, 7.0, colour, opacity);
  };
  bool beacons = false;
  for (const RobotRow& row : rows)
    for (const DrawnRobot& drawn : row.robots) {
      for (std::size_t i = entries.size(); i < drawn.robot.bodies.size(); ++i)
        entries.push_back({drawn.robot.bodies[i].name, stroke(part_colour(i), 1.0)});
      for (const SensorSpec& sensor : drawn.robot.sensors) beacons = beacons || sensor.kind == SensorKind::beacon_range;
    }
  entries.push_back({"pale: below the ground", stroke(part_colour(1), kBelowGround)});
  if (beacons) entries.push_back({"beacon", svg_dot({9, 0})});
  entries.push_back({"squares are 1 m wide", ""});
  return entries;
}

/// Beside each other as far as there is room; moves `top` below them.
std::string legend(const std::vector<LegendEntry>& entries, double width, double& top) {
  constexpr double kSign = 24.0, kBetween = 18.0;  // px
  std::string text;
  double left = kMargin;
  for (const LegendEntry& entry : entries) {
    const double indent = entry.sign.empty() ? 0.0 : kSign;
    const double wide = indent + kLetter * static_cast<double>(entry.text.size());
    if (left > kMargin && left + wide > width - kMargin) {
      left = kMargin;
      top += kLegendRow;
    }
    if (!entry.sign.empty())
      text += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n", left, top + 6.0, entry.sign);
    text += text_at(left + indent, top + 10.0, entry.text, 12);
    left += wide + kBetween;
  }
  top += kLegendRow;
  return text;
}

std::string picture_of(const std::string& title, const std::vector<RobotRow>& rows) {
  const Sheet sheet(rows);
  const double width = sheet.width();
  double height = kTop;
  std::string content = text_at(kMargin, 26.0, title, 15);
  content += legend(legend_of(rows), width, height);
  content += sheet.svg(height);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" fill=\"#3A3A3A\">\n"
             "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#FFFFFF\"/>\n",
             width, height) +
         content + "</svg>\n";
}

}  // namespace

void write_robots_svg(const std::string& title, const std::vector<RobotRow>& rows, const std::filesystem::path& file) {
  write_whole(file, picture_of(title, rows), Link::replaced);
}

}  // namespace lacuna
