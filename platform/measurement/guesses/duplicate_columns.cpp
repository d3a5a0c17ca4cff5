#include "measurement/guesses/duplicate_columns.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

constexpr double kSameReadings = 5e-3;  // RMS difference over the span

bool is_of_motion(ColumnRole role) {
  return role == ColumnRole::position || role == ColumnRole::velocity || role == ColumnRole::command ||
         role == ColumnRole::reference;
}

bool say_the_same(const std::vector<double>& a, double a_to_si, const std::vector<double>& b, double b_to_si) {
  double squares = 0.0, count = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) continue;
    squares += std::pow(a[i] * a_to_si - b[i] * b_to_si, 2);
    count += 1.0;
    lowest = std::min(lowest, a[i] * a_to_si);
    highest = std::max(highest, a[i] * a_to_si);
  }
  return count > 0.0 && highest > lowest && std::sqrt(squares / count) <= kSameReadings * (highest - lowest);
}

}  // namespace

void leave_out_duplicates(const FileSample& sample, std::vector<GuessedColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = i + 1; j < columns.size(); ++j) {
      if (!is_of_motion(columns[i].role) || columns[i].role != columns[j].role) continue;
      const std::optional<Unit> a = parse_unit(columns[i].unit), b = parse_unit(columns[j].unit);
      if (!a || !b || !a->same_dimension(*b) || columns[i].unit == columns[j].unit) continue;
      if (!say_the_same(sample.columns[i], a->to_si, sample.columns[j], b->to_si)) continue;
      const bool second = b->to_si == 1.0 && a->to_si != 1.0;
      GuessedColumn& kept = columns[second ? j : i];
      GuessedColumn& left = columns[second ? i : j];
      left.role = ColumnRole::other;
      left.reason = fmt::format("`{}` in another unit", kept.name);
    }
}

}  // namespace lacuna
