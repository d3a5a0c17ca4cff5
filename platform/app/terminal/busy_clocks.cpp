#include "app/terminal/busy_clocks.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

namespace lacuna {
namespace {

constexpr double kShortCall = 10.0;  // s

/// Calls that describe a component or change a few numbers.
constexpr std::array<std::string_view, 11> kShortCalls = {"describe",
                                                          "stages",
                                                          "summary",
                                                          "its summary",
                                                          "parameters",
                                                          "its factory",
                                                          "amend",
                                                          "reset",
                                                          "state_size",
                                                          "lacuna_plugin",
                                                          "its code that runs on loading"};

/// How long a call may take that is in no evaluation, s; 0: as long as it likes.
double limit_of_call(const BusyThread& thread, const ActiveCall& call) {
  if (std::find(kShortCalls.begin(), kShortCalls.end(), call.call) != kShortCalls.end())
    return kShortCall + thread.slot->allowance;
  const double limit = CallPage::evaluation_limit();
  return limit > 0.0 ? std::max(limit, kShortCall) + thread.slot->allowance : 0.0;
}

}  // namespace

double BusyClocks::seconds(const CallSlot& slot, std::uint32_t count, Clock::time_point now) {
  Look& look = looks_.try_emplace(&slot, Look{count, now}).first->second;
  if (look.count != count) look = {count, now};
  look.is_new = true;
  return std::chrono::duration<double>(now - look.since).count();
}

void BusyClocks::end_look() {
  for (auto look = looks_.begin(); look != looks_.end();)
    look = std::exchange(look->second.is_new, false) ? std::next(look) : looks_.erase(look);
}

const CallSlot* EvaluationClocks::overdue(double limit) {
  const BusyClocks::Clock::time_point now = BusyClocks::Clock::now();
  const CallSlot* found = nullptr;
  for (const BusyThread& thread : CallPage::busy())
    if (thread.evaluates && clocks_.seconds(*thread.slot, thread.ticks, now) > limit) found = thread.slot;
  clocks_.end_look();
  return found;
}

std::optional<SlowCall> CallClocks::overdue() {
  const BusyClocks::Clock::time_point now = BusyClocks::Clock::now();
  std::optional<SlowCall> found;
  for (const BusyThread& thread : CallPage::busy()) {
    if (thread.evaluates) continue;
    ActiveCall call = CallPage::call_of(*thread.slot);
    if (call.component.empty()) continue;
    const double limit = limit_of_call(thread, call);
    if (clocks_.seconds(*thread.slot, thread.calls, now) > limit && limit > 0.0)
      found = SlowCall{std::move(call), limit};
  }
  clocks_.end_look();
  return found;
}

}  // namespace lacuna
