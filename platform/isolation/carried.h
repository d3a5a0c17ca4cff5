#pragma once

#include "isolation/messages.h"

#include <variant>

/// What each message consists of (isolation/wire.h).
namespace lacuna {

template <class Wire>
void carry(Wire& wire, Setup::Value& value) {
  carry(wire, value.address);
  carry(wire, value.value);
}

template <class Wire>
void carry(Wire& wire, Setup& setup) {
  carry(wire, setup.name);
  carry(wire, setup.values);
}

template <class Wire>
void carry(Wire& wire, CommandSeries& commands) {
  carry(wire, commands.series);
  carry(wire, commands.hold);
  carry(wire, commands.before);
  carry(wire, commands.may_be_off);
}

template <class Wire>
void carry(Wire& wire, StartState& start) {
  carry(wire, start.positions);
  carry(wire, start.velocities);
}

template <class Wire>
void carry(Wire& wire, InitialValue& value) {
  carry(wire, value.knowledge);
  carry(wire, value.position);
  carry(wire, value.velocity);
}

/// All but the controller, which the phases do not ask for.
template <class Wire>
void carry(Wire& wire, Trial& trial) {
  carry(wire, trial.name);
  carry(wire, trial.commands);
  carry(wire, trial.measured);
  carry(wire, trial.initial);
  carry(wire, trial.sensor_noise);
  carry(wire, trial.command_noise);
  carry(wire, trial.held_out);
  carry(wire, trial.setup);
  carry(wire, trial.closed_loop);
  carry(wire, trial.centre_of_mass);
}

template <class Wire>
void carry(Wire& wire, WiredModel& model) {
  carry(wire, model.number);
  carry(wire, model.genome);
  carry(wire, model.values);
  carry(wire, model.score);
  carry(wire, model.restart);
}

template <class Wire>
void carry(Wire& wire, WiredTrial& trial) {
  carry(wire, trial.genome);
  carry(wire, trial.commands);
  carry(wire, trial.duration);
  carry(wire, trial.start);
  carry(wire, trial.setup);
  carry(wire, trial.trial);
  carry(wire, trial.set_aside_in);
}

template <class Wire>
void carry(Wire& wire, WiredState& state) {
  carry(wire, state.pass);
  carry(wire, state.trials);
  carry(wire, state.best);
}

template <class Wire>
void carry(Wire& wire, WorkerTask& task) {
  carry(wire, task.experiment);
  carry(wire, task.text);
  carry(wire, task.overrides);
  carry(wire, task.decided);
  carry(wire, task.plugin_paths);
  carry(wire, task.evaluation_limit);
  carry(wire, task.memory);
  carry(wire, task.files);
}

template <class Wire>
void carry(Wire& wire, BeginEstimation& request) {
  carry(wire, request.state);
}

template <class Wire>
void carry(Wire& wire, ScoreModelsRequest& request) {
  carry(wire, request.models);
  carry(wire, request.bar);
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
  carry(wire, request.model);
  carry(wire, request.trial);
  carry(wire, request.pass);
}

template <class Wire>
void carry(Wire& wire, Foretell& request) {
  carry(wire, request.model);
  carry(wire, request.trial);
}

template <class Wire>
void carry(Wire& wire, FindDelays& request) {
  carry(wire, request.models);
  carry(wire, request.state);
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
    throw Error("a message between two processes is none");
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
  carry(wire, lost.component);
  carry(wire, lost.deed);
  carry(wire, lost.task);
  carry(wire, lost.is_the_tasks);
}

template <class Wire>
void carry(Wire& wire, ModelScore& score) {
  carry(wire, score.total);
  carry(wire, score.trials);
  carry(wire, score.kind);
  carry(wire, score.reason);
  carry(wire, score.steps);
  carry(wire, score.values);
}

template <class Wire>
void carry(Wire& wire, JudgedTest& judged) {
  carry(wire, judged.fitness);
  carry(wire, judged.reason);
  carry(wire, judged.steps);
}

/// What a journal keeps of it: neither slopes nor what they are worth.
template <class Wire>
void carry(Wire& wire, ForetoldTrial& foretold) {
  carry(wire, foretold.valid);
  carry(wire, foretold.prediction.sensors);
  carry(wire, foretold.prediction.centre_of_mass);
  carry(wire, foretold.steps);
}

}  // namespace lacuna
