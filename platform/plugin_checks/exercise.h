#pragma once

#include "plugin_checks/transcript.h"

#include <lacuna/parameter.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// Values of a component's parameters, in their order.
using Setting = std::vector<double>;

/// A call that a simulation, a fit or a search repeats.
struct RepeatedCall {
  const char* name;  ///< a literal, as in "add_loads"
  bool may_allocate = false;
  long allocations = 0;  ///< per call, rounded up, after the first calls
  double seconds = 0.0;  ///< per call, the median
};

/// A component at work on inputs within the rules of its interface. Const: several threads may exercise one component
/// at once where its interface allows sharing. All exceptions of the component pass through, including `Error`.
class Exercise {
 public:
  virtual ~Exercise() = default;

  /// The parameter values for the exercise, the defaults first. By default these, each parameter at its bounds with the
  /// others at their defaults, and all in the middle.
  virtual std::vector<Setting> settings() const { return settings_of(declared()); }
  virtual ParameterDeclarations declared() const = 0;
  /// Calls the component and records its results.
  virtual void go(const Setting& setting, Transcript& transcript) const = 0;
  /// Whether the same calls must give the same numbers; a target need not.
  virtual bool promises_same_numbers() const { return true; }
  /// Rules of the interface that the component breaks: one sentence each, with what to do.
  virtual std::vector<std::string> broken_promises() const { return {}; }
  /// Cost of the repeated calls, at the defaults. Needs a process that counts allocations.
  virtual std::vector<RepeatedCall> repeated_calls() const { return {}; }
  /// Why little can be checked, and what to do about it; empty: the exercise is complete.
  virtual std::string reservation() const { return {}; }

  static std::vector<Setting> settings_of(const ParameterDeclarations& declared);
};

/// The input of an exercise besides the component.
struct ExerciseInputs {
  std::filesystem::path sample;   ///< a file of the format that it reads; empty: none
  std::filesystem::path scratch;  ///< a folder for files of a format
  bool carries_out = false;       ///< whether a target may carry out a test, which would move a rig
};

/// Times `call`, which must not throw, in batches of `at_once`; each batch begins with `before`.
RepeatedCall repeated_call(
    const char* name, bool may_allocate, int at_once, const std::function<void()>& call,
    const std::function<void()>& before = [] {});

}  // namespace lacuna
