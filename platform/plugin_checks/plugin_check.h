#pragma once

#include "plugin_checks/check_result.h"
#include "plugin_checks/exercise.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace lacuna {

/// Digests of what components give, by "kind name"; of one that cannot be exercised there is none.
using TranscriptDigests = std::map<std::string, std::string>;

/// Asks a process that was begun anew for the digests of a plugin, at other addresses and with other static objects.
using OtherProcess = std::function<TranscriptDigests()>;

/// Checks a plugin library and each of its components: everything in child processes, which it may end or let wait;
/// what a component does there is told, and this process goes on. Before the process has threads.
PluginChecks check_plugin(const std::filesystem::path& file, const ExerciseInputs& inputs,
                          const OtherProcess& other_process);

/// What the other process answers with. Throws `Error` for a library that cannot be loaded.
TranscriptDigests transcript_digests(const std::filesystem::path& file, const ExerciseInputs& inputs);

}  // namespace lacuna
