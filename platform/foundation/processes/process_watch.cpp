#include "foundation/processes/process_watch.h"

#include "foundation/processes/stop.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/processes/process_state.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <set>
#include <utility>

namespace lacuna {
namespace {

constexpr std::int64_t kBetweenLooks = 50;  // ms

struct Remembered {
  std::mutex looking;
  std::atomic<const ProcessState*> state = nullptr;  ///< the state in which plugins must leave the process
  std::atomic<std::int64_t> next_look = 0;           // ms
  std::atomic<bool> closely = false;
};

Remembered& remembered() {
  static auto* const it = new Remembered;  // threads may still call plugins while the process ends
  return *it;
}

/// Whether this thread has not yet made that call of that component.
bool is_first_call(const char* component, const char* what) {
  thread_local std::set<std::pair<const void*, const void*>> made;
  const std::pair<const void*, const void*> call(component, what);
  return component != nullptr && !made.contains(call) && made.insert(call).second;
}

ProcessState::Extent extent_of_look(Remembered& watch, bool at_once) {
  if (watch.closely) return ProcessState::Extent::complete;
  const std::int64_t now = milliseconds_now();
  if (!at_once && now < watch.next_look.load(std::memory_order_relaxed)) return ProcessState::Extent::quick;
  watch.next_look = now + kBetweenLooks;
  return ProcessState::Extent::at_work;
}

void remember(Remembered& watch) {
  watch.state = new ProcessState;
  usual_floating_point_control = floating_point_control();
}

/// `at_once`: compares everything, however recent the last comparison was.
std::string found(bool at_once) {
  Remembered& watch = remembered();
  const ProcessState* const state = watch.state;
  if (state == nullptr) return {};
  const ProcessState::Extent extent = extent_of_look(watch, at_once);
  if (extent == ProcessState::Extent::quick) return enumerated(state->set_back(extent));
  const std::unique_lock lock(watch.looking, std::try_to_lock);
  if (!lock) return enumerated(state->set_back(ProcessState::Extent::quick));
  const std::vector<std::string> changes = state->set_back(extent);
  if (watch.closely && !changes.empty())
    remember(watch);  // a change that could not be set back is not blamed on the next call
  return enumerated(changes);
}

}  // namespace

void ProcessWatch::begin() {
  Remembered& watch = remembered();
  const std::scoped_lock lock(watch.looking);
  if (watch.state == nullptr) remember(watch);
}

void ProcessWatch::forget() {
  Remembered& watch = remembered();
  const std::scoped_lock lock(watch.looking);
  delete watch.state.exchange(nullptr);
}

void ProcessWatch::look_closely() {
  Remembered& watch = remembered();
  const std::scoped_lock lock(watch.looking);
  if (!watch.closely) remember(watch);
  watch.closely = true;
}

std::string ProcessWatch::changed() { return found(false); }

std::string enumerated(const std::vector<std::string>& changes) {
  std::string text;
  for (std::size_t i = 0; i < changes.size(); ++i)
    text += (i == 0 ? "" : i + 1 == changes.size() ? " and " : ", ") + changes[i];
  return text;
}

ProcessChanged::ProcessChanged(const std::string& deed)
    : Error(deed + "; it was set back; this is a fault of the plugin: repair it or leave this component out"),
      deed_(deed) {}

void throw_if_process_changed(const char* what) {
  // The first call of each component is fully checked, whatever that costs in time.
  const bool at_once = is_first_call(own_call_slot().component, what);
  if (const std::string changed = found(at_once); !changed.empty())
    throw ProcessChanged(std::string(what) + " changed " + changed + ", on which other code relies");
}

void CallAftermath::set_back() noexcept {
  try {
    ProcessWatch::changed();
  } catch (...) {  // no memory for the names of what was set back
  }
}

}  // namespace lacuna
