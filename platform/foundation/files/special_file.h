#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// What a name leads to that is neither a regular file nor a folder: "a pipe", "a socket", "a device", "a disk"; empty
/// where it is one of these or nothing is there.
std::string special_file(const std::filesystem::path& file);

/// Whether it is a pipe without a name in a folder, as /dev/stdin and a shell's <(command) are: its writer is there.
bool is_unnamed_pipe(const std::filesystem::path& file);

/// Why nothing that is to be read whole can lie there: "is a pipe, not a regular file", "no such file", ...; empty: it
/// can. Opening a pipe would wait for whoever writes to it, and a device may have no end.
std::string why_no_regular_file(const std::filesystem::path& file);

/// Opens a pipe to write to, whose reader may come within seconds. Below 0: `errno` says why not; ENXIO: nobody reads.
/// Throws `Interrupted` while it waits.
int open_pipe_to_reader(const std::filesystem::path& file);

}  // namespace lacuna
