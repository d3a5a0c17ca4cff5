#include "diagnosis/verdict/verdict_figures.h"

#include "diagnosis/rounds/present_effects.h"
#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/selection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kBeyondChance = 2.0;  ///< nats

/// A figure with the threshold that it is held against.
struct Threshold {
  const char* name;
  VerdictFigure VerdictFigures::*figure;
  double at;
  FigureUnit unit;
};

constexpr std::array kThresholds = {
    Threshold{"the gain of the effects found, of all that is to be gained,", &VerdictFigures::answer_share,
              kAnswerIsMost, FigureUnit::percent},
    Threshold{"the chance that noise explains as much as a force of any form", &VerdictFigures::structure_p,
              kFreeForceLevel, FigureUnit::chance},
    Threshold{"the lead of a force of any form over the best further effect (95 % lower end)",
              &VerdictFigures::structure_gain, 0.0, FigureUnit::nats},
    Threshold{"the lead of the formula over the library", &VerdictFigures::law_ahead, 0.0, FigureUnit::nats},
    Threshold{"the gain of the effects found", &VerdictFigures::answer_gain, kBeyondChance, FigureUnit::nats},
    Threshold{"the gain of the effects found (95 % lower end)", &VerdictFigures::answer_lower, 0.0, FigureUnit::nats},
    Threshold{"the chance that noise reaches the best score", &VerdictFigures::chance_p, kFirstLevel,
              FigureUnit::chance},
    Threshold{"what is still to be gained, of what the model's effects gain,", &VerdictFigures::form_share, kFormShare,
              FigureUnit::percent},
    Threshold{"the error of the model", &VerdictFigures::base_error, kFormAtFloor, FigureUnit::times_floor},
    Threshold{"the motion that the model misses, of what still allows a verdict,", &VerdictFigures::missed_motion, 1.0,
              FigureUnit::percent},
};

}  // namespace

Verdict verdict_of_search(const VerdictFigures& figures) {
  if (figures.outdone && figures.law_ahead.value > 0.0) return Verdict::not_in_library;
  const bool is_law = figures.structure_p.value < kFreeForceLevel && figures.structure_gain.value > 0.0;
  if (is_law && (!figures.has_answer || figures.answer_share.value < kAnswerIsMost)) return Verdict::not_in_library;
  // That a search through many effects ends with one is no evidence; that it predicts what was left out is.
  if (figures.has_answer)
    return figures.answer_gain.value > kBeyondChance && figures.answer_lower.value > 0.0 ? Verdict::effect_found
                                                                                         : Verdict::cannot_tell;
  return figures.chance_p.value <= kFirstLevel ? Verdict::cannot_tell : Verdict::nothing_missing;
}

bool is_form_only(const VerdictFigures& figures) {
  return figures.may_be_form && verdict_of_search(figures) != Verdict::nothing_missing &&
         figures.base_error.value <= kFormAtFloor && figures.form_share.value <= kFormShare;
}

Verdict verdict_of(const VerdictFigures& figures) {
  const Verdict verdict = is_form_only(figures) ? Verdict::nothing_missing : verdict_of_search(figures);
  return figures.missed_motion.value > 1.0 && verdict != Verdict::not_in_library ? Verdict::cannot_tell : verdict;
}

std::vector<AtThreshold> at_thresholds(const VerdictFigures& figures) {
  const Verdict verdict = verdict_of(figures);
  std::vector<AtThreshold> near;
  for (const Threshold& threshold : kThresholds) {
    const VerdictFigure& figure = figures.*threshold.figure;
    for (const double moved : {figure.low, figure.high}) {
      VerdictFigures other = figures;
      (other.*threshold.figure).value = moved;
      if (verdict_of(other) == verdict) continue;
      near.push_back(
          {threshold.name, threshold.unit, figure.value, threshold.at, figure.low, figure.high, verdict_of(other)});
      break;
    }
  }
  return near;
}

VerdictFigure with_range(double value, double margin) {
  return {value, value - margin * std::abs(value), value + margin * std::abs(value)};
}

VerdictFigure lower_with_range(const Gain& gain, double against) {
  const double value = gain.lower_95 - against;
  const double margin = kLastDigits * (std::abs(gain.value - gain.lower_95) + std::abs(gain.value - against));
  return {value, value - margin, value + margin};
}

VerdictFigure share_with_range(double part, double rest) {
  const auto share = [](double one, double other) { return one + other > 0.0 ? one / (one + other) : 0.0; };
  const double less = 1.0 - kLastDigits, more = 1.0 + kLastDigits;
  return {share(part, rest), share(less * part, more * rest), share(more * part, less * rest)};
}

}  // namespace lacuna
