#pragma once

#include "foundation/processes/child_program.h"
#include "isolation/channel.h"
#include "isolation/messages.h"

#include <lacuna/error.h>

#include <memory>
#include <string>
#include <utility>

namespace lacuna {

/// Thrown where a worker process has ended instead of answering.
class WorkerLost : public Error {
 public:
  explicit WorkerLost(LostWork lost) : Error(lost.deed), work(std::move(lost)) {}

  LostWork work;
};

/// A process of this program that evaluates models, on one thread.
class WorkerProcess {
 public:
  /// Starts the running program a second time; it starts up while this process goes on.
  WorkerProcess(const WorkerTask& task, const Stop& stop);

  /// The answer to a request. Throws `WorkerLost`, after which this worker gives no more answers; `Error` with the
  /// worker's message; `Interrupted`.
  std::string ask(const Request& request);

 private:
  WorkerProcess(std::pair<MessageChannel, std::unique_ptr<ChildProgram>> begun, const WorkerTask& task);
  std::string answer();

  MessageChannel channel_;
  std::unique_ptr<ChildProgram> child_;
  bool is_ready_ = false;  ///< its first answer was read
};

}  // namespace lacuna
