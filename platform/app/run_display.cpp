#include "app/run_display.h"

#include "app/progress_line.h"

#include <fmt/format.h>

#include <unistd.h>

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

const char* name_of(Phase phase) {
  switch (phase) {
    case Phase::trial: return "trial";
    case Phase::estimation: return "estimation";
    case Phase::exploration: return "exploration";
    case Phase::transfer: return "transfer";
    case Phase::finished: return "done";
  }
  return "";
}

std::string objective_text(const PassRow& pass) {
  std::string text;
  for (const ObjectiveRow& row : pass.objective)
    if (row.name.find('*') != std::string::npos)
      text += fmt::format(" · {} off by {:.3g} {}", row.name, row.value, row.unit);
  return text;
}

}  // namespace

RunDisplay::RunDisplay(int replicates, bool quiet)
    : live_(!quiet && isatty(STDERR_FILENO) == 1),
      lines_(!quiet && isatty(STDERR_FILENO) == 0),
      replicates_(static_cast<std::size_t>(replicates)) {}

RunDisplay::~RunDisplay() {
  if (live_) std::fputs("\r\033[K", stderr);
}

double RunDisplay::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void RunDisplay::show(int replicate, const EeaProgress& progress) {
  using namespace std::chrono_literals;
  const std::scoped_lock lock(printing_);
  Replicate& own = replicates_[static_cast<std::size_t>(replicate)];
  own.done = share_done(progress);
  if (!own.known) {
    own.known = true;
    own.begun_at = own.done;
    own.in_pass_before = progress.evaluations;
  }
  if (progress.generations > 0) {
    own.in_pass = progress.evaluations - std::min(own.in_pass_before, progress.evaluations);
    own.invalid_in_pass = progress.invalid;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!live_ || progress.generations == 0 || now - last_ < 100ms) return;
  last_ = now;
  print(replicate, progress);
}

void RunDisplay::print(int replicate, const EeaProgress& progress) {
  double done = 0.0, begun_at = 0.0;
  std::uint64_t evaluations = 0, invalid = 0;
  for (const Replicate& each : replicates_) {
    done += each.done;
    begun_at += each.begun_at;
    evaluations += each.evaluations + each.in_pass;
    invalid += each.invalid + each.invalid_in_pass;
  }
  const double rate = (done - begun_at) / seconds();
  const double left = rate > 0.0 ? (static_cast<double>(replicates_.size()) - done) / rate : 0.0;
  const std::string whose =
      replicates_.size() > 1 ? fmt::format("replicate {} of {} · ", replicate + 1, replicates_.size()) : "";
  fmt::print(stderr, "\r\033[K{}pass {}/{} · {} {}/{} · best {:.4g} · {:.0f} evaluations/s · {} invalid · {} left",
             whose, progress.pass, progress.passes, name_of(progress.phase), progress.generation, progress.generations,
             progress.best, static_cast<double>(evaluations) / seconds(), invalid, format_duration(left));
  std::fflush(stderr);
}

void RunDisplay::end_pass(int replicate, const PassRow& pass) {
  const std::scoped_lock lock(printing_);
  Replicate& own = replicates_[static_cast<std::size_t>(replicate)];
  own.evaluations += own.in_pass;
  own.invalid += own.invalid_in_pass;
  own.in_pass = own.in_pass_before = own.invalid_in_pass = 0;
  if (!lines_) return;
  const std::string whose = replicates_.size() > 1 ? fmt::format("replicate {} · ", replicate + 1) : "";
  fmt::print(stderr, "{}pass {} · error {:.4g}{} · {} evaluations, {} invalid · {}\n", whose, pass.number,
             pass.best_score, objective_text(pass), pass.evaluations + pass.test_evaluations,
             pass.invalid + pass.invalid_tests, format_duration(seconds()));
}

void RunDisplay::end_replicate(int replicate) {
  const std::scoped_lock lock(printing_);
  replicates_[static_cast<std::size_t>(replicate)].done = 1.0;
}

}  // namespace lacuna
