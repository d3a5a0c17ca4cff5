#include "measurement/csv/csv_runs.h"

#include "measurement/names/header_names.h"

#include <algorithm>

namespace lacuna {

std::vector<std::string> runs_in(const std::vector<std::string>& names) {
  std::vector<std::string> runs;
  for (const std::string& name : names)
    if (const std::string run = name_and_run(name).run; !run.empty() && std::ranges::find(runs, run) == runs.end())
      runs.push_back(run);
  return runs;
}

std::string name_in_run(const std::string& name, const std::string& run) {
  const CoreName core = name_and_run(name);
  return core.run == run ? core.text : name;
}

bool is_of_other_run(const std::string& name, const std::string& run) {
  const std::string own = name_and_run(name).run;
  return !own.empty() && own != run;
}

std::vector<std::string> names_of_run(const std::vector<std::string>& names, const std::string& run) {
  std::vector<std::string> of_run;
  for (const std::string& name : names) of_run.push_back(name_in_run(name, run));
  return of_run;
}

}  // namespace lacuna
