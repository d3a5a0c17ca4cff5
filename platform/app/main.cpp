#include "app/commands/commands.h"
#include "app/commands/worker.h"
#include "app/tasks/task_left.h"
#include "app/terminal/plain_streams.h"
#include "app/terminal/supervised.h"
#include "foundation/processes/process_limits.h"

#include <new>

int main(int argc, char** argv) try {
  lacuna::make_streams_plain();
  if (lacuna::is_worker(argc, argv)) return lacuna::supervise_worker(argc, argv);
  return lacuna::run_supervised(argc, argv, lacuna::run_program, lacuna::report_loss);
} catch (const std::bad_alloc&) {
  lacuna::tell_no_memory();
  return 1;
}
