#pragma once

#include "measurement/csv/csv_format.h"

#include <string>
#include <vector>

namespace lacuna {

/// Teaching programs write the runs of a session side by side into one file: "Time (s) Run #1", "Angle (rad) Run #1",
/// "Time (s) Run #2". Such a file has a table for each run, like files of other formats; its columns are those of the
/// run, with names without the run ("Time (s)"), and those without a run.

/// The runs in the names, in their order, as written: "Run #1".
std::vector<std::string> runs_in(const std::vector<std::string>& names);

/// A column's name within its run: "Angle (rad)" for "Angle (rad) Run #2"; other names unchanged.
std::string name_in_run(const std::string& name, const std::string& run);

/// Whether a column belongs to another run.
bool is_of_other_run(const std::string& name, const std::string& run);

/// The names of a run's table, one for each column of the file; columns of other runs keep theirs.
std::vector<std::string> names_of_run(const std::vector<std::string>& names, const std::string& run);

}  // namespace lacuna
