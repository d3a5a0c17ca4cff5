#pragma once

#include "app/terminal/supervised.h"

namespace lacuna {

/// Whether a process was begun by a run as one of its workers (isolation/): no command of users.
bool is_worker(int argc, char** argv);

/// Evaluates models for the run whose channel is the standard input, until that closes it.
int run_worker(int argc, char** argv);

/// Tells the run that the process which did the work has ended.
void tell_host(const ChildLoss& loss);

}  // namespace lacuna
