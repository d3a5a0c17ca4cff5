#include "foundation/processes/end_without_memory.h"

#include "foundation/plugins/plugin_call.h"

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>

namespace lacuna {
namespace {

std::atomic<void (*)()> last_act = nullptr;
std::terminate_handler usual_end = nullptr;

/// There is no exception if not even one could be made.
bool is_out_of_memory() {
  const std::exception_ptr thrown = std::current_exception();
  if (!thrown) {
    void* const probe = std::malloc(1024);
    std::free(probe);
    return probe == nullptr;
  }
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

bool is_in_plugin() { return own_call_slot_or_null != nullptr && own_call_slot_or_null->component.load() != nullptr; }

[[noreturn]] void end() {
  if (!is_in_plugin() && is_out_of_memory()) last_act.load()();
  if (usual_end != nullptr) usual_end();
  std::abort();
}

}  // namespace

void set_end_without_memory(void (*last)()) {
  if (last_act.exchange(last) == nullptr) usual_end = std::set_terminate(&end);
}

}  // namespace lacuna
