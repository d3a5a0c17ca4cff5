#include "report/text/diagnosis_text.h"

#include "foundation/statistics.h"
#include "foundation/text/counted.h"
#include "foundation/text/figure_text.h"
#include "foundation/text/shell_word.h"
#include "foundation/text/unit_text.h"
#include "foundation/unit.h"
#include "report/text/interval_text.h"
#include "report/text/text_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr std::ptrdiff_t kMostNamedPlaces = 3;  ///< of one effect in a row
constexpr std::size_t kMostShown = 5;

std::string parameter_text(const FoundParameter& one) {
  const std::string unit = unit_after_number(one.unit);
  if (one.at_bound) return fmt::format("{} {:.3g}{} (at a bound of its range)", one.name, one.value, unit);
  if (!std::isfinite(one.lower_95)) return fmt::format("{} {:.3g} (undetermined){}", one.name, one.value, unit);
  const int digits = interval_digits(one.value, one.upper_95 - one.lower_95);
  return fmt::format("{0} {1:.{4}g} [{2:.{4}g}, {3:.{4}g}]{5}", one.name, one.value, one.lower_95, one.upper_95, digits,
                     unit);
}

std::string gain_text(const Gain& gain) {
  return fmt::format("{:+.0f} ± {:.0f}", gain.value, kWithin95 * gain.standard_error);
}

/// Change of the mean cross-validated error, with its interval.
std::string smaller_text(const Gain& gain) {
  const auto change = [](double nats) { return error_change_text(std::exp(-nats), 1.0); };
  return fmt::format("{} [{}, {}]", change(gain.value), change(gain.upper_95), change(gain.lower_95));
}

/// "12.1 → 0.9 mrad".
std::string change_text(double before, double after, const std::string& unit) {
  if (!std::isfinite(before) || !std::isfinite(after)) return "–";
  return fmt::format("{} → {}", format_quantity(before, unit, 3), format_quantity(after, unit, 3));
}

