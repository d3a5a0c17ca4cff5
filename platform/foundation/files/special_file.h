#pragma once

#include "foundation/processes/stop.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// The kind of a file that is neither regular nor a folder: "a pipe", "a socket", "a device", "a disk"; empty for
/// these, or where there is no file.
std::string special_file(const std::filesystem::path& file);

/// Whether it is a pipe without a name in a folder, such as /dev/stdin and a shell's <(command): its writer exists.
bool is_unnamed_pipe(const std::filesystem::path& file);

/// Why a file of that name cannot be read whole: "is a pipe, not a regular file", "no such file", ...; empty: it can.
/// Opening a pipe would wait for its writer, and a device may have no end.
std::string why_no_regular_file(const std::filesystem::path& file);

/// Opens a pipe for writing, whose reader may come within seconds. Below 0: `errno` says why not; ENXIO: no reader.
/// Throws `Interrupted` while it waits, when `stop` is due.
int open_pipe_to_reader(const std::filesystem::path& file, const Stop& stop);

}  // namespace lacuna
