#pragma once

#include "app/runs/replicate.h"
#include "eea/eea_run.h"

#include <nlohmann/json_fwd.hpp>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A run as JSON Lines, an object a line, each handed over as soon as it is known. Its member `event` says what it is:
/// `begin`, then for each replicate `trial`, `progress`, `pass` and `note`, and `end`. One thread at a time.
class RunLines {
 public:
  /// `to`: the option's value, "" for standard output; none: nothing is written. `goes_on`: behind the lines that
  /// a file has. Throws `Error` where it cannot be opened.
  RunLines(const std::optional<std::string>& to, bool goes_on);

  void begin(const std::string& experiment, int threads, const std::vector<PlannedReplicate>& replicates);
  void trial(const PlannedReplicate& replicate, const TargetTrialRow& trial);
  /// `rate`: evaluations per second of all replicates together; `left`: seconds until all are done, about.
  void progress(const PlannedReplicate& replicate, const EeaProgress& progress, double rate, double left);
  void pass(const PlannedReplicate& replicate, const PassRow& pass);
  void note(const PlannedReplicate& replicate, const std::string& note);
  void end(const ReplicateEnd& end);

  /// Throws `Error` where a line could not be written. The run itself does without them.
  void throw_if_failed() const;

 private:
  void write(const nlohmann::ordered_json& line);

  std::optional<std::string> to_;
  std::ofstream file_;
  bool failed_ = false;
};

}  // namespace lacuna
