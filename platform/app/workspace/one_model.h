#pragma once

#include "app/workspace/test_reading.h"
#include "app/workspace/experiment_workflow.h"
#include "report/text/model_prediction.h"

namespace lacuna {

/// Simulates the experiment's model alone, with its fitted values, or as they are written where there is no trial to
/// fit them to or none is free. Without a test, or with the name of a trial for one, on fit trials; held-out ones are
/// not looked at. Throws `BadInput` for a test that cannot be read, and `Error` where nothing can be simulated.
ModelPrediction predict_by_one_model(ExperimentWorkflow& workflow, const AskedTest& asked);

}  // namespace lacuna
