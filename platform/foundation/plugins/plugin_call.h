#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// The plugin call of a thread. It is in memory shared with processes that are forked later, so that one can tell in
/// which call the other ended, whatever the cause.
struct alignas(64) CallSlot {
  std::atomic<const char*> component = nullptr;  ///< as `component_on_page` gave it; null: no plugin is called
  std::atomic<const char*> call = nullptr;       ///< a literal, as in "add_loads"
  std::atomic<bool> taken = false;
  std::atomic<std::uint32_t> evaluations = 0;  ///< nested calls in progress in this thread
  std::atomic<std::uint32_t> ticks = 0;        ///< number of evaluations begun plus ended; written only by that thread
  std::atomic<std::uint32_t> calls = 0;        ///< begun; the same
  std::atomic<double> allowance = 0.0;         ///< s, by which the current call may take longer than others
};

extern thread_local constinit CallSlot* own_call_slot_or_null;
CallSlot& take_call_slot();

/// The slot of this thread, until it ends.
inline CallSlot& own_call_slot() {
  return own_call_slot_or_null != nullptr ? *own_call_slot_or_null : take_call_slot();
}

/// A component's text in memory shared with the processes that are forked later and with the one that forked this one.
/// Equal texts have equal addresses. Takes a lock: call it once and keep the pointer.
const char* component_on_page(const std::string& component);

/// A slot with what stood in it.
class SlotBefore {
 public:
  explicit SlotBefore(CallSlot& slot) noexcept
      : slot_(&slot),
        component_(slot.component.load(std::memory_order_relaxed)),
        call_(slot.call.load(std::memory_order_relaxed)) {}

  void set(const char* component, const char* call) noexcept {
    slot_->component.store(component, std::memory_order_relaxed);
    slot_->call.store(call, std::memory_order_relaxed);
  }
  void restore() noexcept { set(component_, call_); }
  void count() noexcept {
    constexpr auto relaxed = std::memory_order_relaxed;
    slot_->calls.store(slot_->calls.load(relaxed) + 1, relaxed);
  }

 private:
  CallSlot* slot_;
  const char* component_;
  const char* call_;
};

/// During its lifetime, this thread calls plugins; its end restores the previous state.
class PluginCall {
 public:
  PluginCall(const char* component, const char* call) noexcept : before_(own_call_slot()) {
    before_.count();
    enter(component, call);
  }
  ~PluginCall() { before_.restore(); }
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

  void enter(const char* component, const char* call) noexcept { before_.set(component, call); }

 private:
  SlotBefore before_;
};

/// Repeated calls of plugins by the thread that made it, for loops that cannot afford a `PluginCall` each. `leave`, not
/// its end, restores the previous state: it may be kept, and be started again by another thread.
class CallSequence {
 public:
  CallSequence() noexcept : before_(own_call_slot()) {}

  void enter(const char* component, const char* call) noexcept { before_.set(component, call); }
  void leave() noexcept { before_.restore(); }

 private:
  SlotBefore before_;
};

/// During its lifetime, this thread works for the host, even if a plugin asked for it.
class HostCall : private PluginCall {
 public:
  HostCall() noexcept : PluginCall(nullptr, nullptr) {}
};

/// During its lifetime, calls of this thread may take longer by so many seconds than others, such as a test on a rig.
class CallAllowance {
 public:
  explicit CallAllowance(double seconds) noexcept : slot_(own_call_slot()), before_(slot_.allowance) {
    slot_.allowance = before_ + seconds;
  }
  ~CallAllowance() { slot_.allowance = before_; }
  CallAllowance(const CallAllowance&) = delete;
  CallAllowance& operator=(const CallAllowance&) = delete;

 private:
  CallSlot& slot_;
  double before_;
};

/// During its lifetime, this thread evaluates a model, which another process may end when it takes too long. A nested
/// one counts as progress of the outer one.
class Evaluation {
 public:
  Evaluation() noexcept : slot_(own_call_slot()) { step(1); }
  ~Evaluation() { step(-1); }
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

 private:
  void step(int more) noexcept {
    constexpr auto relaxed = std::memory_order_relaxed;
    slot_.evaluations.store(slot_.evaluations.load(relaxed) + static_cast<std::uint32_t>(more), relaxed);
    slot_.ticks.store(slot_.ticks.load(relaxed) + 1, relaxed);
  }

  CallSlot& slot_;
};

/// A call, as one process finds it after the other's end.
struct ActiveCall {
  std::string component;
  std::string call;
  bool operator==(const ActiveCall&) const = default;
};

/// A thread that is in a call of a plugin or in an evaluation, as another process sees it.
struct BusyThread {
  const CallSlot* slot = nullptr;
  bool evaluates = false;
  std::uint32_t ticks = 0;
  std::uint32_t calls = 0;
};

/// A component that must not be used any more.
struct RefusedComponent {
  std::string component;  ///< as named in messages
  std::string reason;     ///< a sentence
};

/// The record of a process that ended; the pointers refer to pages that both processes have.
class CallPage {
 public:
  /// Call before forking a process to be watched, while this process has one thread. Clears the record of an earlier
  /// one.
  static void prepare();
  /// The calls in which threads were; only that of the thread that ended the process, where it is known. Each once.
  static std::vector<ActiveCall> active();
  /// The call of a thread; empty texts: it was in no plugin.
  static ActiveCall call_of(const CallSlot& slot);
  /// All threads that are in a call or in an evaluation.
  static std::vector<BusyThread> busy();
  /// Clears the record of a process that this thread forked.
  static void clear();

  /// Time limit of an evaluation, s; the process that watches this one ends it then. 0: none.
  static void limit_evaluations(double seconds);
  static double evaluation_limit();

  /// The current piece of work, for the process that watches this one.
  static void set_task(std::uint32_t task);
  static std::uint32_t task();

  /// The work can be restarted without a component that ended it (`refused`), and continues from where it was.
  static void allow_new_beginning(bool allowed);
  static bool allows_new_beginning();
  /// From now on neither this process nor one that it forks can restart: its input was given only once.
  static void never_begin_anew();
  /// For processes that are forked later.
  static void refuse(const RefusedComponent& component);
  static std::optional<std::string> refusal_of(const std::string& component);

  /// From now on a thread of this process that calls `exit`, aborts or crashes is recorded, with the plugin library
  /// that it was in (foundation/plugins/plugin_libraries.h). A signal with another handler, such as a sanitizer's, is
  /// left alone.
  static void watch_this_process();
  /// The same for `exit` only, registered again: handlers that are registered later run earlier, before the destructors
  /// of plugins.
  static void watch_exits();

  /// The process is about to end normally, with this exit code.
  static void close(int exit_code);
  static bool is_closed();
  static int exit_code();
};

}  // namespace lacuna
