#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lacuna {

enum class CheckOutcome {
  passed,
  failed,
  not_applicable  ///< the check does not apply to such a component
};

/// The result of one check of a plugin or a component.
struct CheckResult {
  std::string check;  ///< "determinism"
  CheckOutcome outcome = CheckOutcome::passed;
  std::string finding;  ///< the finding, a clause: numbers, or the fault
  std::string why;      ///< for a failure: why it matters, a sentence
  std::string remedy;   ///< for a failure: what to do, a sentence
  /// The cost of repeated calls.
  struct Figure {
    std::string call;
    long allocations = 0;      ///< a call
    double nanoseconds = 0.0;  ///< per call, the median
  };
  std::vector<Figure> figures = {};
};

/// The checks of a component.
struct ComponentChecks {
  std::string kind;  ///< "effect"
  std::string name;
  std::vector<CheckResult> checks;

  bool passed() const;
};

/// The checks of a plugin library.
struct PluginChecks {
  std::string file;
  CheckResult handshake;
  std::vector<ComponentChecks> components;  ///< none where the handshake failed

  bool passed() const;
};

nlohmann::ordered_json json_of(const CheckResult& result);
nlohmann::ordered_json json_of(const PluginChecks& checks);
/// The inverse. Throws `Error` for another document.
CheckResult check_result_of(const std::string& json);

/// A table, and below each failure why it matters and what to do.
std::string text_of(const PluginChecks& checks);

}  // namespace lacuna
