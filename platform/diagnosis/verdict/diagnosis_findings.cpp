#include "diagnosis/verdict/diagnosis_findings.h"

#include "diagnosis/refit/timing.h"
#include "diagnosis/rounds/search_state.h"
#include "diagnosis/rounds/selection.h"
#include "diagnosis/verdict/undeclared_force.h"
#include "diagnosis/verdict/verdict_figures.h"
#include "foundation/unit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMoved = 2.0;          ///< standard errors
constexpr double kNoticeable = 0.01;    ///< of the value
constexpr double kWorthSaying = 2.0;    ///< nats, what one more effect would gain
constexpr double kHardly = 0.1;         ///< of what the answer gains
constexpr double kOffTime = 0.1;        ///< command intervals; less may be an integration step
constexpr double kFarBeyond = 3.0;      ///< standard errors
constexpr double kSameInterval = 0.99;  ///< shortest over longest: what rounded times of rows differ by

std::string soaked_up(const BaseValues& base, const Contender& contender, const Round& last) {
  const ParameterSpace space(contender.definition.free);
  std::vector<std::string> moved;
  for (std::size_t i = 0; i < contender.definition.free.size(); ++i) {
    const FreeValue& free = contender.definition.free[i];
    const auto known = std::find_if(base.free.begin(), base.free.end(),
                                    [&](const FreeValue& one) { return one.address == free.address; });
    if (known == base.free.end()) continue;
    const auto j = static_cast<Eigen::Index>(i);
    const double before = base.fitted[static_cast<std::size_t>(known - base.free.begin())], after = last.fit.values[i];
    const double by = std::abs(space.to_coordinate(j, after) - space.to_coordinate(j, before));
    if (by <= kMoved * std::sqrt(last.fit.covariance(j, j)) ||
        std::abs(after - before) <= kNoticeable * std::abs(after))
      continue;
    moved.push_back(fmt::format("{} ({} → {})", free.address, format_quantity(before, free.unit),
                                format_quantity(after, free.unit)));
  }
  if (moved.empty()) return "";
  return fmt::format("{} had soaked it up", fmt::join(moved, ", "));
}

/// Of the base's squared error above the floor, what the answer leaves.
std::string what_is_left(const Diagnosis& diagnosis) {
  const double before = std::pow(diagnosis.base_times_floor, 2) - 1.0;
  const double after = std::pow(diagnosis.ranking.front().times_floor, 2) - 1.0;
  if (diagnosis.free_force_p.value_or(1.0) >= kFreeForceLevel || before <= 0.0)
    return "what is left depends on no joint's position, velocity or command";
  return fmt::format("{:.1f} % of the squared error above the floor is left, and it has structure",
                     100.0 * std::clamp(after / before, 0.0, 1.0));
}

/// One more effect that was not taken, though it predicts a little better.
std::string what_was_not_taken(const Diagnosis& diagnosis, const Round& last) {
  if (last.rivals.empty() || last.screening.p > kFurtherLevel) return "";
  const Rival& best = last.rivals.front();
  const double share = best.gain.value / diagnosis.answer_gain.value_or(Gain()).value;
  if (best.gain.value < kWorthSaying || share > kHardly) return "";
  return fmt::format(
      "{} beside it would gain {:.1f} nats more, {:.2g} % of what is explained: it more likely makes up for a form",
      name_of(last.hypotheses[best.hypothesis].entry), best.gain.value, 100.0 * share);
}

/// In seconds, and in command intervals where these differ from trial to trial.
std::string lateness(double intervals, const std::vector<Trial>& trials) {
  const double longest = longest_command_interval(trials);
  double shortest = longest;
  for (const Trial& trial : trials)
    if (const double own = command_interval(trial); own > 0.0) shortest = std::min(shortest, own);
  std::string most = format_quantity(intervals * longest, "s");
  if (shortest > kSameInterval * longest) return most;
  return fmt::format("{:.2g} command intervals ({} to {})", intervals, format_quantity(intervals * shortest, "s"),
                     most);
}

