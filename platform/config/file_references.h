#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// The references that are made from the declarations of keys: "experiment.md",
/// "experiment.schema.json", "robot.md", "robot.schema.json", as they stand in schema/.
std::vector<std::string> file_reference_names();

/// The text of one of them. Throws `Error` for another name.
std::string file_reference(const std::string& name);

}  // namespace lacuna
