#pragma once

#include "app/runs/open_eea_run.h"
#include "storage/eea/eea_store.h"
#include "storage/results/stored_run.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A run of a database with the experiment that it was started from, ready to be simulated again.
struct OpenStoredRun {
  StoredRun run;
  EeaRunListing listing;
  std::unique_ptr<OpenEeaRun> opened;
  std::vector<std::string> doubts;  ///< sentences: files that have changed since, which may change digits
};

/// The run of that number, or the only one there is. Throws `BadInput` where there is no such run or several.
EeaRunListing choose_run(const Database& database, std::optional<std::int64_t> number);

/// Reads the experiment from the database, not from the file, which may have changed since. What it names is looked for
/// where `options.experiment` lies, or, if that is empty, where the run's file lay; `options.overrides` are put over
/// the run's. A program that is the target is named by the database alone, so it cannot be started, whoever asks for a
/// trial, unless the user trusts it.
enum class StoredProgram { refused, trusted };
OpenStoredRun open_stored(const Database& database, const EeaRunListing& run, CommonOptions options,
                          StoredProgram program = StoredProgram::refused);
OpenStoredRun open_stored(const Database& database, const EeaRunListing& run,
                          const std::vector<std::filesystem::path>& plugin_paths,
                          StoredProgram program = StoredProgram::refused);

/// The program that is the target of an experiment, as a line that a shell takes, which shows every character: with its
/// folder and its variables. Empty: the target is no program.
std::string program_line(const Experiment& experiment);

}  // namespace lacuna
