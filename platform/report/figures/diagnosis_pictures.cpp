#include "report/figures/diagnosis_pictures.h"

#include "foundation/statistics.h"
#include "foundation/text/unit_text.h"
#include "report/figures/figure.h"
#include "report/figures/file_name.h"
#include "report/text/diagnosis_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kMostRanked = 12;  // bars
constexpr double kBar = 0.5;             // of the distance between bars

void add_curve(const ForceCurve& curve, const std::string& label, const char* colour, Panel& panel) {
  Series band{"", Mark::band, colour, curve.at, {}, {}},
      force{label, Mark::line_points, colour, curve.at, curve.force, {}};
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    band.y.push_back(curve.force[i] - kWithin95 * curve.standard_error[i]);
    band.y2.push_back(curve.force[i] + kWithin95 * curve.standard_error[i]);
  }
  panel.series.push_back(std::move(band));
  panel.series.push_back(std::move(force));
}

Panel empty_panel(const ForceCurve& curve) {
  const char* which = curve.by_answer.empty() ? "unexplained" : "missing";
  Panel panel{fmt::format("{} {} [{}]", which, force_word(curve.force_unit), unit_text(curve.force_unit)),
              {{"", Mark::level, kInk, {}, {0.0}, {}}},
              1.0,
              {}};
  panel.x_label = curve.of + " [" + unit_text(curve.unit) + "]";
  return panel;
}

/// One panel for each quantity, and one for all slices: a map of the force over velocity and position.
std::vector<Panel> force_panels(const std::vector<ForceCurve>& curves, const std::string& joint) {
  constexpr std::array kColours = {kBlue, kOrange, kGreen};
  std::vector<Panel> panels;
  std::optional<Panel> slices;
  std::size_t slice = 0;
  for (const ForceCurve& curve : curves) {
    if (curve.joint != joint) continue;
    if (!curve.position) {
      panels.push_back(empty_panel(curve));
      add_curve(curve,
                curve.by_answer.empty() ? "" : fmt::format("missing {}, 95 % band", force_word(curve.force_unit)),
                kOrange, panels.back());
      if (!curve.by_answer.empty())
        panels.back().series.push_back({"answer", Mark::line, kBlue, curve.at, curve.by_answer, {}});
      continue;
    }
    if (!slices) slices = empty_panel(curve);
    const std::string position_unit = curve.unit.substr(0, curve.unit.find('/'));
    add_curve(curve, fmt::format("at {:.2f} {}", *curve.position, position_unit), kColours[slice++ % kColours.size()],
              *slices);
  }
  if (slices) panels.push_back(std::move(*slices));
  return panels;
}

/// Forces on one joint.
Figure force_figure(const std::vector<ForceCurve>& curves, const std::string& joint, const std::string& title) {
  Figure figure{title, "", force_panels(curves, joint)};
  figure.columns = figure.panels.size() == 4 ? 2 : static_cast<int>(figure.panels.size());
  figure.x_label = figure.panels.front().x_label;  // where there is one column only
  figure.same_y = true;
  figure.height = figure.panels.size() == 4 ? 700 : 380;
  return figure;
}

/// "torque" or "force", of the joint's curves.
const char* word_on(const std::vector<ForceCurve>& curves, const std::string& joint) {
  const auto found =
      std::find_if(curves.begin(), curves.end(), [&](const ForceCurve& one) { return one.joint == joint; });
  return found == curves.end() ? "force" : force_word(found->force_unit);
}

/// What the model lacks, and what the answer makes of it.
Figure missing_figure(const Diagnosis& diagnosis, const std::string& joint, const std::string& title) {
  return force_figure(
      diagnosis.missing_force, joint,
      fmt::format("{} · missing {} on joint.{}", title, word_on(diagnosis.missing_force, joint), joint));
}

/// The force that no effect explains, with its formula if there is one.
Figure residual_figure(const Diagnosis& diagnosis, const std::string& joint, const std::string& title) {
  std::string whole = fmt::format("{} · {} on joint.{}", title, word_on(diagnosis.residual_force, joint), joint);
  for (const ForceFormula& formula : diagnosis.formulas)
    if (formula.joint == joint) whole += fmt::format(": {} {}", formula.text(), unit_text(formula.unit));
  return force_figure(diagnosis.residual_force, joint, whole);
}

std::vector<std::string> joints_of(const std::vector<ForceCurve>& curves) {
  std::vector<std::string> joints;
  for (const ForceCurve& curve : curves)
    if (std::find(joints.begin(), joints.end(), curve.joint) == joints.end()) joints.push_back(curve.joint);
  return joints;
}

std::string name_of(const RankedModel& model) {
  std::vector<std::string> names;
  for (const FoundEffect& effect : model.effects) names.push_back(effect.effect + " @ " + effect.where);
  return fmt::format("{}", fmt::join(names, " + "));
}

/// A bar of the ranking.
struct RankedRow {
  std::string name;
  Gain gain;
  bool is_answer = false;
};

