#pragma once

namespace lacuna {

/// Whether a process was begun by a run as one of its workers (isolation/): no command of users.
bool is_worker(int argc, char** argv);

/// Evaluates models for the run whose channel is the standard input, until that closes it. The run alone ends it:
/// wishes of others, as a batch system sends to all processes, are the run's to obey.
int supervise_worker(int argc, char** argv);

}  // namespace lacuna
