#pragma once

#include <lacuna/effect_list.h>
#include <lacuna/engine_settings.h>
#include <lacuna/setup.h>
#include <lacuna/time_series.h>

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Stored records as plain data. Values are SI; a NaN means "not known" and is stored as NULL.
/// `schema/database.md` describes the tables that these become.
namespace lacuna {

inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// A row's key: the run's number × 2^40 + a counter. Each table has a type of its own.
template <class Table>
struct Id {
  std::int64_t value = 0;
  auto operator<=>(const Id&) const = default;
};
using RunId = Id<struct RunTable>;  ///< the run's small number in its file
using ExperimentId = Id<struct ExperimentTable>;
using RevisionId = Id<struct RevisionTable>;
using TrialId = Id<struct TrialTable>;
using TraceId = Id<struct TraceTable>;
using FitId = Id<struct FitTable>;
using ComparisonId = Id<struct ComparisonTable>;
using DiagnosisId = Id<struct DiagnosisTable>;
using ModelId = Id<struct ModelTable>;

/// One call of the program that writes.
struct RunRecord {
  std::string command;  ///< the command line as given
  std::uint64_t seed = 0;
  int threads = 1;
  std::string task = {};  ///< that it carries out, from which its identity follows; empty: none
};

enum class RunEnding { done, failed, interrupted };

struct PluginFileRecord {
  std::string file;
  std::string sha256;
  std::string build_id;
};

/// A file that a robot was read from.
struct RobotFileRecord {
  std::string file;
  std::string sha256;  ///< of its text
};

/// An experiment as it was resolved: the file's text and the overrides of the command line.
struct ExperimentRecord {
  std::string name;
  std::string file;  ///< as the user named it
  std::string text;
  std::vector<std::string> overrides;
  std::vector<std::string> decided = {};  ///< see `Experiment::decided`
};

struct FreeValueRecord {
  std::string address;
  std::string unit;
  double lower = 0.0;
  double upper = 0.0;
  double start = 0.0;
};

/// What makes a revision; its digest covers everything here, the order of `effects` aside.
struct RevisionRecord {
  std::string robot;       ///< the robot's name
  std::string robot_text;  ///< canonical description, see `canonical_text(const RobotSpec&)` in canonical_text.h
  std::vector<FreeValueRecord> free;
  EffectList effects;
  EngineSettings engine;
  std::string fit_data_digest;  ///< see `digest_of_trials` in canonical_text.h
};

/// A revision as it stands in the database.
struct StoredRevision {
  RevisionId id;
  int number = 0;  ///< within the experiment, from 1
  std::optional<int> parent;
  std::string digest;
  std::string change;  ///< relative to the parent: "rigid", "coulomb_friction", "without payload", "engine changed"
  bool found = false;  ///< it was there before
};

struct TrialRecord {
  std::string name;
  std::string file;    ///< as the experiment names it
  std::string digest;  ///< of its data: `digest_of(const Trial&)` in canonical_text.h
  bool held_out = false;
  double duration = 0.0;  ///< s
  std::int64_t samples = 0;
  Setup setup = {};
  std::vector<std::string> setting_units = {};  ///< SI, one a value of the setup; none: not known
};

enum class TraceKind { measured, commands, predicted, centre_of_mass };
enum class TracePrecision { float32, float64 };

enum class AtBound { neither, lower, upper };

struct FittedValueRecord {
  std::string address;
  std::string unit;
  double start = kNotKnown;
  double value = kNotKnown;
  double standard_error = kNotKnown;  ///< infinite where the data cannot tell
  double lower = kNotKnown;           ///< 95 % interval
  double upper = kNotKnown;
  AtBound at_bound = AtBound::neither;
  bool identifiable = true;
};

/// One round of a fit: all data cut into segments of one length.
struct FitStageRecord {
  std::string name;      ///< "segments of 0.1 s", "free run"
  double segment = 0.0;  ///< s; 0: whole trials
  std::int64_t segments = 0;
  std::int64_t starts = 0;    ///< starting points refined in it
  std::int64_t agreeing = 0;  ///< of these, how many reached the same error as the best
  std::int64_t iterations = 0;
  bool converged = false;
  double residual = kNotKnown;  ///< RMS of residual over sensor noise
  std::vector<double> values;   ///< in the order of the revision's free values
};

struct FitRecord {
  std::string settings;  ///< everything besides the revision that the result depends on: method, segments, starts,
                         ///< loss, seed, digests of the plugin files used; compared as text by `last_fit_of`
  std::string method;    ///< "multiple_shooting", "free_run"
  std::string loss;      ///< "huber", "squared"
  double loss_scale = kNotKnown;
  bool converged = false;        ///< in the last stage
  double residual = kNotKnown;   ///< RMS of residual over sensor noise, last stage
  std::int64_t samples = 0;      ///< measured values that counted in the last stage
  std::int64_t simulations = 0;  ///< of all starts and stages
  std::int64_t invalid_simulations = 0;
  std::int64_t starts = 1;
  std::int64_t agreeing = 1;              ///< starts that reached the same error
  double correlation_time = kNotKnown;    ///< s, of the residual
  std::vector<FittedValueRecord> values;  ///< in the order of the revision's free values
  std::vector<FitStageRecord> stages;
  Eigen::MatrixXd covariance;            ///< of the values, SI; empty: not computed
  std::vector<std::string> cannot_tell;  ///< sentences: which combinations the data do not determine
  std::vector<std::string> notes;        ///< sentences
  double seconds = kNotKnown;            ///< work time; kept outside the content
};

/// Errors of one free run (or of restarts every `horizon` seconds) on one channel of one trial.
struct ScoreRecord {
  TrialId trial;
  std::string channel;
  std::string unit;
  double horizon = 0.0;                ///< s; 0: one free run of the whole trial
  std::int64_t samples = 0;            ///< to score
  double rmse = kNotKnown;             ///< not known: no samples, or the trial cannot be simulated
  double normalised_rmse = kNotKnown;  ///< rmse / standard deviation of the measured channel
  double theil_u = kNotKnown;
  double bias = kNotKnown;        ///< mean of measured − predicted
  double bias_share = kNotKnown;  ///< of the mean squared error: Theil's three parts, which add up to 1
  double magnitude_share = kNotKnown;
  double phase_share = kNotKnown;
  double max_error = kNotKnown;        ///< largest |measured − predicted|
  double max_error_time = kNotKnown;   ///< s
  double floor = kNotKnown;            ///< noise floor of this trial and channel
  double numerical_error = kNotKnown;  ///< RMSE of the integration, channel's unit
  double as_written_rmse = kNotKnown;  ///< with the file's start values, unfitted
};

/// The error of a free run in one channel when the model is right. The squares of the parts add up.
struct NoiseFloorRecord {
  TrialId trial;
  std::string channel;
  std::string unit;
  double floor = kNotKnown;   ///< RMSE, all parts together
  double sensor = kNotKnown;  ///< parts
  double input = kNotKnown;
  double process = kNotKnown;
  std::string origin;  ///< "encoder step 2.9/√12; rest agrees"
};

enum class ComparisonKind { refitted, as_written };

struct ComparisonRecord {
  ComparisonKind kind = ComparisonKind::refitted;
  std::optional<FitId> fit;
  std::optional<int> look;  ///< number of the look at held-out data; none: not looked at
  double step = kNotKnown;  ///< s, integration step used
  std::vector<ScoreRecord> scores;
  std::vector<NoiseFloorRecord> floors;
  std::vector<std::string> findings;  ///< sentences, the largest first
  double seconds = kNotKnown;         ///< work time; kept outside the content
};

struct StoredTrial {
  TrialId id;
  TrialRecord record;
};

struct StoredComparison {
  ComparisonId id;
  RevisionId revision;
  ComparisonRecord record;
};

struct StoredFit {
  FitId id;
  FitRecord record;
};

/// Errors of predictions that restart every `horizon` seconds, pooled over trials.
struct HorizonRow {
  double horizon = 0.0;  ///< s
  double fit_rmse = kNotKnown;
  double held_out_rmse = kNotKnown;
};

/// One channel of one revision, pooled over trials, from its latest refitted comparisons.
struct HistoryRow {
  RevisionId revision;
  int number = 0;
  std::optional<int> parent;
  std::string change;
  bool current = false;  ///< the revision that the experiment used last
  bool fitted = false;   ///< there is a fit of it; not after an interrupted or failed one
  std::string channel;
  std::string unit;
  double fit_rmse = kNotKnown;
  double held_out_rmse = kNotKnown;
  double floor = kNotKnown;
  double times_floor = kNotKnown;         ///< held-out RMSE (if never looked at, fit RMSE) / floor
  int failed_trials = 0;                  ///< that cannot be simulated; the error of their side is then not known
  std::vector<HorizonRow> horizons = {};  ///< the shortest first
};

/// A value of an effect that a candidate adds, SI.
struct CandidateValueRecord {
  std::string effect, place, name, unit;
  double value = kNotKnown;
  double lower = kNotKnown, upper = kNotKnown;  ///< 95 %
};

/// A model that a diagnosis ranked.
struct CandidateRecord {
  std::vector<std::string> effects;      ///< such as "coulomb_friction @ joint.hinge"
  std::vector<std::string> look_alikes;  ///< of the last of them
  double gain = kNotKnown, gain_lower = kNotKnown, gain_upper = kNotKnown;  ///< nats, of what: see the method
  double times_floor = kNotKnown;                                           ///< on what was left out
  double fitted_times_floor = kNotKnown;
  double probability = kNotKnown;
  std::vector<CandidateValueRecord> values;
};

struct DiagnosisRecord {
  std::string settings;  ///< everything but the revision that its result follows from
  std::string verdict;
  std::optional<std::string> method = {};  ///< `likelihood` or `horizon`; nothing where nothing was searched
  double probability = kNotKnown;
  bool calibrated = false;
  double chance = kNotKnown;  ///< how often noise alone reaches the best score
  std::int64_t hypotheses = 0;
  double base_times_floor = kNotKnown;  ///< on what was left out
  double base_fitted_times_floor = kNotKnown;
  std::string document;                     ///< JSON, the whole of it
  std::vector<CandidateRecord> candidates;  ///< by rank
};

}  // namespace lacuna
