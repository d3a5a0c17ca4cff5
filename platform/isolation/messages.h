#pragma once

#include "eea/definition/evaluations.h"
#include "isolation/wire.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Requests of a host to a worker process, and the answers. Models and tests travel as genomes, which both sides decode
/// with the same plugin; robots and effects are made by each side from the same experiment.
namespace lacuna {

/// The first message: the task of the worker.
struct WorkerTask {
  std::filesystem::path experiment;    ///< of the file, for names in it
  std::string text;                    ///< of the file
  std::vector<std::string> overrides;  ///< --set
  std::vector<std::string> decided;    ///< the host's decisions where the file leaves a setting open
  std::vector<std::filesystem::path> plugin_paths;
  double evaluation_limit = 0.0;        ///< s; 0: none
  std::uint64_t memory = 0;             ///< bytes; 0: as much as the machine has
  std::vector<std::string> files = {};  ///< SHA-256 of plugins and robot files that the host has read
};

/// A model of the last estimation phase as sent.
struct WiredModel {
  std::uint64_t number = 0;
  Genome genome;               ///< empty: the experiment's own model
  std::vector<double> values;  ///< with delays of sensors that are not genes
  double score = 0.0;
  int restart = 0;
};

/// A trial as sent. A test that is a series of commands is sent with them, a test that is a controller as its genome.
struct WiredTrial {
  Genome genome;
  std::optional<CommandSeries> commands;
  double duration = 0.0;  ///< s
  StartState start;
  std::string setup;
  Trial trial;
  std::optional<int> set_aside_in;
};

/// The part of a state that phases need.
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
struct PredictTrial {
  WiredModel model;
  WiredTrial trial;
};
struct FindDelays {
  std::vector<WiredModel> models;
  WiredState state;
};

/// In this order on the wire.
using Request = std::variant<WorkerTask, BeginEstimation, ScoreModelsRequest, BeginExploration, JudgeTests, ScoreOn,
                             PredictTrial, FindDelays>;

/// First byte of an answer; after `done` follows the result.
enum class AnswerKind : std::uint8_t {
  done,
  failed,  ///< followed by the text of an exception
  lost     ///< followed by `LostWork`: the process that did the work has ended, and this one ends, too
};

struct LostWork {
  std::string component;      ///< name of the plugin that ended it, as in messages; empty: not known
  std::string deed;           ///< a clause
  std::uint32_t task = 0;     ///< index of the candidate or test of the request
  bool is_the_tasks = false;  ///< repeating the task would end the next process in the same way
};

/// Converts trials and models of a state to their sent form and back.
WiredModel wired(const KnownModel& model);
WiredTrial wired(const TargetTrial& trial);
WiredState wired(const EeaState& state);

}  // namespace lacuna
