#pragma once

#include "candidates/hypothesis.h"
#include "evaluation/model/known_setups.h"
#include "residual_law/force_findings.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

enum class Verdict { nothing_missing, effect_found, not_in_library, cannot_tell };
std::string_view to_string(Verdict verdict);

/// What the verdict was read from, and with it the meaning of gains and of errors in multiples of the floor.
enum class DiagnosisMethod {
  prediction,  ///< gains: mean logarithm of the whitened error of predictions where it was not fitted, nats; errors:
               ///< roots of its mean square on what was fitted, so that × floor is 1 where noise alone is left
  horizon,     ///< of earlier versions; gains: as of `prediction`, not whitened; errors: on what was fitted
  likelihood   ///< of earlier versions; gains: log likelihood of what was left out, nats; errors: on what was left out
};
std::string_view to_string(DiagnosisMethod method);
std::optional<DiagnosisMethod> read_method(std::string_view text);

/// A parameter of a found effect, SI. NaN bounds: at a bound of its range, or not told by the data.
struct FoundParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
  std::optional<double> stated = {};  ///< by the robot file, of a fixed value that is wrong there
  bool at_bound = false;              ///< of its range
  bool operator==(const FoundParameter&) const = default;
};

/// A parameter of a found effect that acts only as another of it does, such as the density of a drag beside its area:
/// where it stays, SI.
struct HeldParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  bool operator==(const HeldParameter&) const = default;
};

struct FoundEffect {
  std::string effect;  ///< or `wrong_value`
  std::string where;   ///< "joint.hinge"; "world"; of a wrong value its address
  std::vector<FoundParameter> parameters;
  std::vector<HeldParameter> held = {};
  bool operator==(const FoundEffect&) const = default;
};

/// RMS over the longest predictions of one channel, in its unit.
struct ChannelError {
  std::string channel;
  std::string unit;
  double floor = 0.0;  ///< of the noise, as estimated
  double fit = 0.0;
  double held_out = 0.0;  ///< NaN: nothing is held out
  bool operator==(const ChannelError&) const = default;
};

/// RMS errors of predictions of one channel over one horizon, from starts that the readings tell, less what the start's
/// uncertainty explains of them. NaN: not known.
struct HorizonError {
  double horizon = 0.0;  ///< s
  std::string channel;
  std::string unit;
  double floor = 0.0;  ///< of a reading
  double base = 0.0, answer = 0.0;
  double base_held_out = 0.0, answer_held_out = 0.0;
  bool operator==(const HorizonError&) const = default;
};

/// A model that may be right, against the base.
struct RankedModel {
  std::vector<FoundEffect> effects;
  std::vector<std::string> look_alikes;  ///< what these data do not tell from one of its effects, "name @ where"
  Gain gain;                             ///< over the base, see `DiagnosisMethod`
  std::vector<ChannelError> errors;
  /// RMS over the floor, over all channels, see `DiagnosisMethod`. NaN: not told.
  double times_floor = std::numeric_limits<double>::quiet_NaN();
  double segment = 0.0;  ///< s, of the predictions that the errors are about
  bool operator==(const RankedModel&) const = default;
};

/// Figures that say how sure a verdict is, by name (evidence.h).
using Evidence = std::map<std::string, double>;

/// That the time limit stopped a search: its verdict is about the candidates examined so far, and preliminary.
struct StoppedSearch {
  std::string during;                     ///< "the search"
  std::vector<std::string> not_examined;  ///< candidates, "name @ where"
  std::string next;                       ///< what to do, a sentence
  bool operator==(const StoppedSearch&) const = default;
};

/// What is missing from a model. What was not asked is empty.
struct Diagnosis {
  Verdict verdict = Verdict::cannot_tell;
  double probability = std::numeric_limits<double>::quiet_NaN();  ///< of the verdict; NaN: none is stated
  bool calibrated = false;                ///< the probability is how often such verdicts were right (calibration.h)
  std::optional<DiagnosisMethod> method;  ///< nothing: nothing was searched
  Evidence evidence;
  std::vector<HorizonError> horizons;  ///< the shortest first
  std::vector<ChannelError> base;
  double base_times_floor = 0.0;
  double base_segment = 0.0;         ///< s, of the predictions that `base` is about
  std::vector<RankedModel> ranking;  ///< the first is the answer; empty: nothing is better than the base
  /// The model's own free values, by address, fitted beside the answer; empty where no verdict says that the model is
  /// right with it.
  std::vector<FoundParameter> values;
  std::optional<double> p_by_chance;            ///< how often noise alone gains as much as the best set of effects
  std::optional<Gain> answer_gain;              ///< over the model without any effect
  std::vector<ForceCurve> missing_force;        ///< of the model as it is, with what the answer makes of it
  std::optional<UnexplainedForce> unexplained;  ///< by the answer, or by the model where there is none
  std::vector<ForceCurve> residual_force;       ///< what no effect explains, where that is more than noise
  std::vector<ForceFormula> formulas;           ///< of it, one a joint, the largest gain first
  std::size_t hypotheses = 0;                   ///< effect × place
  std::vector<Untestable> untestable;
  std::vector<std::string> findings;  ///< sentences
  std::string next_test;              ///< as `lacuna trial --test` takes it; empty: nothing to be settled by a test
  std::optional<KnownSetup> next_test_setup;  ///< that it is to be made in; nothing where no recording has one
  std::string next_test_worth;                ///< the same with what it tells in nats, beside what a random test does
  std::optional<StoppedSearch> stopped;       ///< then no probability is stated, and `findings` says so first
  double seconds = 0.0;
};

/// Nats; 0 where it is not known, or nothing.
double gained(const std::optional<Gain>& gain);

}  // namespace lacuna
