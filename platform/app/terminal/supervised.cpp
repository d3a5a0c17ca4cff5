#include "app/terminal/supervised.h"

#include "app/terminal/child_watch.h"
#include "app/terminal/left_running.h"
#include "foundation/processes/child_program.h"
#include "foundation/processes/memory_limit.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/plugins/plugin_libraries.h"
#include "foundation/processes/process_limits.h"
#include "foundation/processes/processes.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr int kEndedBadly = 1;
constexpr int kToRunAgain = 75;
constexpr double kGrace = 0.2;  // s, for what a child has left running

/// Ends as the child did.
void end_by(int signal, const sigset_t& mask) {
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  raise(signal);
  sigprocmask(SIG_UNBLOCK, &only, nullptr);
}

constexpr const char* kPluginsFault = "; this is a fault of the plugin: repair it, or leave out this component";
constexpr const char* kDatabaseIsSafe = "; the database keeps all committed results";
constexpr const char* kKilledByOthers =
    "; another program killed it, or the system did because memory ran out (see `dmesg`)";

/// Why it was killed, as far as one can tell.
std::string killer() {
  const std::string used_up = used_up_processor_time();
  return used_up.empty() ? kKilledByOthers : "; " + used_up;
}

bool was_killed(const WatchedEnd& end) { return WIFSIGNALED(end.status) && WTERMSIG(end.status) == SIGKILL; }

std::string name_of(const ActiveCall& call) { return call.component + ": " + call.call; }

ChildLoss by_overdue(const ActiveCall& call) {
  const std::string fact =
      fmt::format("an evaluation took longer than the limit, {:g} s", CallPage::evaluation_limit());
  constexpr const char* kRaise = "if the model needs more time, raise --evaluation-limit";
  if (call.component.empty())
    return {"", fact, fmt::format("lacuna: {}, and was ended; {}{}", fact, kRaise, kDatabaseIsSafe), true};
  const std::string deed = fmt::format("{}: {}", name_of(call), fact);
  return {call.component, deed,
          fmt::format("{}, and was ended; repair the plugin, leave out this component, or, {}{}", deed, kRaise,
                      kDatabaseIsSafe),
          true};
}

ChildLoss by_unheeding(const ActiveCall& call) {
  const std::string what = call.component.empty() ? "a simulation" : name_of(call);
  const std::string deed = fmt::format("interrupted; {} did not return within two seconds and was ended", what);
  return {"", deed, deed + kDatabaseIsSafe, false, true};
}

/// The signal of a user or a closed pipe that ended the child; 0: it ended otherwise.
int signal_of_others(const WatchedEnd& end) {
  const int signal = WIFSIGNALED(end.status) ? WTERMSIG(end.status) : 0;
  return signal == SIGPIPE || signal == SIGXCPU || is_wish(signal) ? signal : 0;
}

ChildLoss by_signal_of_others(int signal) {
  const std::string deed = fmt::format("interrupted by signal {} ({})", signal, strsignal(signal));
  return {"", deed, fmt::format("lacuna: {}{}", deed, kDatabaseIsSafe), false, true};
}

ChildLoss by_slow_call(const ActiveCall& call, double limit) {
  const std::string deed = fmt::format("{} took longer than the limit, {:g} s", name_of(call), limit);
  return {call.component, deed,
          fmt::format("{}, and was ended; repair the plugin, leave out this component, or, if it needs that long, "
                      "raise --evaluation-limit{}",
                      deed, kDatabaseIsSafe),
          true};
}

ChildLoss by_stopped(const ActiveCall& call) {
  const std::string deed = fmt::format("{} stopped the program by signal 19 (SIGSTOP)", name_of(call));
  return {call.component, deed, fmt::format("{}{}{}", deed, kPluginsFault, kDatabaseIsSafe), true};
}

constexpr const char* kOutsideOfCalls =
    "outside of all calls, for example in a thread that it started or in a destructor";

/// A component's name ends in its file.
bool is_of(const std::string& library, const ActiveCall& call) {
  return call.component.find("(" + library + ")") != std::string::npos;
}

/// "; plugins loaded from elsewhere than the program: a.so, b.so"; empty: there are none.
std::string suspects() {
  const std::vector<std::string> files = PluginLibraries::of_others();
  return files.empty() ? ""
                       : fmt::format("; plugins in use that did not come with the program: {}", fmt::join(files, ", "));
}

ChildLoss by_library(const WatchedEnd& end, const std::string& file) {
  const std::string deed = fmt::format("{}: its code {} {}", file, ChildEnding{end.status}.deed(), kOutsideOfCalls);
  return {file, deed, fmt::format("{}{}{}", deed, kPluginsFault, kDatabaseIsSafe), true};
}

ChildLoss by_nobody(const WatchedEnd& end) {
  const std::string deed =
      fmt::format("the process {} before its work was done, outside of plugin calls", ChildEnding{end.status}.phrase());
  if (was_killed(end)) return {"", deed, fmt::format("lacuna: {}{}{}", deed, killer(), kDatabaseIsSafe)};
  const std::string others = suspects();
  const std::string memory = crash_for_want_of_memory();
  const char* const whose = others.empty() ? "this is a fault of the program or of a library; please report the command"
                                           : "this is a fault of the program, of a library, or of a thread that a "
                                             "plugin started; leave out these plugins, or please report the command";
  return {"", deed,
          fmt::format("lacuna: {}{}; {}{}{}", deed, others, memory, memory.empty() ? "" : "; if that does not help, ",
                      whose) +
              kDatabaseIsSafe};
}

