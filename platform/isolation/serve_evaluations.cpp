#include "isolation/serve_evaluations.h"

#include "eea/local_evaluations.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/processes/process_limits.h"
#include "isolation/carried.h"

#include <utility>

namespace lacuna {
namespace {

KnownModel known_model(const EeaDefinition& definition, WiredModel&& wired) {
  KnownModel model{wired.number, std::move(wired.genome), {}, wired.score, wired.restart};
  if (!model.genome.empty()) model.model = definition.decode_model(model.genome);
  model.model.values = std::move(wired.values);
  return model;
}

TargetTrial target_trial(const EeaDefinition& definition, WiredTrial&& wired) {
  TargetTrial trial;
  trial.drive = wired.commands
                    ? Test{std::move(*wired.commands), wired.duration, std::move(wired.start), std::move(wired.setup)}
                    : definition.decode_test(wired.genome);
  trial.trial = std::move(wired.trial);
  trial.genome = std::move(wired.genome);
  trial.set_aside_in = wired.set_aside_in;
  return trial;
}

EeaState state_of(const EeaDefinition& definition, WiredState&& wired) {
  EeaState state;
  state.pass = wired.pass;
  for (WiredTrial& trial : wired.trials) state.trials.push_back(target_trial(definition, std::move(trial)));
  for (WiredModel& model : wired.best) state.best.push_back(known_model(definition, std::move(model)));
  return state;
}

/// Carries out requests, on one thread.
class Clerk {
 public:
  explicit Clerk(const EeaDefinition& definition) : definition_(definition), here_(definition, {1}) {}

  std::string answer(Request&& request) {
    const Evaluation evaluation;
    CallPage::set_task(0);
    return std::visit([this]<class Asked>(Asked&& asked) { return this->carry_out(std::forward<Asked>(asked)); },
                      std::move(request));
  }

 private:
  std::string carry_out(WorkerTask&&) { throw Error("a worker process was given a second task"); }

  std::string carry_out(BeginEstimation&& asked) {
    here_.begin_estimation(state_of(definition_, std::move(asked.state)));
    return {};
  }

  std::string carry_out(ScoreModelsRequest&& asked) {
    std::vector<ModelScore> scores;
    for (std::size_t i = 0; i < asked.models.size(); ++i) {
      CallPage::set_task(static_cast<std::uint32_t>(i));
      const ModelProposal model = definition_.decode_model(asked.models[i]);
      const CandidateModel candidate{&asked.models[i], &model};
      scores.push_back(std::move(here_.score({&candidate, 1}, asked.bar).front()));
    }
    return to_bytes(scores);
  }

  std::string carry_out(BeginExploration&& asked) {
    state_ = state_of(definition_, std::move(asked.state));  // referred to by the judges
    return to_bytes(here_.begin_exploration(state_));
  }

  std::string carry_out(JudgeTests&& asked) {
    std::vector<JudgedTest> judged;
    for (std::size_t i = 0; i < asked.tests.size(); ++i) {
      CallPage::set_task(static_cast<std::uint32_t>(i));
      judged.push_back(std::move(here_.judge({&asked.tests[i], 1}).front()));
    }
    return to_bytes(judged);
  }

  std::string carry_out(ScoreOn&& asked) {
    return to_bytes(std::vector{here_.score_on(known_model(definition_, std::move(asked.model)),
                                               target_trial(definition_, std::move(asked.trial)), asked.pass)});
  }

  std::string carry_out(PredictTrial&& asked) {
    return to_bytes(std::vector{here_.predict_trial(known_model(definition_, std::move(asked.model)),
                                                    target_trial(definition_, std::move(asked.trial)))});
  }

  std::string carry_out(FindDelays&& asked) {
    const EeaState state = state_of(definition_, std::move(asked.state));
    std::vector<ModelScore> scores;
    for (std::size_t i = 0; i < asked.models.size(); ++i) {
      CallPage::set_task(static_cast<std::uint32_t>(i));
      const KnownModel model = known_model(definition_, std::move(asked.models[i]));
      const KnownModel* const alone = &model;
      scores.push_back(std::move(here_.find_delays({&alone, 1}, state).front()));
    }
    return to_bytes(scores);
  }

  const EeaDefinition& definition_;
  LocalEvaluations here_;
  EeaState state_;
};

bool send(const MessageChannel& channel, AnswerKind kind, const std::string& what) {
  return channel.send(static_cast<char>(kind) + what);
}

}  // namespace

WorkerTask receive_task(const MessageChannel& channel) {
  const std::optional<std::string> message = channel.receive();
  if (!message) throw Error("a worker process was given no task");
  Request request = from_bytes<Request>(*message);
  if (auto* task = std::get_if<WorkerTask>(&request)) return std::move(*task);
  throw Error("a worker process was given no task");
}

void serve_evaluations(const MessageChannel& channel, const EeaDefinition& definition) {
  Clerk clerk(definition);
  if (!send(channel, AnswerKind::done, {})) return;
  while (const std::optional<std::string> message = channel.receive()) {
    try {
      if (!send(channel, AnswerKind::done, clerk.answer(from_bytes<Request>(*message)))) return;
    } catch (const std::exception& error) {
      send_failure(channel, failure_sentence(error));
    }
  }
}

void send_failure(const MessageChannel& channel, const std::string& sentence) {
  send(channel, AnswerKind::failed, to_bytes(sentence));
}

void send_lost(const MessageChannel& channel, const LostWork& lost) { send(channel, AnswerKind::lost, to_bytes(lost)); }

}  // namespace lacuna
