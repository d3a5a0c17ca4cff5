#include "process/process_target.h"

#include "foundation/processes/stop.h"
#include "foundation/plugins/plugin_call.h"
#include "process/child_lines.h"
#include "process/conversation.h"
#include "process/json_message.h"
#include "process/quoted_text.h"

#include <lacuna/random_stream.h>

#include <fmt/format.h>

#include <array>
#include <utility>

namespace lacuna {
namespace {

std::string words_of(const std::vector<std::string>& command) {
  const std::string words = fmt::format("{}", fmt::join(command, " "));
  return quoted_text(words);
}

}  // namespace

ProcessTarget::ProcessTarget(ProcessTargetSetting setting)
    : setting_(std::move(setting)), program_(words_of(setting_.source.command)) {}

ProcessTarget::~ProcessTarget() = default;

/// Turns any failure into a sentence about the program and ends the program, because its next lines would be out of
/// step. A program that refuses a test with an error message continues.
template <class Call>
decltype(auto) ProcessTarget::guarded(const std::string& limit, Call&& call) {
  try {
    return std::forward<Call>(call)();
  } catch (const RefusedTest& refusal) {
    throw Error(program_ + " " + refusal.what());
  } catch (const TookTooLong& lateness) {
    fail(fmt::format("{} (the limit is {})", lateness.what(), limit));
  } catch (const BadInput&) {
    lines_.reset();
    throw;
  } catch (const Interrupted&) {
    lines_.reset();
    throw;
  } catch (const Error& error) {
    fail(error.what());
  } catch (...) {  // a controller's; the program waits for commands that never come
    lines_.reset();
    throw;
  }
}

const Hello& ProcessTarget::hello() {
  start();
  return hello_;
}

Trial ProcessTarget::carry_out(const Test& test) {
  const HostCall call;
  start();
  const std::string limit = fmt::format("target.trial_limit, {:.4g} s beyond the test's {:.4g} s",
                                        setting_.source.trial_limit, test.duration);
  return guarded(limit, [&] { return try_test(test); });
}

void ProcessTarget::fail(const std::string& what) {
  const std::string words = lines_ ? lines_->last_words() : "";
  lines_.reset();
  throw Error(program_ + " " + what + (words.empty() ? "" : "; its last lines on standard error:\n" + words));
}

void ProcessTarget::start() {
  if (lines_ && lines_->has_ended()) {
    if (setting_.note) setting_.note(program_ + " has ended since its last trial; it is started again");
    lines_.reset();
  }
  if (lines_) return;
  try {
    start_afresh();
  } catch (const BadInput& bad) {
    if (!was_fit_) throw;
    throw Error(program_ + " was started again and has changed: " + bad.what());
  }
  was_fit_ = true;
}

void ProcessTarget::start_afresh() {
  if (!setting_.source.refused.empty()) throw_problem(setting_.location, setting_.source.refused);
  try {
    lines_ = std::make_unique<ChildLines>(setting_.source, setting_.stop);
  } catch (const Error& error) {
    throw_problem(
        setting_.location,
        fmt::format("target.command: {}; name a program in PATH, or its path relative to target.folder", error.what()));
  }
  try {
    guarded(fmt::format("target.start_limit, {:.4g} s", setting_.source.start_limit), [&] { greet(); });
  } catch (const Error&) {
    lines_.reset();  // also where it refuses: it has not said what it is
    throw;
  }
}

void ProcessTarget::greet() {
  const auto until = ChildLines::in(setting_.source.start_limit);
  lines_->send(hello_message(), until);
  hello_ = read_hello(lines_->receive(until));
  ProblemList problems;
  for (const std::string& misfit : misfits(hello_, setting_.space)) problems.add(setting_.location, misfit);
  problems.throw_if_any();
}

Trial ProcessTarget::try_test(const Test& test) {
  if (const std::string line = lines_->unasked(); !line.empty())
    throw Error("sent an unexpected line, " + quoted_text(line) + "; answer each test once, before the next one");
  TestHeading heading;
  heading.id = ++sent_;
  heading.trial = number_;
  heading.seed = RandomStream(std::array<std::uint64_t, 2>{setting_.noise_seed, number_})() >> 11U;
  heading.duration = test.duration;
  heading.period = setting_.space.control_period;
  heading.periods = whole_periods(test.duration, heading.period);
  Conversation conversation(*lines_, hello_, setting_.space, heading,
                            ChildLines::in(test.duration + setting_.source.trial_limit));
  Trial trial = conversation.carry_out(test);
  trial.initial = initial_values(conversation.start(), setting_.coordinates);
  if (!trial.initial.empty()) begin_at_start(trial.measured);
  if (setting_.note)
    for (const std::string& note : conversation.notes()) setting_.note(note);
  return trial;
}

}  // namespace lacuna
