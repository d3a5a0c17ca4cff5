#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What a thread is about to do in a plugin. It lies in memory that processes share which are forked later, so that
/// one can tell in which call the other ended, whatever ended it.
struct alignas(64) CallSlot {
  std::atomic<const char*> component = nullptr;  ///< as `component_on_page` gave it; null: no plugin is called
  std::atomic<const char*> call = nullptr;       ///< a literal, as in "add_loads"
  std::atomic<bool> taken = false;
  std::atomic<std::uint32_t> evaluations = 0;  ///< under way in this thread, one inside the other
  std::atomic<std::uint32_t> ticks = 0;        ///< evaluations begun and ended; that of the thread alone writes it
  std::atomic<std::uint32_t> calls = 0;        ///< begun; the same
  std::atomic<double> allowance = 0.0;         ///< s, by which the present call may take longer than others
};

extern thread_local constinit CallSlot* own_call_slot_or_null;
CallSlot& take_call_slot();

/// The slot of this thread, which has it until it ends.
inline CallSlot& own_call_slot() {
  return own_call_slot_or_null != nullptr ? *own_call_slot_or_null : take_call_slot();
}

/// A component's text where the processes that are forked later see it, and the one that forked this one does. Equal
/// texts have equal addresses. Takes a lock: ask once and keep the pointer.
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

/// While it lives, this thread calls plugins; what it did before is restored with its end.
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

/// Calls of plugins by the thread that made it, one after another, for loops that cannot afford a `PluginCall` each.
/// What the thread did before is restored by `leave`, not by its end: it may be kept, and be made anew by another
/// thread.
class CallSequence {
 public:
  CallSequence() noexcept : before_(own_call_slot()) {}

  void enter(const char* component, const char* call) noexcept { before_.set(component, call); }
  void leave() noexcept { before_.restore(); }

 private:
  SlotBefore before_;
};

/// While it lives, this thread works for the host, be it that a plugin asked for it.
class HostCall : private PluginCall {
 public:
  HostCall() noexcept : PluginCall(nullptr, nullptr) {}
};

/// While it lives, calls of this thread may take longer by so many seconds than others, such as a test that a rig
/// carries out.
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

/// While it lives, this thread evaluates a model: what another process may end when it takes too long. One inside
/// another counts as progress of the outer one.
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

/// A call as one process finds it after the other's end.
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

/// A component that is not to be used any more.
struct RefusedComponent {
  std::string component;  ///< as messages name it
  std::string reason;     ///< a sentence
};

/// What is remembered of a process that ended; the pointers lie on pages that both have.
class CallPage {
 public:
  /// Before a process is forked that is to be watched, while this one has one thread. What an earlier one left is
  /// forgotten.
  static void prepare();
  /// The calls that threads were in; only that of the thread that ended the process, where it is known. Each once.
  static std::vector<ActiveCall> active();
  /// What a thread is in; empty texts: nothing of a plugin.
  static ActiveCall call_of(const CallSlot& slot);
  /// All threads that are in a call or in an evaluation.
  static std::vector<BusyThread> busy();
  /// Forgets what a process that this thread forked has left.
  static void clear();

  /// How long an evaluation may take, s; the process that watches this one ends it then. 0: as long as it likes.
  static void limit_evaluations(double seconds);
  static double evaluation_limit();

  /// Which piece of its work the process is at, for the one that watches it.
  static void set_task(std::uint32_t task);
  static std::uint32_t task();

  /// The work can be begun anew without a component that has ended it (`refused`), and goes on from where it was.
  static void allow_new_beginning(bool allowed);
  static bool allows_new_beginning();
  /// From now on neither this process nor one that it forks begins anew: what it works on was handed to it once.
  static void never_begin_anew();
  /// For processes that are forked later.
  static void refuse(const RefusedComponent& component);
  static std::optional<std::string> refusal_of(const std::string& component);

  /// From now on a thread of this process that calls `exit`, aborts or crashes is remembered as the one, and the plugin
  /// library that it was in (foundation/plugins/plugin_libraries.h). A signal that
  /// something else has a handler for, such as a sanitizer, is left alone.
  static void watch_this_process();
  /// The same for `exit` alone, once more: what is registered later runs earlier, before the ends of plugins.
  static void watch_exits();

  /// The process is about to end as it should, with this exit code.
  static void close(int exit_code);
  static bool is_closed();
  static int exit_code();
};

}  // namespace lacuna
