#pragma once

#include "isolation/messages.h"

#include <variant>

/// The fields of each message (isolation/wire.h).
namespace lacuna {

template <class Wire>
void carry(Wire& wire, Setup::Value& value) {
  carry_all(wire, value.address, value.value);
}

template <class Wire>
void carry(Wire& wire, Setup& setup) {
  carry_all(wire, setup.name, setup.values);
}

template <class Wire>
void carry(Wire& wire, CommandSeries& commands) {
  carry_all(wire, commands.series, commands.hold, commands.before, commands.may_be_off);
}

template <class Wire>
void carry(Wire& wire, StartState& start) {
  carry_all(wire, start.positions, start.velocities);
}

template <class Wire>
void carry(Wire& wire, InitialValue& value) {
  carry_all(wire, value.knowledge, value.position, value.velocity);
}

/// All fields but the controller, which the phases do not need.
template <class Wire>
void carry(Wire& wire, Trial& trial) {
  carry_all(wire, trial.name, trial.commands, trial.measured, trial.initial, trial.sensor_noise, trial.command_noise,
            trial.held_out, trial.setup, trial.closed_loop, trial.centre_of_mass);
}

template <class Wire>
void carry(Wire& wire, WiredModel& model) {
  carry_all(wire, model.number, model.genome, model.values, model.score, model.restart);
}

template <class Wire>
void carry(Wire& wire, WiredTrial& trial) {
  carry_all(wire, trial.genome, trial.commands, trial.duration, trial.start, trial.setup, trial.trial,
            trial.set_aside_in);
}

template <class Wire>
void carry(Wire& wire, WiredState& state) {
  carry_all(wire, state.pass, state.trials, state.best);
}

template <class Wire>
void carry(Wire& wire, WorkerTask& task) {
  carry_all(wire, task.experiment, task.text, task.overrides, task.decided, task.plugin_paths, task.evaluation_limit,
            task.memory, task.files);
}

template <class Wire>
void carry(Wire& wire, BeginEstimation& request) {
  carry(wire, request.state);
}

template <class Wire>
void carry(Wire& wire, ScoreModelsRequest& request) {
  carry_all(wire, request.models, request.bar);
}

template <class Wire>
void carry(Wire& wire, BeginExploration& request) {
  carry(wire, request.state);
}

template <class Wire>
void carry(Wire& wire, JudgeTests& request) {
  carry(wire, request.tests);
}

template <class Wire>
void carry(Wire& wire, ScoreOn& request) {
  carry_all(wire, request.model, request.trial, request.pass);
}

template <class Wire>
void carry(Wire& wire, PredictTrial& request) {
  carry_all(wire, request.model, request.trial);
}

template <class Wire>
void carry(Wire& wire, FindDelays& request) {
  carry_all(wire, request.models, request.state);
}

/// Makes the alternative with this index.
template <std::size_t index = 0>
void make_alternative(Request& request, std::uint8_t wanted) {
  if constexpr (index < std::variant_size_v<Request>) {
    if (wanted == index)
      request.emplace<index>();
    else
      make_alternative<index + 1>(request, wanted);
  } else {
    throw Error("a message between two processes has an unknown kind; please report this with the command");
  }
}

template <class Wire>
void carry(Wire& wire, Request& request) {
  auto kind = static_cast<std::uint8_t>(request.index());
  carry(wire, kind);
  if constexpr (Wire::kReads) make_alternative(request, kind);
  std::visit([&](auto& asked) { carry(wire, asked); }, request);
}

template <class Wire>
void carry(Wire& wire, LostWork& lost) {
  carry_all(wire, lost.component, lost.deed, lost.task, lost.is_the_tasks);
}

template <class Wire>
void carry(Wire& wire, ModelScore& score) {
  carry_all(wire, score.total, score.trials, score.kind, score.reason, score.steps, score.values);
}

template <class Wire>
void carry(Wire& wire, JudgedTest& judged) {
  carry_all(wire, judged.fitness, judged.reason, judged.steps);
}

/// The part that a journal keeps: without slopes and their worth.
template <class Wire>
void carry(Wire& wire, PredictedTrial& predicted) {
  carry_all(wire, predicted.valid, predicted.prediction.sensors, predicted.prediction.centre_of_mass, predicted.steps);
}

}  // namespace lacuna
