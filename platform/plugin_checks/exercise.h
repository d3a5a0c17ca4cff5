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
  long allocations = 0;  ///< a call, rounded up, once it has what it needs
  double seconds = 0.0;  ///< a call, the median
};

/// A component at work on inputs that are made here and are within what its interface promises it. Const: several
/// threads may exercise one component at once where its interface says that they share it. Whatever the component
/// throws goes through, `Error` included.
class Exercise {
 public:
  virtual ~Exercise() = default;

  /// At which values of the parameters it is exercised, the defaults first. By default these, each parameter at its
  /// bounds beside the others' defaults, and all in the middle.
  virtual std::vector<Setting> settings() const { return settings_of(declared()); }
  virtual ParameterDeclarations declared() const = 0;
  /// Calls the component and writes down what it gives.
  virtual void go(const Setting& setting, Transcript& transcript) const = 0;
  /// Whether the same calls give the same numbers; a target need not.
  virtual bool promises_same_numbers() const { return true; }
  /// What its interface promises and the component does not keep: a sentence each, with what to do.
  virtual std::vector<std::string> broken_promises() const { return {}; }
  /// What the calls that are repeated cost, at the defaults. In a process that counts allocations.
  virtual std::vector<RepeatedCall> repeated_calls() const { return {}; }
  /// Why there is little to see, and what to do about it; empty: it is seen at work.
  virtual std::string reservation() const { return {}; }

  static std::vector<Setting> settings_of(const ParameterDeclarations& declared);
};

/// What an exercise is given besides the component.
struct ExerciseInputs {
  std::filesystem::path sample;   ///< a file of the format that it reads; empty: none
  std::filesystem::path scratch;  ///< a folder for files that a format is given
  bool carries_out = false;       ///< whether a target carries a test out, by which a rig would move
};

/// Times `call`, which must not throw, in batches of `at_once`; each batch begins with `before`.
RepeatedCall repeated_call(
    const char* name, bool may_allocate, int at_once, const std::function<void()>& call,
    const std::function<void()>& before = [] {});

}  // namespace lacuna
