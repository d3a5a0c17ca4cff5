#include "app/terminal/child_watch.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <unordered_map>
#include <vector>

namespace lacuna {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2};
constexpr long kBetweenLooks = 100'000'000;            // ns
constexpr std::chrono::milliseconds kPatience{1'700};  // after a wish to end
constexpr std::chrono::seconds kNoLook{1};             // this process was stopped, and the child may have been, too

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

Change change_of(pid_t child) {
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
    stop_with(child);
    change.stopped = true;
  }
}

/// How long each thread has been in the same evaluation without beginning or ending another one.
class EvaluationClocks {
 public:
  /// An evaluation that takes longer than `limit` s.
  const CallSlot* overdue(double limit) {
    const Clock::time_point now = Clock::now();
    const CallSlot* found = nullptr;
    std::unordered_map<const CallSlot*, Look> looks;
    for (const BusyThread& thread : CallPage::busy()) {
      if (!thread.evaluates) continue;
      const auto before = looks_.find(thread.slot);
      const bool same = before != looks_.end() && before->second.ticks == thread.ticks;
      const Look look{thread.ticks, same ? before->second.since : now};
      if (std::chrono::duration<double>(now - look.since).count() > limit) found = thread.slot;
      looks.emplace(thread.slot, look);
    }
    looks_ = std::move(looks);
    return found;
  }
  /// Time in which nothing could be evaluated does not count.
  void restart() { looks_.clear(); }

 private:
  struct Look {
    std::uint32_t ticks = 0;
    Clock::time_point since;
  };
  std::unordered_map<const CallSlot*, Look> looks_;
};

/// What the child is in that does not end: a plugin's call first of all.
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
      if (now - looked_ > kNoLook) clocks_.restart();
      looked_ = now;
      const Change change = change_of(child_);
      if (change.stopped) clocks_.restart();
      if (change.ended) {
        end_.status = *change.ended;
        return end_;
      }
      take_signal();
      if (end_.reason == EndedFor::nothing) judge();
    }
  }

 private:
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
    const double limit = CallPage::evaluation_limit();
    if (limit > 0.0)
      if (const CallSlot* slot = clocks_.overdue(limit)) return end_child(EndedFor::overdue, CallPage::call_of(*slot));
    if (!asked_ || Clock::now() - *asked_ < kPatience) return;
    if (const std::optional<ActiveCall> held = held_by()) end_child(EndedFor::unheeding, *held);
  }

  void end_child(EndedFor reason, ActiveCall call) {
    if (CallPage::is_closed()) return;  // its work is done
    end_.reason = reason;
    end_.call = std::move(call);
    kill(child_, SIGKILL);
  }

  pid_t child_;
  const sigset_t& signals_;
  WatchedEnd end_;
  EvaluationClocks clocks_;
  std::optional<Clock::time_point> asked_;
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
