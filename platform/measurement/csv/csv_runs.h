#pragma once

#include "measurement/csv/csv_format.h"

#include <string>
#include <vector>

namespace lacuna {

/// Programs for teaching write the runs of a session side by side into one file: "Time (s) Run #1", "Angle (rad) Run
/// #1", "Time (s) Run #2". Such a file has a table for each run, as files of other formats have tables; its columns are
/// those of the run, called without it ("Time (s)"), and those that no run is named in.

/// The runs that names speak of, in their order, as written: "Run #1".
std::vector<std::string> runs_in(const std::vector<std::string>& names);

/// A column as its run calls it: "Angle (rad)" for "Angle (rad) Run #2"; names that do not speak of the run as they
/// are.
std::string name_in_run(const std::string& name, const std::string& run);

/// Whether a column belongs to another run.
bool is_of_other_run(const std::string& name, const std::string& run);

/// The names of a run's table, a name for each column of the file; columns of other runs keep theirs.
std::vector<std::string> names_of_run(const std::vector<std::string>& names, const std::string& run);

}  // namespace lacuna
