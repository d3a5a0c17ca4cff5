#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// A column's name without what tells nothing of the column.
struct CoreName {
  std::string text;  ///< "Time (s)" of "Time (s) Run #1" or of "Latest: Time (s)", "winkel" of "pendel/winkel"
  std::string run;   ///< what numbers the run in the name, as written: "Run #1"; empty: nothing does
};

/// The name without the number of a run at its end or its beginning: "Time (s)" and "Run #1".
CoreName name_and_run(const std::string& name);

/// One for each name of a header: without the number of a run, and without words that all of them begin or end with. A
/// word is kept where a name says less without it. Times, which often have names of their own, need not share the
/// words.
std::vector<CoreName> core_names(const std::vector<std::string>& names);

}  // namespace lacuna
