#pragma once

#include "foundation/interrupt.h"
#include "foundation/plugin_call.h"
#include "foundation/problem.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace lacuna {

/// A component of a plugin, as messages name it.
struct ComponentOrigin {
  std::string kind;               ///< "effect", "robot", "metric", "target"
  std::string name;               ///< the plugin's
  std::filesystem::path file;     ///< empty: part of the program
  const char* on_page = nullptr;  ///< where a parent process reads it (foundation/plugin_call.h); null: not yet there
};

/// `effect "coulomb_friction" (/usr/lib/lacuna/plugins/coulomb_friction.so)`.
std::string to_string(const ComponentOrigin& origin);

/// The same for a parent process.
const char* on_page(const ComponentOrigin& origin);

/// A sentence about the exception that is being handled, whatever its type, as thrown by `origin`
/// while it did `what` ("add_loads"). Only inside a `catch` block. For callers that must not throw,
/// such as an engine in the middle of a run.
std::string describe_current_exception(const ComponentOrigin& origin, std::string_view what);

/// Calls into plugin code, and lets a parent process know (foundation/plugin_call.h); `what` is a literal. Whatever
/// leaves it, foreign types included, becomes an `Error` that names component, file and what to do. `BadInput` and
/// `Interrupted` come from the host's own services and pass unchanged.
template <class Call>
decltype(auto) guarded_call(const ComponentOrigin& origin, const char* what, Call&& call) {
  const PluginCall active(on_page(origin), what);
  try {
    return std::forward<Call>(call)();
  } catch (const BadInput&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (...) {
    throw Error(describe_current_exception(origin, what));
  }
}

}  // namespace lacuna
