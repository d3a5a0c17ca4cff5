#include "app/commands/worker.h"

#include "app/runs/worker_setup.h"
#include "app/terminal/child_watch.h"
#include "app/terminal/supervised.h"
#include "foundation/processes/memory_limit.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/processes/process_limits.h"
#include "isolation/serve_evaluations.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>

namespace lacuna {
namespace {

constexpr std::uint64_t kStack = std::uint64_t{64} << 20;

/// Takes the standard input for itself: what plugins read is nothing, and what they print goes to the run's standard
/// error.
MessageChannel channel_to_host() {
  MessageChannel channel(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  close(nothing);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  return channel;
}

void limit(const WorkerTask& task) {
  CallPage::limit_evaluations(task.evaluation_limit);
  limit_stack(kStack);
  if (task.memory > 0) limit_memory(task.memory);
}

std::unique_ptr<const OpenEeaRun> open_eea_run(const MessageChannel& channel) try {
  const WorkerTask task = receive_task(channel);
  limit(task);
  return std::make_unique<const OpenEeaRun>(open_worker_run(task));
} catch (const std::exception& error) {
  send_failure(channel, failure_sentence(error));
  return nullptr;
}

int run_worker(int, char**) {
  const MessageChannel channel = channel_to_host();
  const std::unique_ptr<const OpenEeaRun> opened = open_eea_run(channel);
  if (!opened) return 1;
  serve_evaluations(channel, opened->definition());
  std::fflush(nullptr);
  CallPage::close(0);
  _exit(0);  // nothing is left to be done, and plugins' ends are none of the run's concern
}

/// Tells the run that the process which did the work has ended.
void tell_host(const ChildLoss& loss) {
  const MessageChannel channel(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  send_lost(channel, {loss.component, loss.deed, CallPage::task(), loss.is_the_works});
}

}  // namespace

bool is_worker(int argc, char** argv) {
  struct stat input {};
  const bool has_channel = fstat(STDIN_FILENO, &input) == 0 && S_ISSOCK(input.st_mode);
  return has_channel && argc == 2 && std::string_view(argv[1]) == "worker";
}

int supervise_worker(int argc, char** argv) {
  CallPage::never_begin_anew();  // its task was sent once
  ignore_wishes();
  return run_supervised(argc, argv, run_worker, tell_host);
}

}  // namespace lacuna
