#include "process/child_lines.h"

#include "foundation/files/allowed_files.h"
#include "process/quoted_text.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kMostUnread = 64U << 20U;  // bytes
constexpr std::size_t kBlock = 1U << 16U;
constexpr int kMostBlocks = 64;                 // of blank lines that nobody asked for, at a time
constexpr std::chrono::milliseconds kLook{50};  // how often an interrupt and the program's end are looked for
constexpr double kGoodbye = 1.0;                // s, for a program that has seen the end of its input
constexpr double kGrace = 1.0;                  // s, between SIGTERM and SIGKILL
constexpr double kLastBreath = 0.5;             // s, between the end of a program's output and its own
constexpr std::size_t kLastWords = 5;           // lines
constexpr double kLongest = 1e9;                // s, which a clock that counts nanoseconds can tell

/// Two ends of a pipe that no other child inherits.
std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(fmt::format("cannot be connected: {}", strerror(errno)));
  return ends;
}

void close_end(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

/// Writes without the signal that ends a process whose reader is gone.
ssize_t write_quietly(int descriptor, std::string_view text) {
  sigset_t pipe{}, before{};
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe, &before);
  const ssize_t written = write(descriptor, text.data(), text.size());
  const int problem = errno;
  if (written < 0 && problem == EPIPE) {
    const timespec at_once{};
    sigtimedwait(&pipe, nullptr, &at_once);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = problem;
  return written;
}

bool is_blank_line(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

}  // namespace

ChildLines::Clock::time_point ChildLines::in(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, kLongest)));
}

ChildLines::ChildLines(const ProcessSource& source, const Stop& stop) : stop_(stop), errors_("standard error") {
  if (files_are_limited())
    throw Error("an agent may not start it (lacuna mcp); carry out the test yourself: lacuna trial");
  std::array<int, 2> input = make_pipe(), output = {-1, -1};
  try {
    output = make_pipe();
    child_.emplace(ChildBeginning{.words = source.command,
                                  .folder = source.folder,
                                  .environment = source.environment,
                                  .input = input[0],
                                  .output = output[1],
                                  .errors = errors_.file()});
  } catch (...) {
    for (int end : {input[0], input[1], output[0], output[1]}) close_end(end);
    throw;
  }
  close_end(input[0]);
  close_end(output[1]);
  to_child_ = input[1];
  from_child_ = output[0];
  fcntl(to_child_, F_SETFL, O_NONBLOCK);  // a program that reads nothing must not hold this one up
}

ChildLines::~ChildLines() {
  close_end(to_child_);
  if (!child_->ended_within(kGoodbye)) child_->end(kGrace);
  close_end(from_child_);
}

void ChildLines::send(std::string_view line, Clock::time_point until) {
  const std::string text = std::string(line) + '\n';
  std::string_view unsent = text;
  while (!unsent.empty()) {
    if (closed_) throw_ending();
    wait(until, unsent);
  }
}

std::string ChildLines::receive(Clock::time_point until) {
  std::string line;
  std::string_view nothing;
  while (!take_line(line)) {
    if (closed_) throw_ending();
    wait(until, nothing);
  }
  return line;
}

std::string ChildLines::unasked() {
  std::string line;
  pollfd reading{from_child_, POLLIN, 0};
  for (int block = 0; block < kMostBlocks && !take_line(line) && !closed_ && poll(&reading, 1, 0) > 0; ++block)
    read_some();
  return line;
}

bool ChildLines::has_ended() { return closed_ || child_->ended().has_value(); }

std::string ChildLines::last_words() { return last_lines(errors_.end(), kLastWords); }

/// Waits until there is something to read, or room for what is unsent, and takes it; at most until `until`.
void ChildLines::wait(Clock::time_point until, std::string_view& unsent) {
  stop_.throw_if_due();
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
  if (left.count() <= 0) throw_lateness(!unsent.empty());
  std::array<pollfd, 2> ends = {pollfd{from_child_, POLLIN, 0}, pollfd{to_child_, POLLOUT, 0}};
  const int found = poll(ends.data(), unsent.empty() ? 1 : 2,
                         static_cast<int>(std::min(left + std::chrono::milliseconds(1), kLook).count()));
  if (found == 0) look_for_end();
  if (found <= 0) return;
  if (ends[0].revents != 0) read_some();
  if (unsent.empty() || ends[1].revents == 0) return;
  const ssize_t written = write_quietly(to_child_, unsent.substr(0, kBlock));
  if (written > 0) unsent.remove_prefix(static_cast<std::size_t>(written));
  if (written < 0 && errno == EPIPE) throw_ending();
}

/// Its own end is the end also where something else, such as a helper that it has started, holds its output open.
void ChildLines::look_for_end() {
  pollfd reading{from_child_, POLLIN, 0};
  if (child_->ended() && poll(&reading, 1, 0) == 0) closed_ = true;
}

void ChildLines::read_some() {
  std::array<char, kBlock> block;
  const ssize_t got = read(from_child_, block.data(), block.size());
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (got <= 0)
    closed_ = true;
  else
    received_.append(block.data(), static_cast<std::size_t>(got));
  if (received_.size() > kMostUnread)
    throw Error(fmt::format("sent {} of more than {} MiB, which begins with {}",
                            received_.find('\n') == std::string::npos ? "a line" : "an answer", kMostUnread >> 20U,
                            quoted_text(received_)));
}

/// Blank lines are none.
bool ChildLines::take_line(std::string& line) {
  std::size_t begin = 0;
  line.clear();
  for (std::size_t end; is_blank_line(line); begin = end + 1) {
    end = received_.find('\n', std::max(begin, searched_));
    if (end == std::string::npos) break;
    line.assign(received_, begin, end - begin);
  }
  received_.erase(0, begin);
  const bool found = !is_blank_line(line);
  searched_ = found ? 0 : received_.size();
  if (!found) line.clear();
  return found;
}

void ChildLines::throw_lateness(bool reads_nothing) const {
  if (reads_nothing) throw TookTooLong("does not read its standard input");
  if (received_.empty()) throw TookTooLong("did not answer in time");
  throw TookTooLong(fmt::format("did not finish its line in time, {} so far", quoted_text(received_)));
}

void ChildLines::throw_ending() {
  const std::optional<ChildEnding> ending = child_->ended_within(kLastBreath);
  const std::string what = ending    ? ending->phrase()
                           : closed_ ? "closed its standard output"
                                     : "closed its standard input";
  const std::string_view said = std::string_view(received_).substr(0, received_.find('\n'));
  if (is_blank_line(said)) throw Error(what);
  const char* when = said.size() < received_.size() ? " after it sent " : " in the middle of a line, ";
  throw Error(what + when + quoted_text(said));
}

}  // namespace lacuna
