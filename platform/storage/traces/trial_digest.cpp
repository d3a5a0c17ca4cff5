#include "storage/core/canonical_text.h"

#include "foundation/digest.h"
#include "storage/traces/trace_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lacuna {
namespace {

/// Bytes of numbers, any NaN as one NaN.
class NumberBytes {
 public:
  void add(double value) {
    const double one = std::isnan(value) ? kNotKnown : value;
    char bytes[sizeof one];
    std::memcpy(bytes, &one, sizeof one);
    text_.append(bytes, sizeof one);
  }
  void add(const std::vector<double>& values) {
    add(static_cast<double>(values.size()));
    for (const double value : values) add(value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

std::string digest_of(const Trial& trial) {
  NumberBytes rest;
  rest.add(static_cast<double>(trial.commands.hold));
  for (const InitialValue& initial : trial.initial) {
    rest.add(static_cast<double>(initial.knowledge));
    rest.add(initial.position);
    rest.add(initial.velocity);
  }
  rest.add(trial.sensor_noise);
  rest.add(trial.command_noise);
  // Where it is not known it adds nothing, so that digests of trials from before it could be stated stay.
  if (std::any_of(trial.commands.before.begin(), trial.commands.before.end(), [](double v) { return !std::isnan(v); }))
    rest.add(trial.commands.before);
  std::string setup;  // a missing one adds nothing
  if (!trial.setup.name.empty()) setup = '\n' + trial.setup.name;
  for (const Setup::Value& value : trial.setup.values) {
    setup += '\n' + value.address;
    rest.add(value.value);
  }
  if (trial.closed_loop && trial.controller) setup += "\nclosed loop " + trial.controller->identity();
  return sha256(encode_trace(trial.commands.series, TracePrecision::float64).digest + '\n' +
                encode_trace(trial.measured, TracePrecision::float64).digest + '\n' + rest.text() + setup);
}

std::string digest_of_trials(std::span<const Trial> trials) {
  std::string digests;
  for (const Trial& trial : trials) {
    if (!trial.held_out) digests += digest_of(trial) + '\n';
  }
  return sha256(digests);
}

}  // namespace lacuna
