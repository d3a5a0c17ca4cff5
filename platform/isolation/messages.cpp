#include "isolation/messages.h"

namespace lacuna {

WiredModel wired(const KnownModel& model) {
  return {model.number, model.genome, model.model.values, model.score, model.restart};
}

WiredTrial wired(const TargetTrial& trial) {
  WiredTrial travelling;
  if (const auto* commands = std::get_if<CommandSeries>(&trial.drive.drive)) travelling.commands = *commands;
  travelling.genome = trial.genome;
  travelling.duration = trial.drive.duration;
  travelling.start = trial.drive.start;
  travelling.setup = trial.drive.setup;
  travelling.trial = trial.trial;
  travelling.set_aside_in = trial.set_aside_in;
  return travelling;
}

WiredState wired(const EeaState& state) {
  WiredState travelling;
  travelling.pass = state.pass;
  for (const TargetTrial& trial : state.trials) travelling.trials.push_back(wired(trial));
  for (const KnownModel& model : state.best) travelling.best.push_back(wired(model));
  return travelling;
}

}  // namespace lacuna
