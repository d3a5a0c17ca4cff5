#include "figures/tables.h"

#include "cases/case_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace hidden_effects {
namespace {

using Chooser = std::function<bool(const FigureValue&)>;

struct Column {
  std::string heading;
  Chooser chosen;
};

bool in_percent(const FigureKind& figure) { return figure.kind == "share"; }

std::string number_text(const FigureKind& figure, double value) {
  return in_percent(figure) ? fmt::format("{:.1f}", 100.0 * value) : fmt::format("{:.3g}", value);
}

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

std::string head_of(const std::vector<std::string>& cells) {
  return row_of(cells) + row_of(std::vector<std::string>(cells.size(), "---"));
}

/// All values of a field, in the order of numbers where they are.
std::vector<std::string> values_of(const FigureValues& all, std::string FigureValue::*field) {
  std::set<std::string> different;
  for (const FigureValue& one : all.values) different.insert(one.*field);
  std::vector<std::string> sorted(different.begin(), different.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const std::string& a, const std::string& b) {
    return std::strtod(a.c_str(), nullptr) < std::strtod(b.c_str(), nullptr);
  });
  return sorted;
}

std::vector<Column> columns_of(const FigureValues& all, std::string FigureValue::*field, const Chooser& within) {
  std::vector<Column> columns;
  for (const std::string& value : values_of(all, field))
    columns.push_back({value, [=](const FigureValue& one) { return one.*field == value && within(one); }});
  return columns;
}

/// A line a figure; figures without any case are left out.
std::string figure_table(const FigureValues& all, const std::vector<Column>& columns) {
  std::vector<std::string> head = {"figure"};
  for (const Column& column : columns) head.push_back(column.heading);
  std::string table = head_of(head);
  for (const FigureKind& figure : all.figures) {
    std::vector<std::string> row = {figure.title};
    std::size_t n = 0;
    for (const Column& column : columns) {
      const Estimate estimate = estimate_of(all, figure, column.chosen);
      row.push_back(estimate_text(figure, estimate));
      n += estimate.n;
    }
    if (n > 0) table += row_of(row);
  }
  return table;
}

bool is_disturbed(const FigureValue& one) { return one.noise == to_string(NoiseLevel::disturbed); }
bool is_any(const FigureValue&) { return true; }

std::string goal_table(const FigureValues& all) {
  std::string table = head_of({"figure", "goal", "disturbed", "goal met", "coloured", "white", "all"});
  for (const FigureKind& figure : all.figures) {
    const auto at = [&](NoiseLevel level) {
      return estimate_of(all, figure, [&](const FigureValue& one) { return one.noise == to_string(level); });
    };
    const Estimate disturbed = at(NoiseLevel::disturbed);
    const bool judged = figure.has_goal() && disturbed.n > 0;
    table += row_of({figure.title, goal_text(figure), estimate_text(figure, disturbed),
                     judged ? (figure.met_by(disturbed.value) ? "yes" : "no") : "",
                     estimate_text(figure, at(NoiseLevel::coloured)), estimate_text(figure, at(NoiseLevel::white)),
                     estimate_text(figure, estimate_of(all, figure, is_any))});
  }
  return table;
}

/// A line an effect; one column a figure that says something about it.
std::string effect_table(const FigureValues& all) {
  std::vector<FigureKind> chosen;
  for (const FigureKind& figure : all.figures)
    for (const char* name :
         {"top1_1.5", "top1_3", "top1_10", "top3", "not_in_library", "true_set", "held_out", "coverage"})
      if (figure.name == name) chosen.push_back(figure);
  std::vector<std::string> head = {"effect"};
  for (const FigureKind& figure : chosen) head.push_back(figure.title);
  std::string table = head_of(head);
  for (const Column& effect : columns_of(all, &FigureValue::effect, is_any)) {
    if (effect.heading == "nothing") continue;
    std::vector<std::string> row = {effect.heading};
    for (const FigureKind& figure : chosen)
      row.push_back(estimate_text(figure, estimate_of(all, figure, effect.chosen)));
    table += row_of(row);
  }
  return table;
}

}  // namespace

std::string estimate_text(const FigureKind& figure, const Estimate& estimate) {
  if (estimate.n == 0) return "–";
  std::string words = number_text(figure, estimate.value) + (in_percent(figure) ? " %" : "");
  if (std::isfinite(estimate.lower_95))
    words += fmt::format(" [{}, {}]", number_text(figure, estimate.lower_95), number_text(figure, estimate.upper_95));
  return fmt::format("{} n {}", words, estimate.n);
}

std::string goal_text(const FigureKind& figure) {
  const double scale = in_percent(figure) ? 100.0 : 1.0;
  const char* const unit = in_percent(figure) ? " %" : "";
  if (std::isnan(figure.least) && std::isnan(figure.most)) return "";
  if (std::isnan(figure.most)) return fmt::format("≥ {:g}{}", scale * figure.least, unit);
  if (std::isnan(figure.least)) return fmt::format("≤ {:g}{}", scale * figure.most, unit);
  return fmt::format("{:g}–{:g}{}", scale * figure.least, scale * figure.most, unit);
}

std::string markdown(const FigureValues& all) {
  std::string page = fmt::format("# Hidden effects: {}, {}\n\n{} cases", all.set, version_text(all), all.cases);
  if (all.made < all.cases) page += fmt::format(", of which {} could not be made", all.cases - all.made);
  if (all.not_withheld > 0)
    page += fmt::format(
        " ({} more count nowhere: their effect was to be withheld, but a right answer was left in the library)",
        all.not_withheld);
  if (all.versions.size() > 2) page += fmt::format(", of {}", fmt::join(all.versions, ", "));
  page += ". An estimate, its 95 % interval and n, how many cases (or intervals of values) it rests on.\n\n";
  page += goal_table(all);
  for (const std::string& noise : values_of(all, &FigureValue::noise))
    page += fmt::format("\n## By strength, {} noise\n\n{}", noise,
                        figure_table(all, columns_of(all, &FigureValue::strength,
                                                     [&](const FigureValue& one) { return one.noise == noise; })));
  page += fmt::format("\n## By form of the hidden law, all noise\n\n{}",
                      figure_table(all, columns_of(all, &FigureValue::form, is_any)));
  page += fmt::format("\n## By rig, disturbed noise\n\n{}",
                      figure_table(all, columns_of(all, &FigureValue::rig, is_disturbed)));
  page += fmt::format("\n## By rig, all noise\n\n{}", figure_table(all, columns_of(all, &FigureValue::rig, is_any)));
  page += fmt::format("\n## By effect, all noise\n\n{}", effect_table(all));
  return page;
}

}  // namespace hidden_effects
