#include "app/runs/run_lines.h"

#include "app/terminal/plain_streams.h"
#include "report/text/run_text.h"
#include "storage/core/names.h"

#include <lacuna/error.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

Json event(const char* name, const PlannedReplicate& replicate) {
  return {{"event", name}, {"run", replicate.run.value}, {"replicate", replicate.replicate}};
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

RunLines::RunLines(const std::optional<std::string>& to, bool goes_on) : to_(to) {
  if (!to_ || to_->empty()) return;
  file_.open(*to_, goes_on ? std::ios::binary | std::ios::app : std::ios::binary);
  if (!file_) throw Error(*to_ + ": cannot be written; check that its folder exists and is writable");
}

void RunLines::begin(const std::string& experiment, int threads, const std::vector<PlannedReplicate>& replicates) {
  Json runs = Json::array();
  for (const PlannedReplicate& each : replicates)
    runs.push_back({{"run", each.run.value}, {"replicate", each.replicate}, {"seed", each.seed}});
  write({{"event", "begin"}, {"experiment", experiment}, {"threads", threads}, {"runs", runs}});
}

void RunLines::trial(const PlannedReplicate& replicate, const TargetTrialRow& trial) {
  Json line = event("trial", replicate);
  line["trial"] = trial.number;
  line["test"] = trial.test ? Json(*trial.test) : Json(nullptr);
  line["for_transfer"] = trial.for_transfer;
  line["predicted_fitness"] = number(trial.predicted_fitness);
  line["measured_fitness"] = number(trial.measured_fitness);
  write(line);
}

void RunLines::progress(const PlannedReplicate& replicate, const EeaProgress& progress, double rate, double left) {
  Json line = event("progress", replicate);
  line["pass"] = progress.pass;
  line["passes"] = progress.passes;
  line["phase"] = to_string(progress.phase);
  line["generation"] = progress.generation;
  line["generations"] = progress.generations;
  line["best"] = number(progress.best);
  line["invalid"] = progress.invalid;
  line["evaluations_per_second"] = number(rate);
  line["seconds_left"] = number(left);
  write(line);
}

void RunLines::pass(const PlannedReplicate& replicate, const PassRow& pass) {
  Json line = event("pass", replicate);
  line.update(pass_json(pass));
  write(line);
}

void RunLines::note(const PlannedReplicate& replicate, const std::string& note) {
  Json line = event("note", replicate);
  line["note"] = note;
  write(line);
}

void RunLines::end(const ReplicateEnd& end) {
  Json line = event("end", end.planned);
  line["ending"] = to_string(end.ending);
  line["problem"] = end.problem;
  line["passes"] = end.passes.size();
  line["seconds"] = end.seconds;
  line["process_seconds"] = end.process_seconds;
  line["storage_seconds"] = end.storage_seconds;
  write(line);
}

void RunLines::throw_if_failed() const {
  if (!failed_) return;
  throw Error((to_->empty() ? "standard output" : *to_) +
              ": not all lines could be written; the database has every row of the run");
}

void RunLines::write(const Json& line) {
  if (!to_ || failed_) return;
  const std::string text = line.dump() + '\n';
  if (to_->empty())
    failed_ = !(exact_output() << text << std::flush);
  else
    failed_ = !(file_ << text) || !file_.flush();
}

}  // namespace lacuna
