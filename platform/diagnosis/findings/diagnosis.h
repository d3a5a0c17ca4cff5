#pragma once

#include "config/experiment.h"
#include "diagnosis/candidates/hypothesis.h"
#include "diagnosis/noise/noise_model.h"
#include "diagnosis/refit/cross_validation.h"
#include "diagnosis/residual_force/force_formula.h"
#include "diagnosis/residual_force/free_force.h"
#include "diagnosis/residual_force/random_force.h"
#include "evaluation/known_setups.h"
#include "fitting/progress.h"

#include <cstdint>
#include <functional>
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
  likelihood,  ///< gains: log likelihood of what was left out, nats; errors: on what was left out
  horizon      ///< gains: mean logarithm of the error where it was not fitted, nats; errors: on what was fitted
};
std::string_view to_string(DiagnosisMethod method);

/// A parameter of a found effect, SI. NaN bounds: at a bound of its range, or not told by the data.
struct FoundParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
  bool operator==(const FoundParameter&) const = default;
};

struct FoundEffect {
  std::string effect;
  std::string where;  ///< "joint.hinge"; "world"
  std::vector<FoundParameter> parameters;
  bool operator==(const FoundEffect&) const = default;
};

/// The answer's effects, refitted over segments of another length.
struct EffectsAtLength {
  double segment = 0.0;  ///< s
  std::vector<FoundEffect> effects;
  double against = 0.0;  ///< by how much the deviance over these segments grows where the answer's own values are put
  bool operator==(const EffectsAtLength&) const = default;
};

/// RMS over short bins, of one channel, in its unit.
struct ChannelError {
  std::string channel;
  std::string unit;
  double floor = 0.0;  ///< of the noise, as estimated
  double fit = 0.0;
  double held_out = 0.0;  ///< predicted from the other folds
  bool operator==(const ChannelError&) const = default;
};

/// RMS errors of predictions of one channel over one horizon, from starts that the readings tell. NaN: not known.
struct HorizonError {
  double horizon = 0.0;  ///< s
  std::string channel;
  std::string unit;
  double floor = 0.0;  ///< of reading noise, starts and integration
  double base = 0.0, answer = 0.0;
  double base_held_out = 0.0, answer_held_out = 0.0;
  bool operator==(const HorizonError&) const = default;
};

/// A model that may be right, against the base.
struct RankedModel {
  std::vector<FoundEffect> effects;
  std::vector<std::string> look_alikes;  ///< what these data do not tell from its last effect, "name @ where"
  Gain gain;                             ///< over the base, see `DiagnosisMethod`
  std::optional<double> probability;     ///< among the ranking and the base; uncalibrated. Likelihoods alone tell it
  std::vector<ChannelError> errors;
  /// RMS over the floor, over all channels, see `DiagnosisMethod`. NaN: not told yet.
  double times_floor = std::numeric_limits<double>::quiet_NaN();
  double segment = 0.0;  ///< s, of the segments that the errors are about
  bool operator==(const RankedModel&) const = default;
};

enum class FigureUnit { percent, nats, chance, times_floor };
std::string_view to_string(FigureUnit unit);

/// A figure that a verdict is read from and that stands so near to its threshold that the last digits of another
/// machine may turn the verdict (verdict_figures.h).
struct AtThreshold {
  std::string figure;  ///< what it is
  FigureUnit unit = FigureUnit::nats;
  double value = 0.0, threshold = 0.0;   ///< of 1 where the unit is percent
  double low = 0.0, high = 0.0;          ///< between which it may come out
  Verdict other = Verdict::cannot_tell;  ///< the verdict beyond the threshold
  bool operator==(const AtThreshold&) const = default;
};

/// Figures that say how sure a verdict is, by name (evidence.h).
using Evidence = std::map<std::string, double>;

