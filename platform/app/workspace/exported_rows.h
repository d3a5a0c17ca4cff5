#pragma once

#include "foundation/files/whole_file.h"
#include "foundation/processes/stop.h"

#include <filesystem>
#include <optional>
#include <string>

namespace lacuna {

enum class RowFormat { csv, json, json_lines, npz, mcap };

/// The format that the ending of a file's name stands for; nothing where it is none of them.
std::optional<RowFormat> row_format_of(const std::filesystem::path& file);

/// What `lacuna export` was asked to write of a database.
struct RowsExport {
  std::filesystem::path database;
  std::string what;                  ///< a view, a table, a trial or its file, the number of a trace
  std::optional<int> revision = {};  ///< whose prediction of a trial is wanted; none: the newest one
  RowFormat format = RowFormat::csv;
  std::string to;  ///< the file; empty: standard output
  Existing existing = Existing::refused;
  bool quiet = false;
  Stop stop = {};
};

/// Writes it, row by row, into a file that is there whole or not at all. Throws `BadInput` where the database has
/// nothing of that name, listing what it has, where the file is there, and where a view is to be an MCAP file.
void export_rows(const RowsExport& wanted);

}  // namespace lacuna
