#pragma once

#include "eea/definition/evaluations.h"
#include "isolation/wire.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a host asks of a worker process, and what that answers. Models and tests travel as genomes, which both decode
/// by the same plugin; robots and effects are made by each from the same experiment.
namespace lacuna {

/// The first message: what to work on.
struct WorkerTask {
  std::filesystem::path experiment;    ///< of the file, for names in it
  std::string text;                    ///< of the file
  std::vector<std::string> overrides;  ///< --set
  std::vector<std::string> decided;    ///< what the host decided where the file leaves it open
  std::vector<std::filesystem::path> plugin_paths;
  double evaluation_limit = 0.0;        ///< s; 0: none
  std::uint64_t memory = 0;             ///< bytes; 0: as much as the machine has
  std::vector<std::string> files = {};  ///< SHA-256 of plugins and robot files that the host has read
};

/// A model of the last estimation phase as it travels.
struct WiredModel {
  std::uint64_t number = 0;
  Genome genome;               ///< empty: the experiment's own model
  std::vector<double> values;  ///< with delays that no gene says
  double score = 0.0;
  int restart = 0;
};

/// A trial as it travels. A test that is a series of commands travels with them, one that is a controller as its
/// genome.
struct WiredTrial {
  Genome genome;
  std::optional<CommandSeries> commands;
  double duration = 0.0;  ///< s
  StartState start;
  std::string setup;
  Trial trial;
  std::optional<int> set_aside_in;
};

/// What phases need of a state.
struct WiredState {
  int pass = 1;
  std::vector<WiredTrial> trials;
  std::vector<WiredModel> best;
};

struct BeginEstimation {
  WiredState state;
};
struct ScoreModelsRequest {
  std::vector<Genome> models;
  std::optional<double> bar;
};
struct BeginExploration {
  WiredState state;
};
struct JudgeTests {
  std::vector<Genome> tests;
};
struct ScoreOn {
  WiredModel model;
  WiredTrial trial;
  int pass = 1;
};
struct Foretell {
  WiredModel model;
  WiredTrial trial;
};
struct FindDelays {
  std::vector<WiredModel> models;
  WiredState state;
};

/// In this order on the wire.
using Request = std::variant<WorkerTask, BeginEstimation, ScoreModelsRequest, BeginExploration, JudgeTests, ScoreOn,
                             Foretell, FindDelays>;

/// How an answer begins; `done` is followed by what was asked for.
enum class AnswerKind : std::uint8_t {
  done,
  failed,  ///< followed by the sentence of an exception
  lost     ///< followed by `LostWork`: the process that did the work has ended, and so does this one
};

struct LostWork {
  std::string component;      ///< of a plugin that ended it, as messages name it; empty: not known
  std::string deed;           ///< a clause
  std::uint32_t task = 0;     ///< which of the candidates or tests of the request it was at
  bool is_the_tasks = false;  ///< the same task would end the next process in the same way
};

/// The trial and model of a state as they travel, and back by what both sides know.
WiredModel wired(const KnownModel& model);
WiredTrial wired(const TargetTrial& trial);
WiredState wired(const EeaState& state);

}  // namespace lacuna