/// The candidates, the answer first.
std::vector<RankedRow> ranked_rows(const Diagnosis& diagnosis) {
  std::vector<RankedRow> rows;
  for (const RankedModel& model : diagnosis.ranking)
    if (rows.size() < kMostRanked)
      rows.push_back({name_of(model), model.gain, diagnosis.verdict == Verdict::effect_found && rows.empty()});
  return rows;
}

Series bars_of(const std::vector<RankedRow>& rows, bool answers) {
  Series bars{answers ? "answer" : "other candidates", Mark::bars, answers ? kBlue : kGrey, {}, {}, {}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].is_answer != answers) continue;
    bars.x.push_back(rows[row].gain.value);
    bars.y.push_back(static_cast<double>(row));
  }
  bars.y2.assign(bars.y.size(), kBar);
  return bars;
}

Series intervals_of(const std::vector<RankedRow>& rows) {
  Series interval{"95 % interval", Mark::line, kInk, {}, {}, {}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double y = static_cast<double>(row);
    interval.x.insert(interval.x.end(), {rows[row].gain.lower_95, rows[row].gain.upper_95, std::nan("")});
    interval.y.insert(interval.y.end(), {y, y, std::nan("")});  // the last lifts the pen
  }
  return interval;
}

/// Horizons over which gains are means.
const char* deciding_horizons(const Diagnosis& diagnosis) {
  const auto all = diagnosis.evidence.find("all_lengths");
  return all != diagnosis.evidence.end() && all->second > 0.0 ? "all horizons" : "the three shortest horizons";
}

Figure ranking_figure(const Diagnosis& diagnosis, const std::string& title) {
  const std::vector<RankedRow> rows = ranked_rows(diagnosis);
  Panel panel{"", {bars_of(rows, true), bars_of(rows, false), intervals_of(rows)}, 1.0, {}};
  if (panel.series.front().x.empty()) panel.series[1].label = "held-out gain";  // no answer
  for (const RankedRow& row : rows) panel.y_names.push_back(row.name);
  std::string label =
      fmt::format("cross-validated gain over {} [nats; 0.69 is half the error]", deciding_horizons(diagnosis));
  if (diagnosis.method == DiagnosisMethod::likelihood) label = "gain: increase of the held-out log likelihood [nats]";
  Figure figure{fmt::format("{} · {}", title, verdict_text(diagnosis)), label, {panel}};
  figure.height = 200 + 44 * static_cast<int>(rows.size());
  return figure;
}

/// Errors of predictions over their horizon, a panel a channel.
Figure horizons_figure(const Diagnosis& diagnosis, const std::string& title) {
  std::map<std::string, Panel> panels;
  for (const HorizonError& error : diagnosis.horizons) {
    Panel& panel = panels[error.channel];
    if (panel.series.empty()) {
      panel.y_label = fmt::format("{} [{}]", error.channel, error.unit);
      panel.log_y = true;
      panel.series = {{"null model", Mark::line_points, kOrange, {}, {}, {}},
                      {"with the answer", Mark::line_points, kBlue, {}, {}, {}},
                      {"with the answer, held out", Mark::line_points, kGreen, {}, {}, {}},
                      {"floor", Mark::line, kGrey, {}, {}, {}}};
    }
    const std::array values = {error.base, error.answer, error.answer_held_out, error.floor};
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!(values[i] > 0.0)) continue;
      panel.series[i].x.push_back(error.horizon);
      panel.series[i].y.push_back(values[i]);
    }
  }
  Figure figure{fmt::format("{} · prediction error", title), "horizon [s]", {}};
  for (auto& [channel, panel] : panels) {
    std::erase_if(panel.series, [](const Series& series) { return series.x.empty(); });
    figure.panels.push_back(std::move(panel));
  }
  figure.log_x = true;
  figure.height = 200 + 260 * static_cast<int>(figure.panels.size());
  return figure;
}

}  // namespace

std::vector<std::filesystem::path> draw_diagnosis(const Diagnosis& diagnosis, const std::string& title,
                                                  const std::filesystem::path& folder, const Stop& stop) {
  std::vector<std::filesystem::path> files;
  FileNames names;
  const auto draw = [&](const Figure& figure, const std::string& name) {
    files.push_back(folder / names.next(name));
    write_svg(figure, files.back(), stop);
  };
  if (!diagnosis.horizons.empty()) draw(horizons_figure(diagnosis, title), "errors-by-horizon.svg");
  if (!ranked_rows(diagnosis).empty()) draw(ranking_figure(diagnosis, title), "ranking.svg");
  for (const std::string& joint : joints_of(diagnosis.missing_force))
    draw(missing_figure(diagnosis, joint, title), "missing-force-" + joint + ".svg");
  for (const std::string& joint : joints_of(diagnosis.residual_force))
    draw(residual_figure(diagnosis, joint, title), "residual-force-" + joint + ".svg");
  return files;
}

}  // namespace lacuna
