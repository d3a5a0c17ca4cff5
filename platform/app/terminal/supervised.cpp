#include "app/terminal/supervised.h"

#include "foundation/child_program.h"
#include "foundation/plugin_call.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr int kEndedBadly = 1;
constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2};

sigset_t awaited_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kEndingSignals) sigaddset(&signals, signal);
  for (const int signal : {SIGCHLD, SIGTSTP, SIGCONT}) sigaddset(&signals, signal);
  return signals;
}

/// Whether a signal was sent by a process, and not by the terminal, which sends it to the child as well.
bool is_for_this_process_alone(const siginfo_t& signal) { return signal.si_code <= 0; }

/// Stops with the child, so that the shell sees a job that has stopped.
void stop_with(pid_t child) {
  raise(SIGSTOP);
  kill(child, SIGCONT);
}

/// What became of the child, if it has ended.
bool has_ended(pid_t child, int& status) {
  for (;;) {
    const pid_t changed = waitpid(child, &status, WNOHANG | WUNTRACED);
    if (changed != child) return changed < 0 && errno != EINTR;
    if (!WIFSTOPPED(status)) return true;
    stop_with(child);
  }
}

int wait_for_end(pid_t child, const sigset_t& signals) {
  int status = 0;
  while (!has_ended(child, status)) {
    siginfo_t signal{};
    const int number = sigwaitinfo(&signals, &signal);
    if (number == SIGCONT || (number > 0 && number != SIGCHLD && is_for_this_process_alone(signal)))
      kill(child, number);
  }
  return status;
}

/// Signals by which users and shells end a program: nobody is to blame.
bool is_wish(int signal) {
  return signal == SIGPIPE || std::find(kEndingSignals.begin(), kEndingSignals.end(), signal) != kEndingSignals.end();
}

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

constexpr const char* kPluginsFault = "; that is a fault of the plugin: repair it, or do without this component";
constexpr const char* kDatabaseIsSafe = "; what was committed to the database is kept";
constexpr const char* kKilledByOthers =
    "; another program ended it, as the system does where memory is used up (`dmesg` names it then)";

std::string of_nobody(const ChildEnding& ending) {
  const bool killed = WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGKILL;
  return fmt::format("lacuna: it {} before its work was done, in no call of a plugin{}{}", ending.phrase(),
                     killed ? kKilledByOthers
                            : "; that is a fault of the program, of a library, or of a thread that a plugin started: "
                              "please report the command",
                     kDatabaseIsSafe);
}

std::string of_plugins(const ChildEnding& ending, const std::vector<ActiveCall>& calls) {
  const bool killed = WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGKILL;
  if (calls.size() == 1 && !killed)
    return fmt::format("{}: {} {}{}{}", calls[0].component, calls[0].call, ending.deed(), kPluginsFault,
                       kDatabaseIsSafe);
  std::vector<std::string> names;
  for (const ActiveCall& call : calls) names.push_back(call.component + ": " + call.call);
  return fmt::format("{}: the program {} during {}{}{}", fmt::join(names, ", "), ending.phrase(),
                     calls.size() == 1 ? "this call" : "one of these calls", killed ? kKilledByOthers : kPluginsFault,
                     kDatabaseIsSafe);
}

int report_end(int status) {
  const ChildEnding ending{status};
  const std::vector<ActiveCall> calls = CallPage::active();
  fmt::print(stderr, "{}\n", calls.empty() ? of_nobody(ending) : of_plugins(ending, calls));
  return kEndedBadly;
}

/// After its work was done, a plugin's last acts may still end it another way.
int exit_code_of(int status) {
  if (WIFSIGNALED(status)) {
    fmt::print(stderr, "lacuna: it {} after its work was done, which is complete; a plugin's destructors do that\n",
               ChildEnding{status}.phrase());
    return kEndedBadly;
  }
  return std::max(WEXITSTATUS(status), CallPage::exit_code());
}

/// In the child.
int do_work(int argc, char** argv, int (*work)(int, char**), pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) return kEndedBadly;  // it ended before that
  CallPage::watch_this_process();
  const int code = work(argc, argv);
  CallPage::close(code);
  return code;
}

}  // namespace

int run_supervised(int argc, char** argv, int (*work)(int, char**)) {
  std::signal(SIGCHLD, SIG_DFL);
  CallPage::prepare();
  const pid_t parent = getpid();
  const sigset_t signals = awaited_signals();
  sigset_t mask;
  sigprocmask(SIG_BLOCK, &signals, &mask);
  const pid_t child = fork();
  if (child <= 0) sigprocmask(SIG_SETMASK, &mask, nullptr);
  if (child < 0) return work(argc, argv);  // rather without a supervisor than not at all
  if (child == 0) return do_work(argc, argv, work, parent);
  const int status = wait_for_end(child, signals);
  if (CallPage::is_closed()) return exit_code_of(status);
  if (WIFSIGNALED(status) && is_wish(WTERMSIG(status))) end_by(WTERMSIG(status), mask);
  return report_end(status);
}

}  // namespace lacuna
