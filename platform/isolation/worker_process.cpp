#include "isolation/worker_process.h"

#include "isolation/carried.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace lacuna {
namespace {

constexpr double kGrace = 1.0;  // s, to wait for the end of a process that has closed its channel

/// A channel, and a program whose standard input is the other end.
std::pair<MessageChannel, std::unique_ptr<ChildProgram>> begin(const Stop& stop) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw Error(std::string("no channel to a worker process: ") + strerror(errno));
  MessageChannel here(ends[0], stop);
  const MessageChannel there(ends[1]);
  ChildBeginning beginning;
  beginning.words = {"/proc/self/exe", "worker"};  // works also after the program's file was replaced
  beginning.input = ends[1];
  beginning.errors = STDERR_FILENO;
  return {std::move(here), std::make_unique<ChildProgram>(beginning)};
}

}  // namespace

WorkerProcess::WorkerProcess(const WorkerTask& task, const Stop& stop) : WorkerProcess(begin(stop), task) {}

WorkerProcess::WorkerProcess(std::pair<MessageChannel, std::unique_ptr<ChildProgram>> begun, const WorkerTask& task)
    : channel_(std::move(begun.first)), child_(std::move(begun.second)) {
  channel_.send(to_bytes(Request(task)));  // if it has already ended, its answer tells so
}

std::string WorkerProcess::answer() {
  std::optional<std::string> message = channel_.receive();
  if (!message || message->empty()) {
    const auto ending = child_->ended_within(kGrace);
    throw WorkerLost({"", ending ? "a worker process " + ending->phrase() : "a worker process closed its channel", 0});
  }
  const auto kind = static_cast<AnswerKind>(message->front());
  message->erase(0, 1);
  if (kind == AnswerKind::lost) throw WorkerLost(from_bytes<LostWork>(*message));
  if (kind == AnswerKind::failed) throw Error(from_bytes<std::string>(*message));
  if (kind != AnswerKind::done) throw Error("a worker process sent an answer of an unknown kind");
  return std::move(*message);
}

std::string WorkerProcess::ask(const Request& request) {
  if (!is_ready_) answer();
  is_ready_ = true;
  channel_.send(to_bytes(request));
  return answer();
}

}  // namespace lacuna
