#include "faults/failing_memory.h"

#include "support/sanitizers.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

std::atomic<bool> counting = false;
std::atomic<std::uint64_t> counted = 0;
std::uint64_t failing_at = 0;
bool failing_on = false;

#if !LACUNA_WATCHED
bool fails() {
  if (!counting) return false;
  const std::uint64_t number = ++counted;
  if (failing_at == 0 || number < failing_at || (number > failing_at && !failing_on)) return false;
  errno = ENOMEM;
  return true;
}
#endif

}  // namespace

#if !LACUNA_WATCHED
extern "C" {
void* __libc_malloc(std::size_t size);                      // NOLINT
void* __libc_calloc(std::size_t number, std::size_t size);  // NOLINT
void* __libc_realloc(void* memory, std::size_t size);       // NOLINT
void* malloc(std::size_t size) { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t number, std::size_t size) { return fails() ? nullptr : __libc_calloc(number, size); }
void* realloc(void* memory, std::size_t size) { return fails() ? nullptr : __libc_realloc(memory, size); }
}
#endif

namespace lacuna {

void begin_failing_allocations(std::uint64_t at, bool lasting) {
  failing_at = at;
  failing_on = lasting;
  counted = 0;
  counting = true;
}

std::uint64_t end_failing_allocations() {
  counting = false;
  return counted;
}

}  // namespace lacuna
