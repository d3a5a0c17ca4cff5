#include "foundation/processes/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace lacuna {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kWatched = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kWatched = true;
#else
constexpr bool kWatched = false;
#endif
#else
constexpr bool kWatched = false;
#endif

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// Limit of a container or a batch job; a missing file, or "max", sets none.
std::uint64_t limit_in(const std::filesystem::path& file) {
  std::uint64_t bytes = 0;
  std::ifstream stream(file);
  return stream >> bytes ? bytes : kNoLimit;
}

/// The smallest limit of a control group and its parents. `group`: "/slurm/job_17".
std::uint64_t limit_of(const std::filesystem::path& hierarchy, std::filesystem::path group, const char* file) {
  std::uint64_t least = limit_in(hierarchy / file);
  for (; group.has_relative_path(); group = group.parent_path())
    least = std::min(least, limit_in(hierarchy / group.relative_path() / file));
  return least;
}

/// For this process, whose groups are in /proc/self/cgroup: "0::/group", or "4:memory:/group" with version 1.
std::uint64_t limit_of_groups() {
  std::uint64_t least = kNoLimit;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty())
      least = std::min(least, limit_of("/sys/fs/cgroup", group, "memory.max"));
    else if (controllers == "memory")
      least = std::min(least, limit_of("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
  }
  return least;
}

template <class Resource>
void lower(Resource resource, std::uint64_t bytes) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, bytes);
  setrlimit(resource, &limit);
}

}  // namespace

std::uint64_t usable_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  const std::uint64_t physical =
      pages > 0 && page > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page) : kNoLimit;
  return std::min(physical, limit_of_groups()) / 10 * 9;
}

void limit_memory(std::uint64_t bytes) {
  if (!kWatched) lower(RLIMIT_DATA, bytes);
}

void limit_stack(std::uint64_t bytes) { lower(RLIMIT_STACK, bytes); }

}  // namespace lacuna
