#include "simulation/ode/session.h"

#include "simulation/shared/robot_motion.h"

#include <ode/ode.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace lacuna::ode {
namespace {

thread_local std::array<char, 256> complaint_text{};

void write_message(std::array<char, 256>& text, const char* format, va_list arguments) {
  std::vsnprintf(text.data(), text.size(), format, arguments);
}

[[noreturn]] void fail(int /*number*/, const char* format, va_list arguments) {
  std::array<char, 256> text{};
  write_message(text, format, arguments);
  throw simulation::EngineFailure(std::string("ODE failed: ") + text.data());
}

void complain(int /*number*/, const char* format, va_list arguments) {
  if (complaint_text[0] == '\0') write_message(complaint_text, format, arguments);
}

/// ODE writes to memory that it failed to allocate.
void* allocate(dsizeint size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr && size > 0) throw std::bad_alloc();
  return memory;
}

void* reallocate(void* old, dsizeint /*old_size*/, dsizeint size) {
  void* const memory = std::realloc(old, size);
  if (memory == nullptr && size > 0) throw std::bad_alloc();
  return memory;
}

void deallocate(void* memory, dsizeint /*size*/) { std::free(memory); }

struct Library {
  Library() {
    dSetAllocHandler(allocate);
    dSetReallocHandler(reallocate);
    dSetFreeHandler(deallocate);
    dInitODE2(dInitFlagManualThreadCleanup);
    dSetErrorHandler(fail);
    dSetDebugHandler(fail);
    dSetMessageHandler(complain);
  }
};

struct ThreadData {
  ThreadData() {
    if (!dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)))
      throw Error("ODE cannot allocate memory for another thread");
  }
  ~ThreadData() { dCleanupODEAllDataForThread(); }
};

}  // namespace

void join_session() {
  static const Library library;  // never closed: worlds in static storage may outlive it
  static thread_local const ThreadData data;
}

void clear_complaint() { complaint_text[0] = '\0'; }
const char* complaint() { return complaint_text.data(); }

}  // namespace lacuna::ode
