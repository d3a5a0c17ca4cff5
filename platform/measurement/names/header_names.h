#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// A column's name without uninformative parts.
struct CoreName {
  std::string text;  ///< "Time (s)" of "Time (s) Run #1" or of "Latest: Time (s)", "winkel" of "pendel/winkel"
  std::string run;   ///< number of the run in the name, as written: "Run #1"; empty: none
};

/// The name without the number of a run at its end or its beginning: "Time (s)" and "Run #1".
CoreName name_and_run(const std::string& name);

/// One for each name of a header: without the number of a run, and without words with which all of them begin or end. A
/// word is kept where a name would lose information. Names of times may differ.
std::vector<CoreName> core_names(const std::vector<std::string>& names);

}  // namespace lacuna
