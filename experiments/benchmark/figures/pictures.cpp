#include "figures/pictures.h"

#include "figures/matrix_picture.h"
#include "foundation/processes/interrupt.h"
#include "report/figures/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hidden_effects {
namespace {

using lacuna::Figure;
using lacuna::Mark;
using lacuna::Panel;
using lacuna::Series;

constexpr int kBins = 10;
constexpr std::size_t kMany = 10;          ///< verdicts in a bin that say something
constexpr double kApart = 0.04;            ///< of the cases, from a point of the accuracy to the next
constexpr std::array kWhole = {0.0, 1.0};  ///< a share's axis

std::vector<Stated> stated_of(const FigureValues& all) {
  std::vector<Stated> stated;
  for (const FigureValue& one : all.values)
    if (one.figure == "calibration") stated.push_back({one.probability, one.value});
  return stated;
}

std::string title_of(const char* what, const FigureValues& all, std::size_t n) {
  return fmt::format("{} · {} cases, {} · n {}", what, all.set, version_text(all), n);
}

void add_interval(double x, const Estimate& estimate, Series& intervals) {
  intervals.x.push_back(x);
  intervals.y.push_back(estimate.lower_95);
  intervals.y2.push_back(estimate.upper_95);
}

Figure reliability(const FigureValues& all, const std::vector<Stated>& stated) {
  std::array<std::vector<double>, kBins> right, said;
  for (const Stated& one : stated) {
    const auto bin = static_cast<std::size_t>(std::clamp(static_cast<int>(one.probability * kBins), 0, kBins - 1));
    right[bin].push_back(one.is_right);
    said[bin].push_back(one.probability);
  }
  Series points{"by tenths of the probability", Mark::points, lacuna::kInk, {}, {}, {}};
  Series many{"95 % interval, ten verdicts or more", Mark::whiskers, lacuna::kBlue, {}, {}, {}};
  Series few{"95 % interval, fewer", Mark::whiskers, lacuna::kGrey, {}, {}, {}};
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    if (right[bin].empty()) continue;
    const Estimate estimate = share(right[bin]);
    points.x.push_back(mean(said[bin]));
    points.y.push_back(estimate.value);
    add_interval(points.x.back(), estimate, estimate.n >= kMany ? many : few);
  }
  const Series ideal{"as stated", Mark::line, lacuna::kGrey, {0.0, 1.0}, {0.0, 1.0}, {}};
  return {title_of("Reliability of the verdicts", all, stated.size()),
          "stated probability",
          {Panel{"share that is right", {ideal, many, few, points}, 1.0, {}, {}, {}, false, kWhole}}};
}

/// The surest verdicts first; those that say `cannot_tell`, and cases that ended early, never count as given. Verdicts
/// of one probability come together; of points that would stand too close the first is drawn.
Figure accuracy(const FigureValues& all, std::vector<Stated> stated) {
  std::stable_sort(stated.begin(), stated.end(),
                   [](const Stated& a, const Stated& b) { return a.probability > b.probability; });
  Series points{"the surest verdicts", Mark::points, lacuna::kInk, {}, {}, {}};
  Series intervals{"95 % interval", Mark::whiskers, lacuna::kBlue, {}, {}, {}};
  std::vector<double> right;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    right.push_back(stated[i].is_right);
    const bool last = i + 1 == stated.size();
    if (!last && stated[i + 1].probability == stated[i].probability) continue;
    const double coverage = static_cast<double>(i + 1) / static_cast<double>(all.made);
    if (!last && !points.x.empty() && coverage < points.x.back() + kApart) continue;
    const Estimate estimate = share(right);
    points.x.push_back(coverage);
    points.y.push_back(estimate.value);
    add_interval(coverage, estimate, intervals);
  }
  return {title_of("Accuracy against coverage", all, all.made) +
              fmt::format(", of which {} state a probability", stated.size()),
          "share of the cases, the surest verdicts first",
          {Panel{"share of their verdicts that is right", {intervals, points}, 1.0, {}, {}, {}, false, kWhole}}};
}

Matrix confusion(const Database& database, const FigureValues& all) {
  Matrix matrix;
  for (const Row& row : database.query("SELECT hidden, named, count(*) FROM confusion "
                                       "WHERE version IN (SELECT value FROM json_each(?)) AND set_name = ? "
                                       "GROUP BY hidden, named",
                                       {list_cell(all.versions), all.set}))
    matrix.count[text(row[0])][text(row[1])] = static_cast<int>(integer(row[2]));
  matrix.title = fmt::format("Hidden effect and the first that is named · {} cases, {}", all.set, version_text(all));
  matrix.note =
      "Framed: the hidden effect itself. Dark: a large share of the row. Cases with two hidden effects are left out.";
  matrix.row_title = "hidden";
  matrix.column_title = "named first";
  return matrix;
}

}  // namespace

void draw_pictures(const Database& database, const FigureValues& all, const std::filesystem::path& folder) {
  const std::vector<Stated> stated = stated_of(all);
  if (!stated.empty()) {
    lacuna::write_svg(reliability(all, stated), folder / "reliability.svg", lacuna::when_interrupted());
    lacuna::write_svg(accuracy(all, stated), folder / "accuracy.svg", lacuna::when_interrupted());
  }
  write_matrix(confusion(database, all), folder / "confusion.svg");
}

}  // namespace hidden_effects
