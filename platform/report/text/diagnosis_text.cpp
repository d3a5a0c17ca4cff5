#include "report/text/diagnosis_text.h"

#include "foundation/figure_text.h"
#include "foundation/shell_word.h"
#include "foundation/unit.h"
#include "report/text/interval_text.h"
#include "report/text/text_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr std::size_t kMostShown = 5;

std::string parameter_text(const FoundParameter& one) {
  const std::string unit = one.unit == "1" ? "" : " " + one.unit;
  if (!std::isfinite(one.lower_95)) return fmt::format("{} {:.3g} (undetermined){}", one.name, one.value, unit);
  const int digits = interval_digits(one.value, one.upper_95 - one.lower_95);
  return fmt::format("{0} {1:.{4}g} [{2:.{4}g}, {3:.{4}g}]{5}", one.name, one.value, one.lower_95, one.upper_95, digits,
                     unit);
}

std::string gain_text(const Gain& gain) {
  return fmt::format("{:+.0f} ± {:.0f}", gain.value, 1.96 * gain.standard_error);
}

/// By how much the mean error where it was not fitted differs, from one end of the interval to the other.
std::string smaller_text(const Gain& gain) {
  const auto change = [](double nats) { return error_change_text(std::exp(-nats), 1.0); };
  return fmt::format("{} [{}, {}]", change(gain.value), change(gain.upper_95), change(gain.lower_95));
}

/// "12.1 → 0.9 mrad".
std::string change_text(double before, double after, const std::string& unit) {
  if (!std::isfinite(before) || !std::isfinite(after)) return "–";
  return fmt::format("{} → {}", format_quantity(before, unit, 3), format_quantity(after, unit, 3));
}

/// Errors by horizon: of the model as it is and with the answer, fitted and held out. One that helps at some horizons
/// alone is shown, too, though it is no verdict.
std::string horizons_text(const Diagnosis& diagnosis) {
  const bool is_doubted = diagnosis.verdict == Verdict::cannot_tell && gained(diagnosis.answer_gain) > 0.0;
  const bool has_answer = diagnosis.verdict == Verdict::effect_found || is_doubted;
  std::vector<std::vector<std::string>> rows = {{"error of predictions", "fit", "", "held out", "", "floor"}};
  for (const HorizonError& one : diagnosis.horizons) {
    const std::string what = fmt::format("{} over {}", one.channel, format_quantity(one.horizon, "s", 2));
    const std::string floor = format_quantity(one.floor, one.unit, 2);
    if (has_answer)
      rows.push_back({what, change_text(one.base, one.answer, one.unit), error_change_text(one.answer, one.base),
                      change_text(one.base_held_out, one.answer_held_out, one.unit),
                      error_change_text(one.answer_held_out, one.base_held_out), floor});
    else
      rows.push_back({what, format_quantity(one.base, one.unit, 3), "",
                      std::isfinite(one.base_held_out) ? format_quantity(one.base_held_out, one.unit, 3) : "–", "",
                      floor});
  }
  return diagnosis.horizons.empty() ? "" : text_table(rows, 1);
}

std::string names_text(const RankedModel& model) {
  std::vector<std::string> names;
  for (const FoundEffect& effect : model.effects) names.push_back(effect.effect + " @ " + effect.where);
  return fmt::format("{}", fmt::join(names, " + "));
}

