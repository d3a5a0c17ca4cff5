#include "search/horizon_diagnosis.h"

#include "diagnosis/data_checks/data_doubts.h"
#include "diagnosis/likelihoods/diagnose.h"
#include "diagnosis/verdict/calibration.h"
#include "diagnosis/verdict/doubted_data.h"
#include "diagnosis/verdict/stopped_search.h"
#include "fitting/progress_meter.h"
#include "foundation/interrupt.h"
#include "search/decisions.h"
#include "search/find_missing.h"
#include "search/horizon_evidence.h"
#include "search/horizon_findings.h"
#include "search/set_search.h"
#include "search/settling_test.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

constexpr int kForLikelihoods = 2;  ///< of a robot that likelihoods can be asked about in some minutes
constexpr int kNotes = 90;          ///< of a usual search, which grow and shrink with its breadth,
constexpr int kFewestNotes = 10;    ///< and those that every search has

/// Candidates that no set was fitted with.
std::vector<std::string> not_examined(const DiagnosisTask& task, const Missing& missing) {
  std::vector<std::string> names = candidate_names(task.experiment, task.catalog, task.definition, task.among);
  std::erase_if(names, [&](const std::string& name) { return missing.examined.contains(name); });
  return names;
}

/// One diagnosis, by whichever procedure sees more.
class HorizonDiagnosis {
 public:
  HorizonDiagnosis(const DiagnosisTask& task, const SearchMemory& memory, const FreeRunFit& fit)
      : task_(task), memory_(memory), fit_(fit) {
    if (memory.resume) unfinished_ = *memory.resume;
  }

  Diagnosis run() {
    if (std::optional<Diagnosis> found = by_horizon()) return std::move(*found);
    return by_likelihood();
  }

 private:
  /// The model's, as fitted to the ladder.
  std::vector<double> values_of(const Ground& ground) const {
    std::vector<double> values = ground.plain().values;
    values.resize(task_.definition.free.size());
    return values;
  }

  void keep() const {
    if (memory_.keep) memory_.keep(unfinished_);
  }

  /// What is searched, with a line of progress for all that is done. It begins with the values that the file has: a fit
  /// of free runs may have gone far off with a model that lacks something.
  MissingTask missing_task(ProgressMeter& meter) {
    MissingTask missing{task_.experiment, task_.catalog, task_.trials, task_.definition.start_values(),
                        task_.among,      task_.threads};
    if (memory_.resume) missing.known = &memory_.resume->fits;
    missing.keep = [this](const KeptFits& fits) {
      unfinished_.fits = fits;
      keep();
    };
    meter.set_parts(kNotes + kFewestNotes);
    missing.note = [&meter](const std::string& what) {
      meter.end_part();
      meter.begin_part(what);
    };
    return missing;
  }

  /// Nothing where no prediction can be judged, and where likelihoods see more: near the noise, which is what they are
  /// about, if the data are enough for them.
  std::optional<Diagnosis> by_horizon() {
    ProgressMeter meter(task_.progress);
    std::unique_ptr<const Ground> ground;
    try {
      ground = std::make_unique<const Ground>(missing_task(meter));
    } catch (const NothingPredictable&) {
      return std::nullopt;
    }
    doubts_ = data_doubts({task_.definition, task_.model, task_.trials, values_of(*ground), true});
    const bool by_predictions_alone = too_little_for_likelihoods(doubts_);
    if (!by_predictions_alone && is_near_floor(most_times_floor(ground->ladder(), ground->fit().errors)))
      return std::nullopt;
    meter.set_parts(static_cast<int>(kNotes * std::min(1.0, breadth_of(*ground))) + kFewestNotes);
    Diagnosis result = search(*ground);
    if (result.verdict == Verdict::not_in_library) {  // what the library lacks, likelihoods put into a formula
      Diagnosis by_likelihoods = by_likelihood();
      if (by_likelihoods.verdict == Verdict::not_in_library) return by_likelihoods;
    }
    result.seconds = meter.seconds();
    if (result.verdict == Verdict::effect_found && !result.stopped)
      if (const Helped helped = where_answer_helps(result.horizons); !helps_everywhere(helped))
        return undecided(std::move(result), helped, ground->coordinates());
    if (result.verdict == Verdict::nothing_missing && !result.stopped && !by_predictions_alone) return std::nullopt;
    add_doubts(doubts_, result);
    return result;
  }

  /// What helps at some horizons alone. Likelihoods may know better.
  Diagnosis undecided(Diagnosis result, const Helped& helped, int coordinates) {
    if (coordinates <= kForLikelihoods && !too_little_for_likelihoods(doubts_))
      if (Diagnosis other = by_likelihood(); other.verdict != Verdict::effect_found || explains_to_noise(other))
        return other;
    doubt_answer(helped, result);
    add_doubts(doubts_, result);
    return result;
  }

  Diagnosis search(const Ground& ground) const {
    const Missing missing = find_missing(ground);
    Diagnosis result = findings_of(missing);
    if (missing.stopped)
      mark_stopped({"the search", not_examined(task_, missing), {}}, unfinished_.fits.size(), result);
    else {
      tell_probability(result, evidence_of(missing, result.horizons), true);
      propose_settling_test(task_, ground, missing, result);
    }
    for (std::string& note : confirmation_notes(missing)) result.findings.push_back(std::move(note));
    if (const std::string note = reach_note(missing.ladder, task_.trials); !note.empty())
      result.findings.push_back(note);
    return result;
  }

  Diagnosis by_likelihood() {
    DiagnosisTask task = task_;
    if (fit_) task.values = fit_();
    const std::optional<SearchState> before = unfinished_.likelihoods;
    task.resume = before ? &*before : nullptr;
    task.keep = [this](const SearchState& state) {
      unfinished_.likelihoods = state;
      keep();
    };
    return diagnose(task);
  }

  const DiagnosisTask& task_;
  const SearchMemory& memory_;
  const FreeRunFit& fit_;
  UnfinishedSearch unfinished_;
  std::vector<Doubt> doubts_;
};

}  // namespace

Diagnosis find_missing_effects(const DiagnosisTask& task, const SearchMemory& memory, const FreeRunFit& fit) {
  try {
    return HorizonDiagnosis(task, memory, fit).run();
  } catch (const TimeIsUp&) {
    lift_time_limit();
    return stopped_before_search(task.experiment, task.catalog, task.definition, task.among, "the fit of the model");
  }
}

}  // namespace lacuna
