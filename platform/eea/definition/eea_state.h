#pragma once

#include <lacuna/genome.h>
#include <lacuna/model_encoding.h>
#include <lacuna/trial.h>

#include "storage/eea/eea_records.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// What comes next.
enum class Phase { trial, estimation, exploration, transfer, finished };
const char* to_string(Phase phase);

/// A model from an estimation phase.
struct KnownModel {
  std::uint64_t number = 0;
  Genome genome;
  ModelProposal model;
  double score = 0.0;
  int restart = 0;  ///< of the estimation phase that found it
};

/// A test to be carried out.
struct PendingTest {
  std::uint64_t number = 0;
  Genome genome;
  double predicted_fitness = kNotKnown;
};

/// A test carried out on the target. For a recorded target: a measured trial, without a genome.
struct TargetTrial {
  std::uint64_t test = 0;
  Test drive;
  Trial trial;
  Genome genome = {};                    ///< of the test; empty: of a recorded target
  std::optional<int> set_aside_in = {};  ///< the pass in which it was found too hard (challenge.h); none: it counts
};

/// The complete state of the algorithm between two generations: continuing from it gives the same digits as an
/// uninterrupted run.
struct EeaState {
  int pass = 1;
  Phase phase = Phase::trial;
  std::uint64_t models = 0, tests = 0;  ///< numbered so far
  std::optional<PendingTest> next_test;
  std::vector<TargetTrial> trials;
  std::vector<KnownModel> best;       ///< of the last estimation phase, best first
  std::vector<double> search;         ///< of the current phase; empty: it has not begun
  std::uint64_t search_begin = 0;     ///< number of the first individual of that search
  int restart = 0;                    ///< of the current estimation phase
  std::vector<KnownModel> found;      ///< found by its earlier restarts
  double least_surprise = kNotKnown;  ///< smallest score so far of a best model on a trial that was new to it
  int passes_without_progress = 0;    ///< passes since it became smaller
  PassRow counts;                     ///< of the current pass so far
  std::vector<ModelRow> evaluated;    ///< models of the current pass, where a run continues within it
};

/// Everything but `trials` and `evaluated`, which are stored as rows of the database, and the models' robots, which
/// follow from their genomes.
std::vector<double> save(const EeaState& state);
/// The inverse. Throws `Error` for numbers that are not a saved state.
EeaState load_state(std::span<const double> saved);

}  // namespace lacuna
