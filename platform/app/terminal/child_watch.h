#pragma once

#include "foundation/plugins/plugin_call.h"

#include <sys/types.h>

#include <csignal>
#include <optional>

namespace lacuna {

/// Why a process was ended by the one that watches it.
enum class EndedFor {
  nothing,    ///< it was not
  overdue,    ///< an evaluation took longer than it may
  slow_call,  ///< a call of a plugin took longer than it may
  stopped,    ///< a call of a plugin stopped the process, again and again
  unheeding,  ///< it was asked to end, and a plugin did not return
  lingering,  ///< its work was done, and it did not end
};

/// How a watched process ended.
struct WatchedEnd {
  int status = 0;  ///< as `wait` tells it
  EndedFor reason = EndedFor::nothing;
  bool asked = false;              ///< somebody has asked it to end
  std::optional<ActiveCall> call;  ///< in which it was found where it was ended; empty texts: in none of a plugin
  double limit = 0.0;              ///< s, that it went beyond; 0: there was none
};

/// Signals with which users and shells end a program.
bool is_wish(int signal);

/// From now on this process, and those that it forks, ignore wishes to end: whoever began them ends them.
void ignore_wishes();

/// All signals that `watch_child` waits for, which are to be blocked before the child is forked: not those that this
/// process was told to ignore, as `nohup` does.
sigset_t awaited_signals();

/// Waits for the end of a child that calls plugins (foundation/plugins/plugin_call.h). Passes on signals that ask to
/// end or to stop, unless the terminal sent them to the child as well. Ends the child when
/// - an evaluation takes longer than `CallPage::evaluation_limit`;
/// - a call of a plugin outside of evaluations takes as long, 10 s at least: 10 s where it only tells what a component
///   is; longer by what it was allowed (`CallAllowance`);
/// - a call of a plugin stops it (SIGSTOP) a second time;
/// - a plugin or an evaluation goes on for 1.7 s after a wish to end; what is no plugin's, such as a rig that is
/// brought
///   to rest, may take its time;
/// - it has not ended 10 s after its work was done.
WatchedEnd watch_child(pid_t child, const sigset_t& signals);

}  // namespace lacuna