std::string parameters_text(const std::vector<FoundParameter>& parameters) {
  std::vector<std::string> texts;
  for (const FoundParameter& one : parameters) texts.push_back(parameter_text(one));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The answer's effects with their values, and what these data do not tell from the last of them.
std::string answer_text(const RankedModel& answer) {
  std::string text;
  for (const FoundEffect& effect : answer.effects)
    text += fmt::format("   {}: {}\n", effect.effect, parameters_text(effect.parameters));
  if (!answer.look_alikes.empty())
    text += fmt::format("   not told apart from it here: {}\n", fmt::join(answer.look_alikes, ", "));
  return text;
}

std::vector<std::string> row_by_horizon(std::size_t rank, const RankedModel& model) {
  return {std::to_string(rank), names_text(model), smaller_text(model.gain),
          fmt::format("{:.3g} × floor", model.times_floor)};
}

/// Errors over segments of another length than the answer's, `segment` s, are no measure beside its own.
std::vector<std::string> row_of(std::size_t rank, const RankedModel& model, double segment) {
  std::string error = "over " + format_quantity(model.segment, "s");
  if (model.segment == segment)
    error = std::isfinite(model.times_floor) ? fmt::format("{:.2f} × floor", model.times_floor) : "–";
  return {std::to_string(rank), names_text(model), gain_text(model.gain) + " nats", error};
}

std::string ranking_text(const Diagnosis& diagnosis) {
  const bool by_horizon = !diagnosis.horizons.empty();
  std::vector<std::vector<std::string>> rows = {
      {"", "", by_horizon ? "error where not fitted" : "gain held out", by_horizon ? "fitted" : "error"}};
  for (std::size_t i = 0; i < std::min(kMostShown, diagnosis.ranking.size()); ++i)
    rows.push_back(by_horizon ? row_by_horizon(i + 1, diagnosis.ranking[i])
                              : row_of(i + 1, diagnosis.ranking[i], diagnosis.ranking.front().segment));
  if (diagnosis.verdict == Verdict::nothing_missing || diagnosis.ranking.empty()) return text_table(rows, 2);
  const std::string table = text_table(rows, 2);
  const std::size_t first_end = table.find('\n', table.find('\n') + 1) + 1;
  return table.substr(0, first_end) + answer_text(diagnosis.ranking.front()) + table.substr(first_end);
}

std::string noise_text(const Diagnosis& diagnosis) {
  std::vector<std::string> parts;
  for (const ChannelError& channel : diagnosis.base)
    parts.push_back(channel.channel + " " + format_quantity(channel.floor, channel.unit));
  for (const RandomForce& force : diagnosis.forces)
    parts.push_back(fmt::format("random force on {} {} over {:.3g} ms", force.joint,
                                format_quantity(force.deviation, force.unit), 1e3 * force.duration));
  return fmt::format("noise of what is compared (means of readings where there are many): {}\n",
                     fmt::join(parts, ", "));
}

std::string formula_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const ForceFormula& formula : diagnosis.formulas)
    text += fmt::format("force on joint.{}: {} {}   {} nats held out\n", formula.joint, formula.text(), formula.unit,
                        gain_text(formula.gain));
  return text;
}

/// The ranking and, where there is one, the formula: what is to be added first stands first.
std::string answers_text(const Diagnosis& diagnosis) {
  if (diagnosis.formulas.empty() || diagnosis.ranking.empty()) return formula_text(diagnosis) + ranking_text(diagnosis);
  if (answer_comes_first(diagnosis)) return ranking_text(diagnosis) + "what is left:\n" + formula_text(diagnosis);
  return formula_text(diagnosis) + "what the library comes to beside it:\n" + ranking_text(diagnosis);
}

/// Each reason with the effects that it keeps out: first what plugins failed in.
std::string untestable_text(const Diagnosis& diagnosis) {
  std::map<std::pair<bool, std::string>, std::vector<std::string>> by_reason;
  for (const Untestable& one : diagnosis.untestable)
    by_reason[{!one.failed, one.reason}].push_back(one.where.empty() ? one.effect : one.effect + " @ " + one.where);
  std::string text;
  for (const auto& [key, effects] : by_reason)
    text += fmt::format("{}: {} ({})\n", key.first ? "not testable" : "plugin failed", fmt::join(effects, ", "),
                        key.second);
  return text;
}

std::string figure_text(double value, FigureUnit unit) {
  switch (unit) {
    case FigureUnit::percent: return fmt::format("{:.1f} %", 100.0 * value);
    case FigureUnit::nats: return fmt::format("{:.1f} nats", value);
    case FigureUnit::chance: return fmt::format("p {:.2g}", value);
    case FigureUnit::times_floor: return fmt::format("{:.2f} × floor", value);
  }
  return "";
}

std::string thresholds_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const AtThreshold& near : diagnosis.at_threshold) text += threshold_text(near) + "\n";
  return text;
}

/// What likelihoods tell.
std::string chance_text(const Diagnosis& diagnosis) {
  std::string text;
  if (diagnosis.chance_95 && diagnosis.p_by_chance)
    text = fmt::format("chance: best of {} stays below {:.1f} nats (95 %) · p {:.2g} · model alone {:.2f} × floor\n",
                       diagnosis.hypotheses, *diagnosis.chance_95, *diagnosis.p_by_chance, diagnosis.base_times_floor);
  if (diagnosis.free_force_gain && diagnosis.free_force_p)
    text += fmt::format("a force of any form would add {} nats (p {:.2g})\n", gain_text(*diagnosis.free_force_gain),
                        *diagnosis.free_force_p);
  return text + noise_text(diagnosis);
}

