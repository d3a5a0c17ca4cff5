#include "app/terminal/child_watch.h"

#include "app/terminal/busy_clocks.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2};
constexpr long kBetweenLooks = 100'000'000;            // ns
constexpr std::chrono::milliseconds kPatience{1'700};  // after a wish to end
constexpr std::chrono::seconds kNoLook{1};             // this process was stopped, and the child may have been, too
constexpr std::chrono::seconds kLastActs{10};          // destructors and exit handlers, once the work is done
constexpr int kMostStops = 1;                          // by one component's calls

/// Whether a signal was sent by a process, and not by the terminal, which sends it to the child as well.
bool is_for_this_process_alone(const siginfo_t& signal) { return signal.si_code <= 0; }

/// Stops with the child, so that the shell sees a job that has stopped.
void stop_with(pid_t child) {
  raise(SIGSTOP);
  kill(child, SIGCONT);
}

/// What became of the child, if it has ended; whether it had stopped.
struct Change {
  std::optional<int> ended;
  bool stopped = false;
};

/// `may_stop`: whether this process stops with a child that the signal has stopped; else that goes on.
template <class MayStop>
Change change_of(pid_t child, MayStop&& may_stop) {
  Change change;
  for (;;) {
    int status = 0;
    const pid_t changed = waitpid(child, &status, WNOHANG | WUNTRACED);
    if (changed != child) {
      if (changed < 0 && errno != EINTR) change.ended = status;
      return change;
    }
    if (!WIFSTOPPED(status)) {
      change.ended = status;
      return change;
    }
    if (may_stop(WSTOPSIG(status)))
      stop_with(child);
    else
      kill(child, SIGCONT);
    change.stopped = true;
  }
}

/// Whether a debugger holds a process, in which nothing takes too long.
bool is_traced(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("TracerPid:")) return line.find_first_of("123456789") != std::string::npos;
  return false;
}

/// The call in which the child hangs; a plugin's call has priority.
std::optional<ActiveCall> held_by() {
  std::optional<ActiveCall> held;
  for (const BusyThread& thread : CallPage::busy()) {
    ActiveCall call = CallPage::call_of(*thread.slot);
    if (!held || !call.component.empty()) held = std::move(call);
  }
  return held;
}

/// One child from its beginning to its end.
class Watch {
 public:
  Watch(pid_t child, const sigset_t& signals) : child_(child), signals_(signals) {}

  WatchedEnd to_end() {
    for (;;) {
      const Clock::time_point now = Clock::now();
      was_away_ = now - looked_ > kNoLook;
      if (was_away_) restart_clocks();
      looked_ = now;
      const Change change = change_of(child_, [this](int signal) { return is_stop_of_user(signal); });
      if (change.stopped && end_.reason == EndedFor::nothing) restart_clocks();
      if (change.ended) {
        end_.status = *change.ended;
        return end_;
      }
      take_signal();
      if (end_.reason == EndedFor::nothing) judge();
    }
  }

 private:
  void restart_clocks() {
    clocks_.restart();
    calls_.restart();
  }

  /// Who stops the child from outside means this process too; one that a plugin's call has stopped goes on, and is
  /// ended where that stops it again.
  bool is_stop_of_user(int signal) {
    const std::vector<ActiveCall> calls = CallPage::active();
    if (signal != SIGSTOP || calls.empty()) return true;
    if (!was_away_ && ++stops_[calls.front().component] > kMostStops) end_child(EndedFor::stopped, calls.front());
    return false;
  }

  void take_signal() {
    siginfo_t signal{};
    const timespec pause{0, kBetweenLooks};
    const int number = sigtimedwait(&signals_, &signal, &pause);
    if (number == SIGCONT || (number > 0 && number != SIGCHLD && is_for_this_process_alone(signal)))
      kill(child_, number);
    if (is_wish(number) && !asked_) {
      asked_ = Clock::now();
      end_.asked = true;
    }
  }

  void judge() {
    if (CallPage::is_closed()) return judge_end();
    if (const auto slow = calls_.overdue()) return end_child(EndedFor::slow_call, slow->call, slow->limit);
    const double limit = CallPage::evaluation_limit();
    if (limit > 0.0)
      if (const CallSlot* slot = clocks_.overdue(limit))
        return end_child(EndedFor::overdue, CallPage::call_of(*slot), limit);
    if (!asked_ || Clock::now() - *asked_ < kPatience) return;
    if (const std::optional<ActiveCall> held = held_by()) end_child(EndedFor::unheeding, *held);
  }

  void judge_end() {
    if (!closed_) closed_ = Clock::now();
    if (Clock::now() - *closed_ < kLastActs) return;
    end_.reason = EndedFor::lingering;
    end_.limit = std::chrono::duration<double>(kLastActs).count();
    kill(child_, SIGKILL);
  }

  void end_child(EndedFor reason, ActiveCall call, double limit = 0.0) {
    if (CallPage::is_closed()) return;  // its work is done
    if (limit > 0.0 && is_traced(child_)) return restart_clocks();
    end_.reason = reason;
    end_.call = std::move(call);
    end_.limit = limit;
    kill(child_, SIGKILL);
  }

  pid_t child_;
  const sigset_t& signals_;
  WatchedEnd end_;
  EvaluationClocks clocks_;
  CallClocks calls_;
  std::map<std::string, int> stops_;  // by component
  bool was_away_ = false;             // this process was stopped as well
  std::optional<Clock::time_point> asked_;
  std::optional<Clock::time_point> closed_;  // since when its work is done
  Clock::time_point looked_ = Clock::now();
};

bool heeds_wishes = true;

bool is_ignored(int signal) {
  struct sigaction present {};
  return sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

/// Ctrl-C and SIGTERM end the work also where a shell began the program in the background.
bool is_awaited(int signal) {
  return signal == SIGINT || signal == SIGTERM ? heeds_wishes : heeds_wishes && !is_ignored(signal);
}

}  // namespace

bool is_wish(int signal) {
  return std::find(kEndingSignals.begin(), kEndingSignals.end(), signal) != kEndingSignals.end();
}

void ignore_wishes() {
  heeds_wishes = false;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
}

sigset_t awaited_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kEndingSignals)
    if (is_awaited(signal)) sigaddset(&signals, signal);
  for (const int signal : {SIGCHLD, SIGTSTP, SIGCONT}) sigaddset(&signals, signal);
  return signals;
}

WatchedEnd watch_child(pid_t child, const sigset_t& signals) { return Watch(child, signals).to_end(); }

}  // namespace lacuna
