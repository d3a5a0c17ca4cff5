#pragma once

namespace lacuna {

/// Runs `work(argc, argv)` in a child process, with this one's streams, terminal and process group, and returns its
/// exit code. A child that ends otherwise than by returning from `work`, be it that a plugin calls `exit` or crashes,
/// makes a line on standard error that names the plugin and the call, and exit code 1.
///
/// Signals that ask a program to end or to stop reach the child, whoever they are sent to; the child does not outlive
/// this process. Call it before there are threads.
int run_supervised(int argc, char** argv, int (*work)(int, char**));

}  // namespace lacuna
