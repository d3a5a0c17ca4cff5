#pragma once

#include <string>

namespace lacuna {

/// How a child process came to an end that was not its own.
struct ChildLoss {
  std::string component;      ///< of a plugin, as messages name it, that ended it; empty: not known, or none
  std::string deed;           ///< what happened, a clause
  std::string sentence;       ///< the same for people: with what follows from it, and what to do
  bool is_the_works = false;  ///< it follows from what the child was at, and would happen again
  bool was_asked = false;     ///< it had been asked to end
  bool begins_anew = false;   ///< without the component that ended it, which was said
  std::string left = {};      ///< what the child had left (`leave_to_supervisor`)
};

/// In a child: what `ChildLoss::left` is, should it end otherwise than by returning. Throws `Error` where it is too
/// long.
void leave_to_supervisor(const std::string& left);

/// Prints a line on standard error, or nowhere where that is closed.
void tell(const std::string& line);
/// Tells what became of the child; nothing where the work begins anew.
void print_loss(const ChildLoss& loss);

/// Runs `work(argc, argv)` in a child process, with this one's streams, terminal and process group, and returns its
/// exit code. A child that ends otherwise than by returning from `work`, be it that a plugin calls `exit`, crashes or
/// hangs (app/terminal/child_watch.h), is reported by `report` with the plugin and the call, and makes exit code 1; 75
/// where a user had asked it to end. What it left running is ended. Work that allows it (`CallPage`) is begun anew
/// without a component that has ended it. The child may use most of the machine's memory; beyond it allocations fail.
///
/// Signals that ask a program to end or to stop reach the child, whoever they are sent to; the child does not outlive
/// this process. Call it before there are threads.
int run_supervised(int argc, char** argv, int (*work)(int, char**), void (*report)(const ChildLoss&) = print_loss);

}  // namespace lacuna
