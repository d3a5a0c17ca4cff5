#include "report/diagnosis_pictures.h"

#include "report/figure.h"
#include "report/file_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double k95 = 1.96;             // standard errors
constexpr std::size_t kMostRanked = 12;  // bars
constexpr double kBar = 0.5;             // of the distance between bars

Panel force_panel(const ForceCurve& curve) {
  Series band{"", Mark::band, kOrange, curve.at, {}, {}},
      force{"", Mark::line_points, kOrange, curve.at, curve.force, {}};
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    band.y.push_back(curve.force[i] - k95 * curve.standard_error[i]);
    band.y2.push_back(curve.force[i] + k95 * curve.standard_error[i]);
  }
  Panel panel{
      "unexplained force [" + curve.force_unit + "]", {band, force, {"", Mark::level, kInk, {}, {0.0}, {}}}, 1.0, {}};
  panel.x_label = curve.of + " [" + curve.unit + "]";
  return panel;
}

/// The force on one joint, and the formula for it if there is one.
Figure force_figure(const Diagnosis& diagnosis, const std::string& joint, const std::string& title) {
  Figure figure{fmt::format("{} · force on joint.{}", title, joint), "", {}};
  for (const ForceFormula& formula : diagnosis.formulas)
    if (formula.joint == joint) figure.title += fmt::format(": {} {}", formula.text(), formula.unit);
  for (const ForceCurve& curve : diagnosis.residual_force)
    if (curve.joint == joint) figure.panels.push_back(force_panel(curve));
  figure.columns = static_cast<int>(figure.panels.size());
  figure.x_label = figure.panels.front().x_label;  // where there is one column only
  figure.same_y = true;
  figure.height = 380;
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
  const Series chance{"chance, 95 %",     Mark::path, kOrange, {diagnosis.chance_95, diagnosis.chance_95},
                      {-0.5, rows - 0.5}, {}};
  panel.series = {gain, interval, chance};
  Figure figure{
      fmt::format("{} · {}, P {:.2f} (uncalibrated)", title, to_string(diagnosis.verdict), diagnosis.probability),
      "held-out log likelihood over the model [nats]",
      {panel}};
  figure.height = 200 + 44 * static_cast<int>(panel.y_names.size());
  return figure;
}

}  // namespace

std::vector<std::filesystem::path> draw_diagnosis(const Diagnosis& diagnosis, const std::string& title,
                                                  const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  const auto draw = [&](const Figure& figure, const std::string& name) {
    files.push_back(folder / file_name(name));
    write_svg(figure, files.back());
  };
  if (!diagnosis.ranking.empty()) draw(ranking_figure(diagnosis, title), "ranking.svg");
  for (const std::string& joint : joints_of(diagnosis))
    draw(force_figure(diagnosis, joint, title), "residual-force-" + joint + ".svg");
  return files;
}

}  // namespace lacuna
