#include "foundation/plugins/plugin_call.h"

#include "foundation/plugins/plugin_libraries.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <unordered_map>

namespace lacuna {

thread_local constinit CallSlot* own_call_slot_or_null = nullptr;

namespace {

constexpr std::size_t kSlots = 2048;
constexpr std::size_t kTextSize = std::size_t{1} << 20;

struct Page {
  std::array<CallSlot, kSlots> slots;
  std::atomic<CallSlot*> culprit = nullptr;  ///< of the thread that ended the process
  std::atomic<bool> closed = false;
  std::atomic<int> exit_code = 0;
  std::atomic<double> evaluation_limit = 0.0;
  std::atomic<bool> new_beginning = false;
  std::atomic<std::uint32_t> task = 0;
  std::atomic<std::size_t> text_used = 0;
  std::array<char, kTextSize> text;
};
static_assert(std::atomic<CallSlot*>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free);

/// Without shared memory the calls are still recorded, for this process alone. Untouched pages take no memory.
Page* map_page() {
  void* memory = mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) memory = ::operator new (sizeof(Page), std::align_val_t{alignof(Page)});
  return new (memory) Page;
}

Page& page() {
  static Page* const mapped = map_page();
  return *mapped;
}

/// For threads without a slot.
CallSlot& spare_slot() {
  thread_local CallSlot spare;
  return spare;
}

CallSlot& take_slot() {
  for (CallSlot& slot : page().slots)
    if (!slot.taken.load(std::memory_order_relaxed) && !slot.taken.exchange(true)) return slot;
  return spare_slot();
}

/// Returns the slot at the end of the thread. A thread that ends in a call has called `exit`; its slot still shows
/// where.
struct SlotLease {
  CallSlot& slot = take_slot();
  ~SlotLease() {
    if (slot.component != nullptr) return;
    own_call_slot_or_null = nullptr;
    slot.taken = false;
  }
};

/// Records that a process shares with those it forks; processes forked later have a copy.
std::vector<RefusedComponent>& refused_components() {
  static auto* const refused = new std::vector<RefusedComponent>;
  return *refused;
}

bool is_watched = false;  ///< whether another process learns how this one ended
bool begins_once = false;

void blame_this_thread() {
  CallSlot* nobody = nullptr;
  if (own_call_slot_or_null != nullptr) page().culprit.compare_exchange_strong(nobody, own_call_slot_or_null);
  if (own_call_slot_or_null == nullptr || own_call_slot_or_null->component == nullptr)
    PluginLibraries::blame_this_thread();
}

/// The signal is raised again with its default action, so that core files and exit status are as usual.
void on_crash(int signal) {
  blame_this_thread();
  std::raise(signal);
}

void add_call(const CallSlot& slot, std::vector<ActiveCall>& calls) {
  const char* component = slot.component;
  const char* call = slot.call;
  if (component == nullptr || call == nullptr) return;
  const ActiveCall active{component, call};
  if (std::find(calls.begin(), calls.end(), active) == calls.end()) calls.push_back(active);
}

const char* copy_to_page(const std::string& text) {
  Page& shared = page();
  const std::size_t size = text.size() + 1;
  if (shared.text_used + size > kTextSize) return "a plugin";  // a literal, which both processes have
  char* const place = shared.text.data() + shared.text_used;
  std::memcpy(place, text.c_str(), size);
  shared.text_used += size;
  return place;
}

}  // namespace

CallSlot& take_call_slot() {
  thread_local SlotLease lease;
  own_call_slot_or_null = &lease.slot;
  return lease.slot;
}

const char* component_on_page(const std::string& component) {
  static std::mutex adding;
  static auto* const known = new std::unordered_map<std::string, const char*>;
  const std::scoped_lock lock(adding);
  const auto [entry, is_new] = known->try_emplace(component, nullptr);
  if (is_new) entry->second = copy_to_page(component);
  return entry->second;
}

std::vector<ActiveCall> CallPage::active() {
  std::vector<ActiveCall> calls;
  if (const CallSlot* culprit = page().culprit) {
    add_call(*culprit, calls);
    return calls;
  }
  for (const CallSlot& slot : page().slots) add_call(slot, calls);
  return calls;
}

ActiveCall CallPage::call_of(const CallSlot& slot) {
  const char* component = slot.component;
  const char* call = slot.call;
  return {component == nullptr ? "" : component, component == nullptr || call == nullptr ? "" : call};
}

std::vector<BusyThread> CallPage::busy() {
  std::vector<BusyThread> threads;
  for (const CallSlot& slot : page().slots) {
    if (!slot.taken) continue;
    const bool evaluates = slot.evaluations > 0;
    if (evaluates || slot.component != nullptr) threads.push_back({&slot, evaluates, slot.ticks, slot.calls});
  }
  return threads;
}

void CallPage::prepare() {
  page().culprit = nullptr;
  page().closed = false;
  page().evaluation_limit = 0.0;
  page().new_beginning = false;
  for (CallSlot& slot : page().slots) {
    slot.component = nullptr;
    slot.evaluations = 0;
    slot.allowance = 0.0;
    slot.taken = &slot == own_call_slot_or_null;
  }
}

void CallPage::limit_evaluations(double seconds) { page().evaluation_limit = seconds; }
double CallPage::evaluation_limit() { return page().evaluation_limit; }

void CallPage::set_task(std::uint32_t task) { page().task = task; }
std::uint32_t CallPage::task() { return page().task; }

void CallPage::allow_new_beginning(bool allowed) { page().new_beginning = allowed && !begins_once; }
void CallPage::never_begin_anew() { begins_once = true; }
bool CallPage::allows_new_beginning() { return page().new_beginning; }

void CallPage::refuse(const RefusedComponent& component) { refused_components().push_back(component); }

std::optional<std::string> CallPage::refusal_of(const std::string& component) {
  for (const RefusedComponent& refused : refused_components())
    if (refused.component == component) return refused.reason;
  return std::nullopt;
}

void CallPage::clear() {
  page().culprit = nullptr;
  own_call_slot().component = nullptr;
  own_call_slot().evaluations = 0;
  own_call_slot().taken = true;  // the other process's thread of this slot may have returned it
}

void CallPage::watch_this_process() {
  page();
  is_watched = true;
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGSYS}) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) continue;
    struct sigaction watching {};
    watching.sa_handler = on_crash;
    watching.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &watching, nullptr);
  }
  watch_exits();
}

void CallPage::watch_exits() {
  // Other threads continue: their data must not be destroyed, or their crash would hide the exit.
  on_exit(
      [](int status, void*) {
        if (is_closed()) return;
        blame_this_thread();
        if (!is_watched) return;
        std::fflush(stdout);
        _exit(status);
      },
      nullptr);
}

void CallPage::close(int exit_code) {
  page().exit_code = exit_code;
  page().closed = true;
}

bool CallPage::is_closed() { return page().closed; }
int CallPage::exit_code() { return page().exit_code; }

}  // namespace lacuna
