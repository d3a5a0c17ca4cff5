#include "plugin_checks/exercise.h"

#include "foundation/plugins/plugin_call.h"
#include "loading/allocation_count.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kBatches = 31;
constexpr double kMostSeconds = 0.5;  // for all batches

double middle_of(const ParameterDeclaration& parameter) {
  const double middle = parameter.scale == Scale::logarithmic && parameter.lower > 0.0
                            ? std::sqrt(parameter.lower * parameter.upper)
                            : 0.5 * (parameter.lower + parameter.upper);
  return std::clamp(middle, parameter.lower, parameter.upper);
}

}  // namespace

std::vector<Setting> Exercise::settings_of(const ParameterDeclarations& declared) {
  Setting defaults, middle;
  for (const ParameterDeclaration& parameter : declared) {
    defaults.push_back(parameter.default_value);
    middle.push_back(middle_of(parameter));
  }
  std::vector<Setting> all = {defaults};
  for (std::size_t i = 0; i < declared.size(); ++i)
    for (const double bound : {declared[i].lower, declared[i].upper}) {
      Setting setting = defaults;
      setting[i] = bound;
      all.push_back(setting);
    }
  if (!declared.empty()) all.push_back(middle);
  return all;
}

RepeatedCall repeated_call(const char* name, bool may_allocate, int at_once, const std::function<void()>& call,
                           const std::function<void()>& before) {
  using Clock = std::chrono::steady_clock;
  const PluginCall active(own_call_slot().component, name);
  const auto batch = [&] {
    for (int i = 0; i < at_once; ++i) call();
  };
  before();
  batch();
  before();
  const long counted = allocations_of_this_thread();
  batch();
  const long allocated = allocations_of_this_thread() - counted;
  std::vector<double> seconds;
  double all = 0.0;
  while (seconds.size() < kBatches && (all < kMostSeconds || seconds.empty())) {
    before();
    const auto start = Clock::now();
    batch();
    const double took = std::chrono::duration<double>(Clock::now() - start).count();
    all += took;
    seconds.push_back(took / at_once);
  }
  std::sort(seconds.begin(), seconds.end());
  return {name, may_allocate, (allocated + at_once - 1) / at_once, seconds[seconds.size() / 2]};
}

}  // namespace lacuna
