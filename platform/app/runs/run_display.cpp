#include "app/runs/run_display.h"

#include "foundation/text/unit_text.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lacuna {
namespace {

/// Share of a replicate's work that is done: in pass p a model costs p trials and a test one.
double share_done(const EeaProgress& progress) {
  const double passes = progress.passes, pass = std::max(progress.pass, 1);
  const double in_phase =
      progress.generations > 0 ? static_cast<double>(progress.generation) / progress.generations : 0;
  double work = pass * (pass - 1.0) / 2.0 + (pass - 1.0);
  if (progress.phase == Phase::estimation) work += pass * in_phase;
  if (progress.phase == Phase::exploration) work += pass + in_phase;
  if (progress.phase == Phase::finished) return 1.0;
  return std::min(1.0, work / (passes * (passes + 1.0) / 2.0 + passes));
}

std::string objective_text(const PassRow& pass) {
  std::string text;
  for (const ObjectiveRow& row : pass.objective)
    if (row.name.find('*') != std::string::npos)
      text += fmt::format(" · {} off by {:.3g} {}", row.name, row.value, unit_text(row.unit));
  return text;
}

}  // namespace

RunDisplay::RunDisplay(const std::vector<PlannedReplicate>& replicates, bool quiet, RunLines* lines, LinePacer& pacer)
    : live_(!quiet && isatty(STDERR_FILENO) == 1),
      lines_of_text_(!quiet && isatty(STDERR_FILENO) == 0),
      lines_(lines),
      pacer_(pacer) {
  for (const PlannedReplicate& planned : replicates) replicates_.emplace_back().planned = planned;
}

RunDisplay::~RunDisplay() {
  if (live_) wipe_live_line();
}

double RunDisplay::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void RunDisplay::show(std::size_t replicate, const EeaProgress& progress) {
  using namespace std::chrono_literals;
  const std::scoped_lock lock(telling_);
  Replicate& own = replicates_[replicate];
  take(own, progress);
  if (progress.generations == 0) return;
  const Clock::time_point now = Clock::now();
  if (live_ && now - last_print_ >= 100ms) {
    last_print_ = now;
    show_live_line(line_of(own, progress));
  }
  if (lines_of_text_ && pacer_.take(now)) fmt::print(stderr, "{}\n", line_of(own, progress));
  if (lines_ && now - own.last_line >= 1s) {
    own.last_line = now;
    const Standing all = standing();
    lines_->progress(own.planned, progress, all.rate, all.left);
  }
}

void RunDisplay::take(Replicate& own, const EeaProgress& progress) {
  own.done = share_done(progress);
  if (!own.known) {
    own.known = true;
    own.begun_at = own.done;
  }
  if (progress.generations == 0) return;
  if (own.counting) own.evaluations += progress.evaluations - std::min(own.in_pass, progress.evaluations);
  own.counting = true;  // of a pass that goes on, what is told first was partly evaluated before
  own.in_pass = progress.evaluations;
  own.invalid_in_pass = progress.invalid;
  std::uint64_t evaluations = 0;
  for (const Replicate& each : replicates_) evaluations += each.evaluations;
  rate_.note(seconds(), evaluations);
}

RunDisplay::Standing RunDisplay::standing() const {
  Standing all;
  double done = 0.0, begun_at = 0.0;
  for (const Replicate& each : replicates_) {
    done += each.done;
    begun_at += each.begun_at;
    all.invalid += each.invalid + each.invalid_in_pass;
  }
  const double share_rate = (done - begun_at) / seconds();
  all.rate = rate_.per_second();
  all.left = share_rate > 0.0 ? (static_cast<double>(replicates_.size()) - done) / share_rate : kNotKnown;
  return all;
}

std::string RunDisplay::whose(const Replicate& own) const {
  return replicates_.size() > 1 ? fmt::format("replicate {} · ", own.planned.replicate) : "";
}

std::string RunDisplay::line_of(const Replicate& own, const EeaProgress& progress) const {
  const Standing all = standing();
  return fmt::format("{}pass {}/{} · {} {}/{} · best {:.4g} · {} left · {:.0f} evaluations/s · {} invalid", whose(own),
                     progress.pass, progress.passes, to_string(progress.phase), progress.generation,
                     progress.generations, progress.best, std::isfinite(all.left) ? format_duration(all.left) : "?",
                     all.rate, all.invalid);
}

void RunDisplay::end_trial(std::size_t replicate, const TargetTrialRow& trial) {
  const std::scoped_lock lock(telling_);
  if (lines_) lines_->trial(replicates_[replicate].planned, trial);
}

void RunDisplay::end_pass(std::size_t replicate, const PassRow& pass) {
  const std::scoped_lock lock(telling_);
  Replicate& own = replicates_[replicate];
  own.invalid += own.invalid_in_pass;
  own.in_pass = own.invalid_in_pass = 0;
  if (lines_) lines_->pass(own.planned, pass);
  if (!lines_of_text_) return;
  fmt::print(stderr, "{}pass {} · error {:.4g}{} · {} evaluations, {} invalid · {}\n", whose(own), pass.number,
             pass.best_score, objective_text(pass), pass.evaluations + pass.test_evaluations,
             pass.invalid + pass.invalid_tests, format_duration(seconds()));
}

void RunDisplay::note(std::size_t replicate, const std::string& note) {
  const std::scoped_lock lock(telling_);
  if (lines_) lines_->note(replicates_[replicate].planned, note);
  if (live_) wipe_live_line();
  if (live_ || lines_of_text_) fmt::print(stderr, "{}{}\n", whose(replicates_[replicate]), note);
}

void RunDisplay::end_replicate(std::size_t replicate, const ReplicateEnd& end) {
  const std::scoped_lock lock(telling_);
  replicates_[replicate].done = 1.0;
  if (lines_) lines_->end(end);
}

}  // namespace lacuna