/// In a setup the commands alone are not the test, so that the line to type names it, too.
std::string next_test_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options) {
  if (diagnosis.next_test.empty()) return "";
  std::string text = fmt::format("to tell the first from it: {}\n", diagnosis.next_test_worth);
  if (diagnosis.next_test_setup)
    text +=
        fmt::format("→ lacuna trial {} --test {} --setup {} --csv=next.csv{}\n", shell_word(file),
                    shell_word(diagnosis.next_test), shell_word(setup_to_type(*diagnosis.next_test_setup)), options);
  return text;
}

/// The commands that add what was found.
std::string add_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options) {
  std::string text;
  const bool outside = diagnosis.verdict == Verdict::not_in_library, most = answer_comes_first(diagnosis);
  if (outside && !most && !diagnosis.formulas.empty())
    text +=
        fmt::format("→ lacuna plugins new effect NAME --formula {}\n", shell_word(diagnosis.formulas.front().text()));
  if (diagnosis.verdict == Verdict::effect_found && diagnosis.ranking.front().effects.size() > 1)
    return text + fmt::format("→ lacuna add {} --answer{}\n", shell_word(file), options);
  if (diagnosis.verdict == Verdict::effect_found || (outside && most))
    for (const FoundEffect& effect : diagnosis.ranking.front().effects)
      text += fmt::format("→ lacuna add {} {}{}{}\n", shell_word(file), shell_word(effect.effect),
                          effect.where == "world" ? "" : " --where " + shell_word(effect.where), options);
  return text;
}

}  // namespace

std::string threshold_text(const AtThreshold& near) {
  const std::string threshold = near.unit == FigureUnit::percent ? fmt::format("{:g} %", 100.0 * near.threshold)
                                                                 : figure_text(near.threshold, near.unit);
  return fmt::format(
      "{} is {}, at the threshold of {}: the verdict can change to {} with the last digits of another machine "
      "({} to {})",
      near.figure, figure_text(near.value, near.unit), threshold, to_string(near.other),
      figure_text(near.low, near.unit), figure_text(near.high, near.unit));
}

std::string verdict_text(const Diagnosis& diagnosis) {
  if (diagnosis.stopped) return fmt::format("{} · preliminary", to_string(diagnosis.verdict));
  if (std::isnan(diagnosis.probability)) return std::string(to_string(diagnosis.verdict));
  return fmt::format("{} · P {} ({})", to_string(diagnosis.verdict), probability_text(diagnosis.probability),
                     diagnosis.calibrated ? "calibrated on simulated rigs" : "uncalibrated");
}

std::string diagnosis_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options,
                           const std::string& correction) {
  if (diagnosis.base.empty())  // nothing was searched
    return diagnosis.stopped
               ? fmt::format("verdict {}\n{}\n", verdict_text(diagnosis), fmt::join(diagnosis.findings, "\n"))
               : fmt::format("verdict {} · these data allow none\n{}\n", to_string(diagnosis.verdict),
                             fmt::join(diagnosis.findings, "\n"));
  std::string text = "verdict " + verdict_text(diagnosis) + "\n" + thresholds_text(diagnosis);
  text += horizons_text(diagnosis) + answers_text(diagnosis);
  text += diagnosis.horizons.empty()
              ? chance_text(diagnosis)
              : fmt::format("{} effects were tried; the model alone has an error of {:.3g} × floor\n",
                            diagnosis.hypotheses, diagnosis.base_times_floor);
  if (!diagnosis.values.empty()) text += fmt::format("values: {}\n", parameters_text(diagnosis.values));
  for (const std::string& finding : diagnosis.findings) text += finding + "\n";
  text += untestable_text(diagnosis);
  text += next_test_text(diagnosis, file, options);
  return text + (correction.empty() ? add_text(diagnosis, file, options)
                                    : fmt::format("→ first correct the readings, {}, then lacuna diagnose {}{}\n",
                                                  correction, shell_word(file), options));
}

}  // namespace lacuna
