#pragma once

#include <lacuna/effect_list.h>
#include <lacuna/engine_settings.h>
#include <lacuna/robot_format.h>
#include <lacuna/robot_spec.h>

#include "foundation/text/problem.h"
#include "foundation/processes/process_source.h"
#include "foundation/recording_source.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// A range of values by address pattern, as in `free = { "body.*.mass" = [1.0, 7.0] }`.
struct FreeRange {
  std::string pattern;
  double lower = 0.0;
  double upper = 0.0;
  std::optional<double> start;  ///< from `{ range = [l, u], start = s }`; else the robot's own value
};

/// A component that a file names, with values for some of its parameters, SI.
struct ComponentChoice {
  std::string name;
  std::map<std::string, double> parameters;
};

/// A model of a robot, or the definition of a simulated target.
struct ModelSection {
  std::string robot;                                   ///< plugin name
  std::map<std::string, double> parameters;            ///< of the robot plugin
  std::filesystem::path file;                          ///< of a declared robot
  std::string file_digest;                             ///< SHA-256 of its text
  std::optional<RobotSpec> declared;                   ///< its content
  std::optional<std::string> foreign_text;             ///< of a file that is not TOML, until a format has read it
  std::vector<std::filesystem::path> parts;            ///< files that it includes, once a format has read it
  RobotBase base = RobotBase::as_written;              ///< of a file of another format
  std::vector<std::string> held;                       ///< patterns of joints that do not move: "joint.finger_*"
  std::map<std::string, ActuatorKind> drive;           ///< pattern of actuators ("actuator.*") → what they take
  std::map<std::string, SourceLocation> robot_places;  ///< where its keys stand: "body.arm.mass"
  std::map<std::string, double> set;                   ///< address pattern → value, fixed
  std::vector<FreeRange> free;                         ///< of a target: what is hidden, drawn uniformly
  EffectList effects;
  ComponentChoice encoding = {"parameters", {}};  ///< of models, for the estimation phase
  bool approximate = false;                       ///< the start values are a model to begin with
};

/// When the hidden values of a simulated target are drawn again.
enum class Redraw { never, replicate };

/// A target that is simulated: a robot with a hidden truth.
struct SimulatedSource {
  ModelSection system;
  std::map<std::string, double> noise;  ///< sensor pattern (`sensor.angle*`) → standard deviation, the channel's unit
  std::uint64_t hidden_seed = 1;
  Redraw redraw = Redraw::never;
  int substeps = 0;  ///< of the engine, where the target is integrated in finer steps than models; 0: in the same
};

struct TargetSection {
  std::string kind = "recorded";  ///< plugin name
  RecordingSource recording;
  SimulatedSource simulated;
  ProcessSource process;
};

/// What tests are made of.
struct TestSection {
  ComponentChoice encoding = {"recurrent_network", {}};
  double duration = 10.0;            ///< s; the seed's 1000 steps of 10 ms
  std::vector<std::string> sensors;  ///< patterns: what a controller sees; none: all
};

/// One of the operators that make a child, in the order in which they are applied.
struct MutationEntry {
  ComponentChoice mutation;
  double chance = 1.0;  ///< that it is applied to a child
};

/// Who searches and how children are made; the defaults are the seed's.
struct SearchSection {
  ComponentChoice search = {"truncation", {}};
  std::vector<MutationEntry> mutation = {{{"one_point_crossover", {}}, 0.25}, {{"uniform_reset", {}}, 1.0}};
};

struct EstimationSection {
  SearchSection search;
  ComponentChoice metric = {"mean_absolute_difference", {}};
  std::string objective;  ///< objective metric; empty: none
  std::vector<std::string>
      sensors;          ///< patterns of the sensors on which models are scored; none: all that are measured
  int seeds = 0;        ///< how many of the last pass's best models start the next; the seed's experiment takes none
  int restarts = 1;     ///< independent searches in each phase
  bool rivals = false;  ///< each restart looks for another structure
  int ensemble = 10;    ///< how many models that differ are kept of each pass
  bool replay = false;  ///< drive models by the commands that the target received
  std::vector<double> horizons;       ///< s, of each trial, one a pass; the last for all that follow; none: all of it
  std::vector<std::string> profiled;  ///< patterns of delays that are found for each model instead of searched
  double challenge = 0.0;             ///< a trial this many times as surprising as usual is set aside; 0: none is
  int patience = 0;                   ///< passes without progress until the run stops; 0: it does not
  bool abandon = true;                ///< end an evaluation that cannot get under the generation's bar
  bool reuse = true;                  ///< simulate identical models once
};

/// A further fitness that counts beside the first.
struct MixEntry {
  ComponentChoice fitness;
  double weight = 1.0;
};

struct ExplorationSection {
  SearchSection search;
  ComponentChoice fitness = {"forward_distance", {}};
  std::vector<MixEntry> mix;
  std::optional<double> stop_below;  ///< fitness of the best test below which the run stops
};

/// How free values are found (fitting/).
struct FitSection {
  std::string method = "multiple_shooting";   ///< or "free_run"
  std::vector<double> segments = {0.1, 0.5};  ///< s, shorter ones first; each stage starts from the one before
  std::string horizon = "whole";  ///< last stage: "whole", "auto" (uncertainty of the start at most twice the floor),
                                  ///< or seconds such as "2.0"
  int starts = 4;                 ///< starting points, the first is the model's own
  std::string loss = "huber";     ///< or "squared"
  double loss_scale = 3.0;        ///< residuals beyond this many standard deviations count linearly
  int max_iterations = 50;
};

/// Declared disturbances (see fitting/floor/noise_floor.h).
struct NoiseSection {
  std::map<std::string, double>
      process;  ///< element pattern (`joint.hinge`) → standard deviation of an unmodelled random force, N·m or N
  double process_correlation_time = 0.0;  ///< s; 0: white from step to step
};

/// A key that `lacuna plan` varies, as `--set` names it, and the values that it is to have, each as TOML.
using SweptKey = std::pair<std::string, std::vector<std::string>>;

/// An experiment file, checked. `locations` tells where a key stands: "model.effects[0].where[1]".
struct Experiment {
  std::filesystem::path file;
  std::string text;                    ///< as read
  std::vector<std::string> overrides;  ///< `--set key=value`, as given
  std::vector<std::string> decided;    ///< what these leave open and the program decided, as `--set` would say it
  std::map<std::string, SourceLocation> locations;

  std::string name;
  std::uint64_t seed = 1;
  int passes = 20;
  int replicates = 1;
  TargetSection target;
  ModelSection model;
  EngineSettings engine;
  TestSection test;
  EstimationSection estimation;
  ExplorationSection exploration;
  FitSection fit;
  NoiseSection noise;
  std::vector<SweptKey> sweep;

  /// Units as written, by key, of numbers whose dimension only the model can judge: "model.set.body.arm.mass" → "g".
  /// The numbers themselves are SI already.
  std::map<std::string, std::string> written_units;

  /// Where `key` stands; for a key that the file does not have, the nearest table around it, else the file.
  SourceLocation where(const std::string& key) const;
  /// Adds a problem where the number at `key` was written with a unit of another dimension than `unit`.
  void check_unit(const std::string& key, const std::string& unit, ProblemList& problems) const;
};

}  // namespace lacuna
