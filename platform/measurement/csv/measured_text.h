#pragma once

#include "measurement/csv/file_report.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// Message for a file of another format than CSV without any data.
inline constexpr const char* kNoNumbers =
    "has no numbers: its arrays are empty or contain text; export the recording again, with one column of times and "
    "one column per reading";

/// Why there is no readable file of that name with random access, half a sentence; empty: there is one, or a
/// folder of such files that is one recording (foundation/recording_folder.h).
std::string why_no_file(const std::filesystem::path& path);

/// Reads a text file as UTF-8 with lines that end in \n or \r\n (line ends \r of old Macintosh programs become \n, with
/// a note; a byte order mark is removed). Anything else becomes a problem that says what it is and what to do: a
/// folder, a file without permission, an empty one, UTF-16, a spreadsheet, a MATLAB or other binary file. Then the
/// result is empty.
std::string read_measured_text(const std::filesystem::path& path, FileReport& report);

}  // namespace lacuna
