#pragma once

#include "plugin_checks/check_result.h"
#include "plugin_checks/exercise.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace lacuna {

/// Digests of components' numbers, by "kind name"; none for a component that cannot be exercised.
using TranscriptDigests = std::map<std::string, std::string>;

/// Asks a new process for the digests of a plugin, with other addresses and other static objects.
using OtherProcess = std::function<TranscriptDigests()>;

/// Checks a plugin library and each of its components, everything in child processes, which the plugin may end or
/// block; this process continues with the result. Call it before the process has threads.
PluginChecks check_plugin(const std::filesystem::path& file, const ExerciseInputs& inputs,
                          const OtherProcess& other_process);

/// The answer of the other process. Throws `Error` for a library that cannot be loaded.
TranscriptDigests transcript_digests(const std::filesystem::path& file, const ExerciseInputs& inputs);

}  // namespace lacuna
