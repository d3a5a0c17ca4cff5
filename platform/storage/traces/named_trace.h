#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What is stored of a trial's course in time, to be shown side by side.
struct NamedTrace {
  struct Part {
    std::string label;  ///< "measured", "predicted", "commanded", "centre of mass"
    TimeSeries series;
  };
  std::string experiment, trial;
  std::optional<int> revision = {};  ///< whose model predicted; none: no revision's did
  std::vector<Part> parts;           ///< what was measured comes first
};

/// Which one is wanted.
struct TraceQuestion {
  std::string name;                  ///< of a trial or of its file, or the number of a trace, `id` of the view `traces`
  std::optional<int> revision = {};  ///< whose prediction is wanted; none: the newest one
};

/// Names of the trials that have traces, in the order in which they were stored; no more than `most`.
std::vector<std::string> names_of_traces(const Database& database, std::size_t most);

/// The readings of a trial beside the newest prediction of them, or, by its number, one trace: a prediction with the
/// readings that it is of, anything else by itself. Nothing where the database has none of that name. Throws `BadInput`
/// where several trials have it, and where no model of the revision predicted the trial; `Error` where bytes are not
/// those that were written.
std::optional<NamedTrace> find_named_trace(const Database& database, const TraceQuestion& question);

}  // namespace lacuna
