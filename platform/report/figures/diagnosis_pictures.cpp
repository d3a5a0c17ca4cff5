#include "report/figures/diagnosis_pictures.h"

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

constexpr double k95 = 1.96;             // standard errors
constexpr std::size_t kMostRanked = 12;  // bars
constexpr double kBar = 0.5;             // of the distance between bars

void add_curve(const ForceCurve& curve, const std::string& label, const char* colour, Panel& panel) {
  Series band{"", Mark::band, colour, curve.at, {}, {}},
      force{label, Mark::line_points, colour, curve.at, curve.force, {}};
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    band.y.push_back(curve.force[i] - k95 * curve.standard_error[i]);
    band.y2.push_back(curve.force[i] + k95 * curve.standard_error[i]);
  }
  panel.series.push_back(std::move(band));
  panel.series.push_back(std::move(force));
}

Panel empty_panel(const ForceCurve& curve) {
  Panel panel{"unexplained force [" + curve.force_unit + "]", {{"", Mark::level, kInk, {}, {0.0}, {}}}, 1.0, {}};
  panel.x_label = curve.of + " [" + curve.unit + "]";
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
      add_curve(curve, "", kOrange, panels.back());
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

/// The force on one joint, and the formula for it if there is one.
Figure force_figure(const Diagnosis& diagnosis, const std::string& joint, const std::string& title) {
  Figure figure{fmt::format("{} · force on joint.{}", title, joint), "", {}};
  for (const ForceFormula& formula : diagnosis.formulas)
    if (formula.joint == joint) figure.title += fmt::format(": {} {}", formula.text(), formula.unit);
  figure.panels = force_panels(diagnosis.residual_force, joint);
  figure.columns = figure.panels.size() == 4 ? 2 : static_cast<int>(figure.panels.size());
  figure.x_label = figure.panels.front().x_label;  // where there is one column only
  figure.same_y = true;
  figure.height = figure.panels.size() == 4 ? 700 : 380;
  return figure;
}

std::vector<std::string> joints_of(const Diagnosis& diagnosis) {
  std::vector<std::string> joints;
  for (const ForceCurve& curve : diagnosis.residual_force)
    if (std::find(joints.begin(), joints.end(), curve.joint) == joints.end()) joints.push_back(curve.joint);
  return joints;
}

std::string name_of(const RankedModel& model) {
  std::vector<std::string> names;
  for (const FoundEffect& effect : model.effects) names.push_back(effect.effect + " @ " + effect.where);
  return fmt::format("{}", fmt::join(names, " + "));
}

Figure ranking_figure(const Diagnosis& diagnosis, const std::string& title) {
  Series gain{"held-out gain", Mark::bars, kBlue, {}, {}, {}};
  Series interval{"95 % interval", Mark::line, kInk, {}, {}, {}};
  Panel panel{"", {}, 1.0, {}};
  for (const RankedModel& model : diagnosis.ranking) {
    if (panel.y_names.size() == kMostRanked) break;
    const auto row = static_cast<double>(panel.y_names.size());
    panel.y_names.push_back(name_of(model));
    gain.x.push_back(model.gain.value);
    gain.y.push_back(row);
    for (const double end : {model.gain.lower_95, model.gain.upper_95}) {
      interval.x.push_back(end);
      interval.y.push_back(row);
    }
    interval.x.push_back(std::nan(""));  // lifts the pen
    interval.y.push_back(std::nan(""));
  }
  const auto rows = static_cast<double>(panel.y_names.size());
  gain.y2.assign(panel.y_names.size(), kBar);
  panel.series = {gain, interval};
  std::string label = "how much lower the mean log error is than the model's, where not fitted [nats; 0.69: half]";
  if (diagnosis.horizons.empty()) {
    label = "held-out log likelihood over the model [nats]";
    panel.series.push_back(
        {"chance, 95 %", Mark::path, kOrange, {diagnosis.chance_95, diagnosis.chance_95}, {-0.5, rows - 0.5}, {}});
  }
  Figure figure{fmt::format("{} · {}", title, verdict_text(diagnosis)), label, {panel}};
  figure.height = 200 + 44 * static_cast<int>(panel.y_names.size());
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
      panel.series = {{"the model as it is", Mark::line_points, kOrange, {}, {}, {}},
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
  Figure figure{fmt::format("{} · error of predictions", title), "horizon [s]", {}};
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
                                                  const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  FileNames names;
  const auto draw = [&](const Figure& figure, const std::string& name) {
    files.push_back(folder / names.next(name));
    write_svg(figure, files.back());
  };
  if (!diagnosis.horizons.empty()) draw(horizons_figure(diagnosis, title), "errors-by-horizon.svg");
  if (!diagnosis.ranking.empty()) draw(ranking_figure(diagnosis, title), "ranking.svg");
  for (const std::string& joint : joints_of(diagnosis))
    draw(force_figure(diagnosis, joint, title), "residual-force-" + joint + ".svg");
  return files;
}

}  // namespace lacuna