/// Errors by segment length: of the model alone and with the answer, fit and held out.
std::string horizons_text(const Diagnosis& diagnosis) {
  const bool has_answer = diagnosis.verdict == Verdict::effect_found;
  std::vector<std::vector<std::string>> rows = {{"prediction error", "fit", "", "held out", "", "noise floor"}};
  for (const HorizonError& one : diagnosis.horizons) {
    const std::string what = fmt::format("{}, {} segments", one.channel, format_quantity(one.horizon, "s", 2));
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

std::ptrdiff_t places_of(const std::string& effect, const RankedModel& model) {
  return std::count_if(model.effects.begin(), model.effects.end(),
                       [&](const FoundEffect& other) { return other.effect == effect; });
}

/// "coulomb_friction @ joint.hinge + viscous_friction @ 6 joints".
std::string names_text(const RankedModel& model) {
  std::vector<std::string> names;
  for (const FoundEffect& effect : model.effects) {
    const std::ptrdiff_t places = places_of(effect.effect, model);
    std::string name = effect.effect + " @ " + effect.where;
    if (places > kMostNamedPlaces)
      name = fmt::format("{} @ {} {}s", effect.effect, places, effect.where.substr(0, effect.where.find('.')));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return fmt::format("{}", fmt::join(names, " + "));
}

std::string parameters_text(const std::vector<FoundParameter>& parameters) {
  std::vector<std::string> texts;
  for (const FoundParameter& one : parameters) texts.push_back(parameter_text(one));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// "; density held at 1.2 kg/m^3: only its product with area is determined".
std::string held_text(const FoundEffect& effect) {
  if (effect.held.empty() || effect.parameters.empty()) return "";
  std::vector<std::string> texts;
  for (const HeldParameter& one : effect.held)
    texts.push_back(fmt::format("{} held at {}", one.name, format_quantity(one.value, one.unit)));
  return fmt::format("; {}: only its product with {} is determined", fmt::join(texts, ", "),
                     effect.parameters.front().name);
}

/// "joint.hinge.armature: 0.010 [0.0098, 0.0103] kg*m^2 instead of 0.020"
std::string wrong_value_text(const FoundEffect& effect) {
  FoundParameter value = effect.parameters.front();
  value.name = effect.where + ":";
  return fmt::format("{} instead of {}", parameter_text(value), format_quantity(*value.stated, value.unit));
}

std::string effect_text(const FoundEffect& effect, bool with_place) {
  const bool is_wrong_value = !effect.parameters.empty() && effect.parameters.front().stated;
  if (is_wrong_value) return wrong_value_text(effect);
  const std::string name = with_place ? effect.effect + " @ " + effect.where : effect.effect;
  return fmt::format("{}: {}{}", name, parameters_text(effect.parameters), held_text(effect));
}

/// The answer's effects with their values, and the effects that are indistinguishable from the last of them.
std::string answer_text(const RankedModel& answer) {
  std::string text;
  for (const FoundEffect& effect : answer.effects)
    text += fmt::format("   {}\n", effect_text(effect, places_of(effect.effect, answer) > 1));
  if (!answer.look_alikes.empty())
    text += fmt::format("   indistinguishable on these data: {}\n", fmt::join(answer.look_alikes, ", "));
  return text;
}

/// Gains of earlier versions are likelihoods, not errors.
bool is_by_likelihood(const Diagnosis& diagnosis) { return diagnosis.method == DiagnosisMethod::likelihood; }

std::vector<std::string> row_of(std::size_t rank, const RankedModel& model, bool by_likelihood) {
  const std::string error = std::isfinite(model.times_floor) ? fmt::format("{:.3g} × floor", model.times_floor) : "–";
  return {std::to_string(rank), names_text(model),
          by_likelihood ? gain_text(model.gain) + " nats" : smaller_text(model.gain), error};
}

std::string ranking_text(const Diagnosis& diagnosis) {
  const bool by_likelihood = is_by_likelihood(diagnosis);
  std::vector<std::vector<std::string>> rows = {
      {"", "", by_likelihood ? "gain held out" : "cross-validated error", by_likelihood ? "error" : "fitted error"}};
  for (std::size_t i = 0; i < std::min(kMostShown, diagnosis.ranking.size()); ++i)
    rows.push_back(row_of(i + 1, diagnosis.ranking[i], by_likelihood));
  const std::string table = text_table(rows, 2);
  if (diagnosis.verdict != Verdict::effect_found) return diagnosis.ranking.empty() ? "" : table;
  const std::size_t first_end = table.find('\n', table.find('\n') + 1) + 1;
  return table.substr(0, first_end) + answer_text(diagnosis.ranking.front()) + table.substr(first_end);
}

std::string formula_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const ForceFormula& formula : diagnosis.formulas)
    text += fmt::format("{} on joint.{}: {} {}   {}\n", force_word(formula.unit), formula.joint, formula.text(),
                        unit_text(formula.unit),
                        is_by_likelihood(diagnosis) ? gain_text(formula.gain) + " nats held out"
                                                    : smaller_text(formula.gain) + " cross-validated error");
  return text;
}

/// The ranking and the formula, if there is one; the one to add first is printed first.
std::string answers_text(const Diagnosis& diagnosis) {
  if (diagnosis.formulas.empty() || diagnosis.ranking.empty()) return formula_text(diagnosis) + ranking_text(diagnosis);
  if (diagnosis.verdict == Verdict::effect_found)
    return ranking_text(diagnosis) + fmt::format("residual {}:\n", force_word(diagnosis.formulas.front().unit)) +
           formula_text(diagnosis);
  return formula_text(diagnosis) + "best candidates of the library:\n" + ranking_text(diagnosis);
}

/// Each reason with the effects that could not be tested: failures of plugins first.
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

/// Number of candidates, the effect filter, and the probability that noise alone gains as much.
std::string chance_text(const Diagnosis& diagnosis) {
  std::string text = counted(diagnosis.hypotheses, "candidate") + " tried";
  if (!diagnosis.effect_filter.empty())
    text += fmt::format(" (only --among {}; leave it out to try all effects)", fmt::join(diagnosis.effect_filter, " "));
  if (diagnosis.p_by_chance)
    text += fmt::format("; probability that noise alone gives a gain as large as the best one: p = {:.2g}",
                        *diagnosis.p_by_chance);
  return text + fmt::format("\nerror of the null model: {:.3g} × floor\n", diagnosis.base_times_floor);
}

/// With setups, the commands alone do not define the test, so the line to type names the setup too.
std::string next_test_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options) {
  if (diagnosis.next_test.empty()) return "";
  std::string text = fmt::format("next test, to separate {} from the nearest other candidate: {}\n",
                                 diagnosis.ranking.empty() ? "the answer" : names_text(diagnosis.ranking.front()),
                                 diagnosis.next_test_worth);
  if (diagnosis.next_test_setup)
    text +=
        fmt::format("→ lacuna trial {} --test {} --setup {} --csv=next.csv{}\n", shell_word(file),
                    shell_word(diagnosis.next_test), shell_word(setup_to_type(*diagnosis.next_test_setup)), options);
  return text;
}

/// The commands that add what was found.
std::string add_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options) {
  std::string text;
  if (diagnosis.verdict == Verdict::not_in_library && !diagnosis.formulas.empty())
    text +=
        fmt::format("→ lacuna plugins new effect NAME --formula {}\n", shell_word(diagnosis.formulas.front().text()));
  if (diagnosis.verdict != Verdict::effect_found) return text;
  if (diagnosis.stopped)
    text += fmt::format(
        "the search was not finished, so another effect may be the answer: to finish it, run lacuna "
        "diagnose {}{} again; to add the best so far:\n",
        shell_word(file), options);
  if (diagnosis.ranking.front().effects.size() > 1)
    text += fmt::format("→ lacuna add {} --answer{}\n", shell_word(file), options);
  else
    for (const FoundEffect& effect : diagnosis.ranking.front().effects)
      text += fmt::format("→ lacuna add {} {}{}{}\n", shell_word(file), shell_word(effect.effect),
                          effect.where == "world" ? "" : " --where " + shell_word(effect.where), options);
  return text;
}

}  // namespace

