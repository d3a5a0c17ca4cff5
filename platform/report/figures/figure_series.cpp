#include "report/figures/figure_series.h"

#include "foundation/text/plain_text.h"
#include "report/figures/thinning.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace lacuna {
namespace {

constexpr std::size_t kPixelColumns = 1000;

std::string replaced(std::string text, std::string_view part, std::string_view with) {
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + with.size()))
    text.replace(at, part.size(), with);
  return text;
}

std::string value_text(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : "NaN"; }

}  // namespace

std::string quoted(const std::string& text) {
  // gnuplot leaves both as they are, though the first is a character reference in SVG and the second ends a section.
  const std::string safe = replaced(replaced(plain_text(text), "&#x", "&#x26;#x"), "]]>", "]]&#x3E;");
  std::string result = "\"";
  for (const char c : safe) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ';
    // Four digits: behind a leading zero gnuplot reads so many, behind another digit one less.
    result += plain ? std::string(1, c) : fmt::format("\\0{:03o}", static_cast<unsigned char>(c));
  }
  return result + '"';
}

std::string quoted_tick(const std::string& text) { return quoted(replaced(text, "%", "%%")); }

std::string block_name(std::size_t panel, std::size_t series) { return fmt::format("$p{}s{}", panel, series); }

bool reaches(Mark mark) {
  return mark == Mark::band || mark == Mark::whiskers || mark == Mark::borders || mark == Mark::bars;
}

std::string data_block(const Series& series, const std::string& name) {
  std::string text = name + " << EOD\n";
  const auto row = [&](std::size_t i) {
    if (series.mark == Mark::line && !std::isfinite(series.y[i])) {  // a blank line interrupts the curve
      text += '\n';
      return;
    }
    text += value_text(series.x[i]) + ' ' + value_text(series.y[i]);
    if (reaches(series.mark)) text += ' ' + value_text(series.y2[i]);
    text += '\n';
  };
  if (series.mark == Mark::line)
    for (const std::size_t i : thinned(series.y, kPixelColumns)) row(i);
  else
    for (std::size_t i = 0; i < series.y.size(); ++i) row(i);
  return text + "EOD\n";
}

std::string plot_clause(const Series& series, const std::string& block) {
  const std::string title = series.label.empty() ? "notitle" : "title " + quoted(series.label);
  const std::string colour = "lc rgb " + quoted(series.colour.empty() ? kBlue : series.colour);
  switch (series.mark) {
    case Mark::line:
    case Mark::path: return fmt::format("{} using 1:2 with lines lw {:.2g} {} {}", block, series.width, colour, title);
    case Mark::whiskers:
      return fmt::format("{} using 1:2:(0):($3-$2) with vectors nohead lw 2 {} {}", block, colour, title);
    case Mark::borders:
      return fmt::format("{} using 1:2:(0):($3-$2) with vectors nohead dt 3 lw 1 {} {}", block, colour, title);
    case Mark::bars:
      return fmt::format("{} using (0):2:(0):1:($2-$3/2):($2+$3/2) with boxxyerror fs solid 0.8 noborder {} {}", block,
                         colour, title);
    case Mark::points: return fmt::format("{} using 1:2 with points pt 7 ps 0.4 {} {}", block, colour, title);
    case Mark::line_points:
      return fmt::format("{} using 1:2 with linespoints pt 7 ps 0.8 lw 1.6 {} {}", block, colour, title);
    case Mark::band:
      return fmt::format("{} using 1:2:3 with filledcurves fs solid 0.2 noborder {} {}", block, colour, title);
    case Mark::level: return fmt::format("{} with lines dt 2 lw 1.2 {} {}", value_text(series.y.at(0)), colour, title);
  }
  return {};
}

}  // namespace lacuna