ChildLoss by_plugins(const WatchedEnd& end, const std::vector<ActiveCall>& calls) {
  const ChildEnding ending{end.status};
  if (calls.size() == 1 && !was_killed(end)) {
    const std::string deed = fmt::format("{} {}", name_of(calls[0]), ending.deed());
    return {calls[0].component, deed, fmt::format("{}{}{}", deed, kPluginsFault, kDatabaseIsSafe), true};
  }
  std::vector<std::string> names;
  for (const ActiveCall& call : calls) names.push_back(name_of(call));
  const std::string deed = fmt::format("{}: the program {} during {}", fmt::join(names, ", "), ending.phrase(),
                                       calls.size() == 1 ? "this call" : "one of these calls");
  return {"", deed, fmt::format("{}{}{}", deed, was_killed(end) ? killer() : kPluginsFault, kDatabaseIsSafe)};
}

ChildLoss loss_of(const WatchedEnd& end) {
  if (end.reason == EndedFor::overdue) return by_overdue(*end.call);
  if (end.reason == EndedFor::slow_call) return by_slow_call(*end.call, end.limit);
  if (end.reason == EndedFor::stopped) return by_stopped(*end.call);
  if (end.reason == EndedFor::unheeding) return by_unheeding(*end.call);
  if (const int signal = signal_of_others(end)) return by_signal_of_others(signal);
  std::vector<ActiveCall> calls = CallPage::active();
  if (const std::string library = PluginLibraries::culprit(); !library.empty()) {
    std::erase_if(calls, [&](const ActiveCall& call) { return !is_of(library, call); });
    if (calls.empty()) return by_library(end, library);
  }
  return calls.empty() ? by_nobody(end) : by_plugins(end, calls);
}

/// Whether the work starts again without the component that ended it; the next child is told of it.
bool begins_anew(const WatchedEnd& end, const ChildLoss& loss) {
  if (end.asked || loss.component.empty() || !CallPage::allows_new_beginning() || CallPage::refusal_of(loss.component))
    return false;
  CallPage::refuse({loss.component, loss.deed + kPluginsFault});
  fmt::print(stderr, "{}; the command starts again without it\n", loss.deed);
  return true;
}

/// After its work was done, a plugin's last acts may still end it another way.
int exit_code_of(const WatchedEnd& end) {
  const bool was_signalled = WIFSIGNALED(end.status);
  if (!was_signalled && WEXITSTATUS(end.status) == CallPage::exit_code()) return CallPage::exit_code();
  const std::string library = PluginLibraries::culprit();
  const std::string who = library.empty() ? "a destructor or an exit handler of a plugin" : library;
  const std::string what = end.reason == EndedFor::lingering
                               ? fmt::format("did not end within {:g} s, and was ended,", end.limit)
                               : ChildEnding{end.status}.phrase();
  tell(fmt::format("lacuna: the process {} after its work was complete; no result is lost. Caused by {}{}", what, who,
                   library.empty() ? suspects() : ""));
  return was_signalled ? kEndedBadly : std::max(WEXITSTATUS(end.status), CallPage::exit_code());
}

/// Memory that a child shares with its supervisor. The size is written last.
struct LeftPage {
  std::atomic<std::size_t> size = 0;
  std::array<char, 16384> bytes{};
};
LeftPage* left_page = nullptr;

/// A new one for each child. Where there is none, nothing can be left.
void prepare_left_page() {
  if (left_page == nullptr) {
    void* const memory = mmap(nullptr, sizeof(LeftPage), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    left_page = new (memory) LeftPage;
  }
  left_page->size = 0;
}

std::string left_by_child() {
  return left_page == nullptr ? "" : std::string(left_page->bytes.data(), left_page->size);
}

/// In the child.
int do_work(int argc, char** argv, int (*work)(int, char**), pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) return kEndedBadly;  // it ended before that
  limit_memory(usable_memory());
  CallPage::watch_this_process();
  const int code = work(argc, argv);
  CallPage::close(code);
  return code;
}

}  // namespace

void leave_to_supervisor(const std::string& left) {
  if (left_page == nullptr) return;
  if (left.size() > left_page->bytes.size()) throw Error("the names of the task's folders are too long");
  std::copy(left.begin(), left.end(), left_page->bytes.begin());
  left_page->size = left.size();
}

void tell(const std::string& line) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  std::fputs((line + "\n").c_str(), stderr);
  std::signal(SIGPIPE, before);
}

void print_loss(const ChildLoss& loss) {
  if (!loss.begins_anew) tell(loss.sentence);
}

int run_supervised(int argc, char** argv, int (*work)(int, char**), void (*report)(const ChildLoss&)) {
  std::signal(SIGCHLD, SIG_DFL);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const LeftRunning left_running;
  const sigset_t signals = awaited_signals();
  sigset_t mask;
  sigprocmask(SIG_BLOCK, &signals, &mask);
  for (;;) {
    CallPage::prepare();
    PluginLibraries::prepare();
    prepare_left_page();
    const pid_t parent = getpid(), child = fork();
    if (child <= 0) sigprocmask(SIG_SETMASK, &mask, nullptr);
    if (child < 0) return work(argc, argv);  // rather without a supervisor than not at all
    if (child == 0) return do_work(argc, argv, work, parent);
    const WatchedEnd end = watch_child(child, signals);
    if (CallPage::is_closed()) {
      left_running.end();
      return exit_code_of(end);
    }
    end_descendants(kGrace);
    ChildLoss loss = loss_of(end);
    loss.left = left_by_child();
    loss.begins_anew = begins_anew(end, loss);
    const int signal = signal_of_others(end);
    if (signal == 0 || !loss.left.empty()) report(loss);
    if (signal != 0) end_by(signal, mask);
    if (loss.begins_anew) continue;
    return end.reason == EndedFor::unheeding ? kToRunAgain : kEndedBadly;
  }
}

}  // namespace lacuna