const char* force_word(const std::string& unit) { return unit.starts_with("N*m") ? "torque" : "force"; }

std::string verdict_text(const Diagnosis& diagnosis) {
  if (diagnosis.stopped) return fmt::format("{} · preliminary", to_string(diagnosis.verdict));
  if (std::isnan(diagnosis.probability)) return std::string(to_string(diagnosis.verdict));
  return fmt::format("{} · probability {} ({})", to_string(diagnosis.verdict), probability_text(diagnosis.probability),
                     diagnosis.calibrated ? "calibrated on simulated experiments" : "uncalibrated");
}

std::string diagnosis_text(const Diagnosis& diagnosis, const std::string& file, const std::string& options,
                           const std::string& correction) {
  if (diagnosis.base.empty())  // nothing was searched
    return diagnosis.stopped
               ? fmt::format("verdict {}\n{}\n", verdict_text(diagnosis), fmt::join(diagnosis.findings, "\n"))
               : fmt::format("verdict {} · these data allow no verdict\n{}\n", to_string(diagnosis.verdict),
                             fmt::join(diagnosis.findings, "\n"));
  std::string text = "verdict " + verdict_text(diagnosis) + "\n";
  text += horizons_text(diagnosis) + answers_text(diagnosis);
  text += chance_text(diagnosis);
  if (!diagnosis.values.empty()) text += fmt::format("values: {}\n", parameters_text(diagnosis.values));
  for (const std::string& finding : diagnosis.findings) text += finding + "\n";
  text += untestable_text(diagnosis);
  text += next_test_text(diagnosis, file, options);
  return text + (correction.empty() ? add_text(diagnosis, file, options)
                                    : fmt::format("→ correct the readings first, {}, then lacuna diagnose {}{}\n",
                                                  correction, shell_word(file), options));
}

}  // namespace lacuna
