#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lacuna {

enum class CheckOutcome {
  passed,
  failed,
  not_applicable  ///< there is nothing to be checked of such a component
};

/// What one check of a plugin or a component of it told.
struct CheckResult {
  std::string check;  ///< "determinism"
  CheckOutcome outcome = CheckOutcome::passed;
  std::string finding;  ///< what was found, a clause: figures, or what is wrong
  std::string why;      ///< of a failure: why it matters, a sentence
  std::string remedy;   ///< of a failure: what to do, a sentence
  /// What repeated calls cost.
  struct Figure {
    std::string call;
    long allocations = 0;      ///< a call
    double nanoseconds = 0.0;  ///< a call, the median
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
/// The way back. Throws `Error` for another document.
CheckResult check_result_of(const std::string& json);

/// A table, and below each failure why it matters and what to do.
std::string text_of(const PluginChecks& checks);

}  // namespace lacuna
