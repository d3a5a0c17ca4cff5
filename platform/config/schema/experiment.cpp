#include "config/schema/experiment.h"

#include "config/toml/locations.h"
#include "foundation/unit.h"

namespace lacuna {

SourceLocation Experiment::where(const std::string& key) const {
  return nearest_location(locations, key, file.string());
}

void Experiment::check_unit(const std::string& key, const std::string& unit, ProblemList& problems) const {
  const auto written = written_units.find(key);
  if (written == written_units.end()) return;
  const std::optional<Unit> has = parse_unit(written->second);
  const std::optional<Unit> wanted = parse_unit(unit);
  if (!has || !wanted || has->same_dimension(*wanted)) return;
  problems.add(where(key), key + ": is in " + written->second + ", but must be in " + unit + " or a multiple of it");
}

}  // namespace lacuna
