#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/noise/last_digits.h"

#include <vector>

namespace lacuna {

/// All that the verdict of a search is read from.
struct VerdictFigures {
  bool has_answer = false;       ///< the search ended with effects
  bool outdone = false;          ///< it ended since a formula outdoes the library
  VerdictFigure law_ahead;       ///< of the library by that formula, nats
  VerdictFigure answer_share;    ///< of all that is to be gained, what the answer gains
  VerdictFigure structure_p;     ///< how often noise alone explains as much as a force of any form
  VerdictFigure structure_gain;  ///< of that force, 95 % lower end over the best further effect, nats
  VerdictFigure answer_gain;     ///< over the model alone, nats
  VerdictFigure answer_lower;    ///< its 95 % lower end
  VerdictFigure chance_p;        ///< how often noise alone reaches the best further score
  bool may_be_form = false;      ///< the model has effects whose gain is known
  VerdictFigure form_share;      ///< what is still to be gained over what these effects gain
  VerdictFigure base_error;      ///< of the model, times the floor
  VerdictFigure missed_motion;   ///< the error that no effect explains, over the largest that still allows a verdict
};

inline constexpr double kAnswerIsMost = 0.95;  ///< of all that is to be gained: then the rest is the form of an effect

/// The verdict before it is asked whether only a form is made up for, or motion is missed.
Verdict verdict_of_search(const VerdictFigures& figures);
/// Whether what is still to be gained more likely makes up for the form of an effect that the model has.
bool is_form_only(const VerdictFigures& figures);
Verdict verdict_of(const VerdictFigures& figures);

/// The figures that stand so near to their threshold that the verdict would be another with the last digits of another
/// machine.
std::vector<AtThreshold> at_thresholds(const VerdictFigures& figures);

/// A figure with the range of a statistic of its size, or of a difference of such.
VerdictFigure with_range(double value, double margin = kLastDigits);
/// Of the 95 % lower end of a gain, less what it is held against.
VerdictFigure lower_with_range(const Gain& gain, double against = 0.0);
/// Of a part of a part and the rest, where both may move.
VerdictFigure share_with_range(double part, double rest);

}  // namespace lacuna
