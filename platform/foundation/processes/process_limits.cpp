#include "foundation/processes/process_limits.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <new>
#include <string_view>
#include <system_error>

namespace lacuna {
namespace {

constexpr rlim_t kFewestFiles = 24, kWantedFiles = 1024;
constexpr rlim_t kSmallestStack = rlim_t{512} << 10U, kWantedStack = rlim_t{8} << 20U;  // bytes
constexpr std::size_t kThreadStack = std::size_t{2} << 20U;                             // bytes

rlimit limit_of(__rlimit_resource resource) {
  rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  getrlimit(resource, &limit);
  return limit;
}

/// The limit after it was raised towards `wanted`.
rlim_t raised(__rlimit_resource resource, rlim_t wanted) {
  rlimit limit = limit_of(resource);
  if (limit.rlim_cur >= wanted) return limit.rlim_cur;
  limit.rlim_cur = std::min(wanted, limit.rlim_max);
  setrlimit(resource, &limit);
  return limit_of(resource).rlim_cur;
}

/// Threads that start later get a stack size that does not depend on this thread's limit.
void raise_stacks_of_threads() {
  pthread_attr_t attributes;
  if (pthread_getattr_default_np(&attributes) != 0) return;
  std::size_t size = 0;
  if (pthread_attr_getstacksize(&attributes, &size) == 0 && size < kThreadStack &&
      pthread_attr_setstacksize(&attributes, kThreadStack) == 0)
    pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

/// In bytes.
rlim_t most_memory() { return std::min(limit_of(RLIMIT_AS).rlim_cur, limit_of(RLIMIT_AS).rlim_max); }

/// Fills `text` with the sentence.
void write_memory_sentence(std::array<char, 300>& text) {
  const rlim_t space = most_memory();
  if (space == RLIM_INFINITY)
    std::snprintf(text.data(), text.size(),
                  "there is not enough memory for this command; give it more memory, fewer --threads or less data");
  else
    std::snprintf(text.data(), text.size(),
                  "there is not enough memory for this command, which may use %.0f MiB (ulimit -v %llu); raise this "
                  "limit, or give it fewer --threads or less data",
                  static_cast<double>(space) / 1048576.0, static_cast<unsigned long long>(space / 1024));
}

}  // namespace

void prepare_limits() {
  if (const rlim_t files = raised(RLIMIT_NOFILE, kWantedFiles); files < kFewestFiles)
    throw Error(fmt::format(
        "the limit of open files is {} (ulimit -n), too few for this program; allow {} or more: ulimit -n {}", files,
        kFewestFiles, kWantedFiles));
  if (const rlim_t stack = raised(RLIMIT_STACK, kWantedStack); stack < kSmallestStack)
    throw Error(
        fmt::format("the stack limit is {} kB (ulimit -s), too small for this program; allow {} or more: ulimit -s {}",
                    stack / 1024, kSmallestStack / 1024, kWantedStack / 1024));
  raise_stacks_of_threads();
}

std::string no_memory_sentence() {
  std::array<char, 300> text{};
  write_memory_sentence(text);
  return text.data();
}

std::string crash_for_want_of_memory() {
  const rlim_t space = most_memory();
  if (space == RLIM_INFINITY) return {};
  return fmt::format(
      "it may use {} MiB of memory (ulimit -v {}), and a stack that cannot grow ends a process in this way: raise this "
      "limit",
      space >> 20U, space >> 10U);
}

std::string failure_sentence(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return no_memory_sentence();
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  if (of_system != nullptr && of_system->code() == std::errc::resource_unavailable_try_again)
    return "a thread could not be started: " + no_memory_sentence();
  return error.what();
}

void tell_no_memory() noexcept {
  constexpr std::string_view kKept = ". What was committed to the database is kept\n";
  std::array<char, 300> text{};
  write_memory_sentence(text);
  for (const std::string_view part : {std::string_view("lacuna: "), std::string_view(text.data()), kKept})
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) return;
}

std::string used_up_descriptors() {
  const int probe = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int problem = errno;
  if (probe >= 0) close(probe);
  if (probe >= 0 || (problem != EMFILE && problem != ENFILE)) return {};
  return fmt::format("too many files are open at once; this process may open {} (ulimit -n)",
                     limit_of(RLIMIT_NOFILE).rlim_cur);
}

std::string used_up_processor_time() {
  const rlim_t most = limit_of(RLIMIT_CPU).rlim_cur;
  rusage used{};
  if (most == RLIM_INFINITY || getrusage(RUSAGE_CHILDREN, &used) != 0) return {};
  const auto seconds = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1);
  if (seconds < most) return {};
  return fmt::format("it used up its processor time of {} s (ulimit -t)", most);
}

}  // namespace lacuna
