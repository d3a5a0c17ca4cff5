#pragma once

#include "app/workspace/open_experiment.h"
#include "answer/diagnosis.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "storage/core/records.h"

#include <string>
#include <vector>

namespace lacuna {

/// What the rooms compute, as the records that storage keeps, and back.

RevisionRecord revision_record(const OpenExperiment& opened);
/// `definition`: tells the units of what the trial's setup sets.
TrialRecord trial_record(const Trial& trial, const ModelDefinition& definition);
FitRecord fit_record(const FitResult& fit, const FitSection& options, const std::string& settings);
FitResult fit_result(const FitRecord& record);
/// `trials`: the stored trials, in the comparison's order.
ComparisonRecord comparison_record(const Comparison& comparison, const std::vector<TrialId>& trials);
DiagnosisRecord diagnosis_record(const Diagnosis& diagnosis, const std::string& settings);
TimeSeries predicted_series(const Trial& trial, const TrialComparison& comparison);

}  // namespace lacuna
