#pragma once

#include "foundation/processes/stop.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/text/problem.h"
#include "foundation/processes/process_watch.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace lacuna {

/// A component of a plugin, as named in messages.
struct ComponentOrigin {
  std::string kind;               ///< "effect", "robot", "metric", "target"
  std::string name;               ///< the plugin's
  std::filesystem::path file;     ///< empty: built into the program
  const char* on_page = nullptr;  ///< text for a parent process (foundation/plugins/plugin_call.h); null: not set yet
};

/// `effect "coulomb_friction" (/usr/lib/lacuna/plugins/coulomb_friction.so)`.
std::string to_string(const ComponentOrigin& origin);

/// The same for a parent process.
const char* on_page(const ComponentOrigin& origin);

/// A sentence about the current exception, whatever its type, as thrown by `origin` in the call `what` ("add_loads").
/// Only inside a `catch` block. For callers that must not throw, such as an engine in the middle of a run.
std::string describe_current_exception(const ComponentOrigin& origin, std::string_view what);

/// An exception of a component: its text names the component and its file, `reason` does not.
class ComponentError : public Error {
 public:
  ComponentError(const ComponentOrigin& origin, const std::string& reason)
      : Error(to_string(origin) + ": " + reason), reason_(reason) {}
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// The same for a component whose call changed the process. `deed` as in `ProcessChanged`.
class ComponentChangedProcess : public ComponentError {
 public:
  ComponentChangedProcess(const ComponentOrigin& origin, const ProcessChanged& change)
      : ComponentError(origin, change.what()), deed_(change.deed()) {}
  const std::string& deed() const { return deed_; }

 private:
  std::string deed_;
};

/// The current exception as `ComponentError`. Only inside a `catch` block.
[[noreturn]] void throw_component_error(const ComponentOrigin& origin, std::string_view what);

/// The fault without the place in a file, the key and the component, for messages that already name these. Of several
/// problems the first.
std::string reason_of(const Error& error);

/// Calls plugin code, and informs a parent process (foundation/plugins/plugin_call.h); `what` is a literal. Any
/// exception, including foreign types, becomes a `ComponentError` that names component, file and what to do; so does a
/// change of the process (foundation/processes/process_watch.h). `BadInput` and `Interrupted` come from the host's own
/// services and pass unchanged.
template <class Call>
decltype(auto) guarded_call(const ComponentOrigin& origin, const char* what, Call&& call) {
  const PluginCall active(on_page(origin), what);
  CallAftermath aftermath(what);
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<Call>>) {
      std::forward<Call>(call)();
      aftermath.check();
    } else {
      decltype(auto) result = std::forward<Call>(call)();
      aftermath.check();
      return result;
    }
  } catch (const BadInput&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (...) {
    throw_component_error(origin, what);
  }
}

}  // namespace lacuna
