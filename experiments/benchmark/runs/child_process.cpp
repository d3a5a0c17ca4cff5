#include "runs/child_process.h"

#include "foundation/processes/child_program.h"

#include <chrono>
#include <optional>

namespace hidden_effects {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPause = 0.01;  // s
constexpr double kGrace = 5.0;   // s, between asking a child to end and ending it

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

ChildOutcome run_child(const std::vector<std::string>& words, const std::filesystem::path& folder, double longest,
                       const std::function<bool()>& stop) {
  const lacuna::CapturedOutput output("output"), errors("errors");
  const Clock::time_point start = Clock::now();
  lacuna::ChildProgram child({.words = words,
                              .folder = std::filesystem::absolute(folder),
                              .environment = {},
                              .output = output.file(),
                              .errors = errors.file()});
  ChildOutcome outcome;
  std::optional<lacuna::ChildEnding> ending;
  while (!(ending = child.ended_within(kPause))) {
    outcome.timed_out = since(start) > longest;
    outcome.stopped = stop();
    if (outcome.timed_out || outcome.stopped) {
      ending = child.end(kGrace);
      break;
    }
  }
  outcome.code = ending->code();
  outcome.seconds = since(start);
  outcome.processor_seconds = ending->processor_seconds;
  outcome.output = output.end();
  outcome.errors = errors.end();
  return outcome;
}

}  // namespace hidden_effects
