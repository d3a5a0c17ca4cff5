#pragma once

#include <lacuna/target_system.h>

#include "eea/eea_run.h"
#include "evaluation/prediction/target_simulator.h"
#include "process/process_target.h"

namespace lacuna {

/// The target of a run and what its plugin may ask for.
struct EeaTarget {
  TargetSystem& system;
  ComponentOrigin origin;
  TargetSimulator* simulator = nullptr;  ///< of a simulated target
  ProcessTarget* program = nullptr;      ///< of an outside target
  int repeats = 0;                       ///< how often a failed test is repeated before another takes its place
  double pause = 0.0;                    ///< s, between a failed test and the next attempt
};

/// Step 2 of the seed: carries out `state.next_test` on the target and adds the trial to `state.trials`. A failed test
/// is repeated as often as the target allows, then replaced by a random one, a few times; each failure is recorded.
/// With `for_transfer` the trial is only recorded: no model will be fitted to it.
void carry_out_test(const EeaRun& run, const EeaTarget& target, EeaState& state, bool for_transfer);

/// The best model's prediction of a trial of the state, or of its next one, for the record.
void note_prediction(const EeaRun& run, EeaState& state, int number, const TargetTrial& trial);

}  // namespace lacuna
