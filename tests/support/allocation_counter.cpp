#include "support/allocation_counter.h"

#include <atomic>
#include <cstdlib>

namespace {
std::atomic<long> count{0};
}  // namespace

#if !LACUNA_WATCHED
extern "C" {
void* __libc_malloc(std::size_t size);                      // NOLINT
void* __libc_calloc(std::size_t number, std::size_t size);  // NOLINT
void* __libc_realloc(void* memory, std::size_t size);       // NOLINT
void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  ++count;
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) {
  ++count;
  return __libc_realloc(memory, size);
}
}
#endif

namespace lacuna {

long allocations() { return count; }

}  // namespace lacuna
