#pragma once

#include "evaluation/model/known_setups.h"
#include "candidates/untestable.h"
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

/// How the verdict was reached. It sets the meaning of gains and of errors in multiples of the floor.
enum class DiagnosisMethod {
  prediction,  ///< gains: decrease of the mean logarithm of the whitened prediction error on data that were not fitted,
               ///< nats; errors: RMS of the whitened error on the fitted data, 1 × floor for noise alone
  horizon,     ///< earlier versions; gains: as `prediction`, not whitened; errors: on the fitted data
  likelihood   ///< earlier versions; gains: log likelihood of the left-out data, nats; errors: on the left-out data
};
std::string_view to_string(DiagnosisMethod method);
std::optional<DiagnosisMethod> read_method(std::string_view text);

/// A parameter of a found effect, SI. NaN bounds: the value is at a bound of its range, or these data do not determine
/// it.
struct FoundParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
  std::optional<double> stated = {};  ///< of a wrong fixed value: the value in the robot file
  bool at_bound = false;              ///< of its range
  bool operator==(const FoundParameter&) const = default;
};

/// A parameter that these data do not determine because another one of the effect has the same influence, such as the
/// density of a drag beside its area. `value`: where the fit held it, SI.
struct HeldParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  bool operator==(const HeldParameter&) const = default;
};

struct FoundEffect {
  std::string effect;  ///< or `wrong_value`
  std::string where;   ///< "joint.hinge"; "world"; for a wrong value its address
  std::vector<FoundParameter> parameters;
  std::vector<HeldParameter> held = {};
  bool operator==(const FoundEffect&) const = default;
};

/// RMS over the longest predictions of one channel, in its unit.
struct ChannelError {
  std::string channel;
  std::string unit;
  double floor = 0.0;  ///< RMS of the sensor noise, as estimated
  double fit = 0.0;
  double held_out = 0.0;  ///< NaN: no trial is held out
  bool operator==(const ChannelError&) const = default;
};

/// RMS prediction errors of one channel over one horizon, from initial states that the readings determine, without the
/// part that the uncertainty of these states explains. NaN: not known.
struct HorizonError {
  double horizon = 0.0;  ///< s
  std::string channel;
  std::string unit;
  double floor = 0.0;  ///< of a reading
  double base = 0.0, answer = 0.0;
  double base_held_out = 0.0, answer_held_out = 0.0;
  bool operator==(const HorizonError&) const = default;
};

/// A candidate that may be right, compared with the base.
struct RankedModel {
  std::vector<FoundEffect> effects;
  /// Effects that are indistinguishable on these data from one of its effects, "name @ where".
  std::vector<std::string> look_alikes;
  Gain gain;  ///< compared with the base, see `DiagnosisMethod`
  std::vector<ChannelError> errors;
  /// RMS error over the noise floor, over all channels, see `DiagnosisMethod`. NaN: not known.
  double times_floor = std::numeric_limits<double>::quiet_NaN();
  double segment = 0.0;  ///< s, length of the predictions of `errors`
  bool operator==(const RankedModel&) const = default;
};

/// Figures that say how sure a verdict is, by name (evidence.h).
using Evidence = std::map<std::string, double>;

/// The time limit stopped the search. Its verdict is preliminary: it covers the candidates examined so far.
struct StoppedSearch {
  std::string during;                     ///< "the search"
  std::vector<std::string> not_examined;  ///< candidates, "name @ where"
  std::string next;                       ///< what to do, a sentence
  bool operator==(const StoppedSearch&) const = default;
};

/// What is missing from a model. A member stays empty where its question was not asked.
struct Diagnosis {
  Verdict verdict = Verdict::cannot_tell;
  double probability = std::numeric_limits<double>::quiet_NaN();  ///< that the verdict is right; NaN: none is stated
  bool calibrated = false;  ///< `probability` is the share of such verdicts that were right (calibration.h)
  std::optional<DiagnosisMethod> method;  ///< nothing: no search was made
  Evidence evidence;
  std::vector<HorizonError> horizons;  ///< the shortest first
  std::vector<ChannelError> base;
  double base_times_floor = 0.0;
  double base_segment = 0.0;         ///< s, length of the predictions of `base`
  std::vector<RankedModel> ranking;  ///< the first is the answer; empty: nothing is better than the base
  /// The model's own free values, by address, fitted beside the answer; empty where no verdict says that the model is
  /// right with it.
  std::vector<FoundParameter> values;
  std::optional<double> p_by_chance;            ///< how often noise alone gains as much as the best set of effects
  std::optional<Gain> answer_gain;              ///< of the model without any effect
  std::vector<ForceCurve> missing_force;        ///< of the model as it is, and the part of it that the answer explains
  std::optional<UnexplainedForce> unexplained;  ///< with the answer, or without any effect where there is no answer
  std::vector<ForceCurve> residual_force;       ///< a force that no effect explains and that is larger than noise
  std::vector<ForceFormula> formulas;           ///< formulas for that force, one per joint, the largest gain first
  std::size_t hypotheses = 0;                   ///< effect × place
  std::vector<std::string> effect_filter;       ///< names of the only effects that were tried; empty: all
  std::vector<Untestable> untestable;
  std::vector<std::string> findings;          ///< sentences
  std::string next_test;                      ///< as `lacuna trial --test` takes it; empty: no test is needed
  std::optional<KnownSetup> next_test_setup;  ///< setup to make it in; nothing where no recording has one
  std::string next_test_worth;                ///< the test, its worth in nats, and the worth of a random test
  /// Stopped by the time limit: no probability is stated.
  std::optional<StoppedSearch> stopped;
  double seconds = 0.0;
};

/// Nats; 0 where the gain is not known or there is none.
double gained(const std::optional<Gain>& gain);

}  // namespace lacuna