/// A user who simulates with the commands as recorded meets what is left by that.
std::string off_time(const Round& last) {
  const double timing = last.base.timing.value_or(0.0), size = std::abs(timing);
  if (size < kOffTime) return "";
  const Eigen::Index own = last.fit.covariance.rows() - 1;
  if (size < kFarBeyond * std::sqrt(last.fit.covariance(own, own))) return "";
  return fmt::format(
      "commands act {} {} than recorded{}: a matter of recording, which this fit allows for; compare and trial do not, "
      "unless the times of commands are shifted by as much",
      lateness(size, last.base.trials), timing > 0.0 ? "later" : "earlier",
      last.fit.at_bound.back() ? ", or more" : "");
}

/// Of all that is to be gained, all told under one noise.
double share_of_answer(const Diagnosis& diagnosis) {
  if (diagnosis.ranking.empty() || diagnosis.ranking.front().effects.empty()) return 0.0;
  const double answer = gained(diagnosis.answer_gain), all = answer + gained(diagnosis.free_force_gain);
  return all > 0.0 ? answer / all : 0.0;
}

}  // namespace

bool answer_comes_first(const Diagnosis& diagnosis) {
  const bool is_most = share_of_answer(diagnosis) >= kAnswerIsMost;
  if (is_most || diagnosis.formulas.empty()) return is_most;
  const double answer =
      diagnosis.formulas_of_rest ? gained(diagnosis.answer_gain) : diagnosis.ranking.front().gain.value;
  return share_of_answer(diagnosis) > 0.0 && answer > diagnosis.formulas.front().gain.value;
}

std::vector<std::string> findings_of(const Diagnosis& diagnosis, const BaseValues& base, const Contender& contender,
                                     const Round& last) {
  std::vector<std::string> findings;
  const bool tested = !last.forces.joints.empty();
  switch (diagnosis.verdict) {
    case Verdict::cannot_tell:
      if (!contender.added.empty() && diagnosis.answer_gain) {
        findings.push_back(
            fmt::format("what the search ended with, {}, predicts what was left out by {:.1f} ± {:.1f} nats better "
                        "than the model alone, no more than chance might: more trials, or livelier ones, would tell",
                        fmt::join(names_of(contender.added), " and "), diagnosis.answer_gain->value,
                        1.96 * diagnosis.answer_gain->standard_error));
        break;
      }
      if (last.screening.p > kFirstLevel) break;
      findings.emplace_back(
          "something departs from noise, but no effect predicts what was left out better than the model alone: more "
          "trials, or livelier ones, would tell");
      break;
    case Verdict::effect_found:
      if (tested) findings.push_back(what_is_left(diagnosis));
      if (std::string text = soaked_up(base, contender, last); !text.empty()) findings.push_back(std::move(text));
      if (std::string text = what_was_not_taken(diagnosis, last); !text.empty()) findings.push_back(std::move(text));
      break;
    case Verdict::not_in_library:
      if (!answer_comes_first(diagnosis))
        findings.emplace_back("a force that no effect of the library has is missing");
      else
        findings.push_back(fmt::format(
            "the effects of the first row gain {:.0f} % of what is to be gained; the rest is a force that no "
            "effect of the library has: add them and diagnose again",
            100.0 * share_of_answer(diagnosis)));
      break;
    case Verdict::nothing_missing: break;
  }
  if (!tested)
    findings.emplace_back(
        "whether a force that no effect has is missing was not tested: these sensors do not tell the motion of the "
        "joints, or there are too many of them");
  if (std::string text = off_time(last); !text.empty()) findings.push_back(std::move(text));
  if (diagnosis.verdict != Verdict::cannot_tell)  // then what looks like a force may be what is missing
    if (std::string text = undeclared_force(diagnosis, contender, last); !text.empty())
      findings.push_back(std::move(text));
  findings.insert(findings.end(), last.base.remarks.begin(), last.base.remarks.end());
  return findings;
}

}  // namespace lacuna
