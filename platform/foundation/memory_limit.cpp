#include "foundation/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

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

/// What a container may use; a file that is not there, or says "max", sets no limit.
std::uint64_t limit_in(const char* file) {
  std::uint64_t bytes = 0;
  std::ifstream stream(file);
  return stream >> bytes ? bytes : kNoLimit;
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
  const std::uint64_t all = std::min(
      {physical, limit_in("/sys/fs/cgroup/memory.max"), limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
  return all / 10 * 9;
}

void limit_memory(std::uint64_t bytes) {
  if (!kWatched) lower(RLIMIT_DATA, bytes);
}

void limit_stack(std::uint64_t bytes) { lower(RLIMIT_STACK, bytes); }

}  // namespace lacuna