/// That the time limit stopped a search: its verdict is about the candidates examined so far, and preliminary.
struct StoppedSearch {
  std::string during;                     ///< "refits of candidates"
  std::vector<std::string> not_examined;  ///< candidates, "name @ where"
  std::string next;                       ///< what to do, a sentence
  bool operator==(const StoppedSearch&) const = default;
};

struct Diagnosis {
  Verdict verdict = Verdict::cannot_tell;
  double probability = std::numeric_limits<double>::quiet_NaN();  ///< of the verdict; NaN: `cannot_tell` states none
  std::vector<AtThreshold> at_threshold;  ///< why the verdict may be another on another machine; empty: it would not
  bool form_only = false;   ///< what is left makes up for the form of effects that the model has (present_effects.h)
  bool calibrated = false;  ///< the probability is how often such verdicts were right (calibration.h)
  Evidence evidence;
  std::vector<HorizonError> horizons;  ///< the shortest first
  std::vector<ChannelError> base;
  double base_times_floor = 0.0;
  double base_segment = 0.0;  ///< s, of the segments that `base` is about
  std::vector<RandomForce> forces;
  std::vector<RankedModel> ranking;  ///< the first is the answer; empty: nothing is better than the base
  /// The model's own free values, by address, fitted beside the answer under the estimated noise; empty where no
  /// verdict says that the model is right with it.
  std::vector<FoundParameter> values;
  // What is not there was not asked: by errors over horizons none of these is but the last.
  std::optional<double> p_by_chance;   ///< how often noise alone reaches the first round's best score
  std::optional<double> chance_95;     ///< nats, of the first round
  std::optional<double> free_force_p;  ///< whether a force of any form still explains more than noise, after the answer
  std::optional<Gain> free_force_gain;  ///< of that force, over the answer
  /// Of the answer over the model without any effect, in the noise of `free_force_gain`.
  std::optional<Gain> answer_gain;
  std::vector<ForceCurve> residual_force;  ///< that force, where it explains more than noise
  std::vector<ForceFormula> formulas;      ///< of it, one a joint, the largest gain first
  bool formulas_of_rest = false;         ///< for what the answer leaves, under its noise; else for what the model lacks
  std::vector<EffectsAtLength> lengths;  ///< of the answer (segment_lengths.h)
  std::size_t hypotheses = 0;            ///< effect × place
  std::vector<Untestable> untestable;
  std::vector<std::string> findings;  ///< sentences
  std::string next_test;              ///< as `lacuna trial --test` takes it; empty: nothing to be settled by a test
  std::optional<KnownSetup> next_test_setup;  ///< that it is to be made in; nothing where no recording has one
  std::string next_test_worth;                ///< the same with what it tells in nats, beside what a random test does
  std::optional<StoppedSearch> stopped;       ///< then no probability is stated, and `findings` says so first
  double seconds = 0.0;
};

/// Nothing where nothing was searched.
std::optional<DiagnosisMethod> method_of(const Diagnosis& diagnosis);

/// Nats; 0 where it is not known, or nothing.
double gained(const std::optional<Gain>& gain);

/// Whether the answer is to be added although something is left that the library does not have: it gains nearly all
/// that a force of free form beside it would leave to be gained, or more than the formula does.
bool answer_comes_first(const Diagnosis& diagnosis);

struct SearchState;  // search_state.h

/// What is diagnosed. Everything referred to must live until `diagnose` returns.
struct DiagnosisTask {
  const Experiment& experiment;
  const PluginCatalog& catalog;
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;     ///< to fit to; held-out ones are not looked at
  std::vector<double> values;           ///< fitted values of the model
  std::vector<std::string> among = {};  ///< effects to try; empty: all
  double segment = 0.0;  ///< s, of what is predicted from a start of its own; 0: the usual length (cut_trials.h)
  std::uint64_t seed = 1;
  int threads = 1;
  ProgressCallback progress = {};
  const SearchState* resume = nullptr;                ///< where an earlier call came to; null: from the beginning
  std::function<void(const SearchState&)> keep = {};  ///< gets it after every round, for a later call to go on from
};

}  // namespace lacuna
