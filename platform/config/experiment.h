#pragma once

#include <lacuna/effect_list.h>
#include <lacuna/engine_settings.h>
#include <lacuna/robot_spec.h>

#include "foundation/problem.h"
#include "foundation/recording_source.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A range of values by address pattern, as in `free = { "body.*.mass" = [1.0, 7.0] }`.
struct FreeRange {
  std::string pattern;
  double lower = 0.0;
  double upper = 0.0;
  std::optional<double> start;  ///< from `{ range = [l, u], start = s }`; else the robot's own value
};

struct TargetSection {
  std::string kind = "recorded";  ///< plugin name
  RecordingSource recording;
};

struct ModelSection {
  std::string robot;                         ///< plugin name
  std::map<std::string, double> parameters;  ///< of the robot plugin
  std::filesystem::path file;                ///< of a declared robot
  std::optional<RobotSpec> declared;         ///< its content
  std::map<std::string, double> set;         ///< address pattern → value, fixed
  std::vector<FreeRange> free;
  EffectList effects;
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

/// Declared disturbances (see fitting/noise_floor.h).
struct NoiseSection {
  std::map<std::string, double>
      process;  ///< element pattern (`joint.hinge`) → standard deviation of an unmodelled random force, N·m or N
  double process_correlation_time = 0.0;  ///< s; 0: white from step to step
};

/// An experiment file, checked. `locations` tells where a key stands: "model.effects[0].where[1]".
struct Experiment {
  std::filesystem::path file;
  std::string text;                    ///< as read
  std::vector<std::string> overrides;  ///< `--set key=value`, as given
  std::map<std::string, SourceLocation> locations;

  std::string name;
  std::uint64_t seed = 1;
  TargetSection target;
  ModelSection model;
  EngineSettings engine;
  FitSection fit;
  NoiseSection noise;

  /// Units as written, by key, of numbers whose dimension only the model can judge: "model.set.body.arm.mass" → "g".
  /// The numbers themselves are SI already.
  std::map<std::string, std::string> written_units;

  /// Where `key` stands; for a key that the file does not have, the nearest table around it, else the file.
  SourceLocation where(const std::string& key) const;
  /// Adds a problem where the number at `key` was written with a unit of another dimension than `unit`.
  void check_unit(const std::string& key, const std::string& unit, ProblemList& problems) const;
};

}  // namespace lacuna
