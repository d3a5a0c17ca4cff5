#include "foundation/processes/guarded_call.h"

#include "foundation/plugins/plugin_fault.h"
#include "foundation/processes/process_limits.h"

#include <cxxabi.h>

#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <typeinfo>

namespace lacuna {
namespace {

std::string type_name(const std::type_info* type) {
  if (type == nullptr) return "unknown type";
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(type->name(), nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 ? name.get() : type->name();
}

std::string fault(std::string_view what, const std::string& thrown) {
  return std::string(what) + " threw " + thrown + std::string(kFaultOfPlugin);
}

/// The text of a plugin's exception; this calls the plugin's code again.
std::string words_of(const std::exception& error) {
  try {
    const char* const words = error.what();
    return words == nullptr ? "without a text" : words;
  } catch (...) {
    return "whose what() throws";
  }
}

/// A plugin that ends its calling thread (`pthread_exit`) reaches no `catch`: without an end here the program would
/// wait for that thread for ever, or end as if its work were done.
[[noreturn]] void end_with_thread(std::string_view what) {
  const char* const component = own_call_slot().component;
  const PluginCall call(component, component_on_page(std::string(what) + " ended its thread (pthread_exit), which"));
  std::abort();
}

/// Without the component.
std::string reason_of_current_exception(std::string_view what) {
  try {
    throw;
  } catch (const abi::__forced_unwind&) {
    end_with_thread(what);
  } catch (const Error& error) {
    return words_of(error);
  } catch (const std::bad_alloc&) {
    return std::string(what) + " ran out of memory: " + no_memory_sentence() +
           "; if the plugin takes all of it, repair the plugin";
  } catch (const std::exception& error) {
    return fault(what, type_name(&typeid(error)) + " (" + words_of(error) + ")");
  } catch (...) {
    return fault(what, "an object of type " + type_name(abi::__cxa_current_exception_type()));
  }
}

}  // namespace

std::string to_string(const ComponentOrigin& origin) {
  const std::string name = origin.kind + " \"" + origin.name + "\"";
  return origin.file.empty() ? name : name + " (" + origin.file.string() + ")";
}

const char* on_page(const ComponentOrigin& origin) {
  return origin.on_page != nullptr ? origin.on_page : component_on_page(to_string(origin));
}

std::string describe_current_exception(const ComponentOrigin& origin, std::string_view what) {
  return to_string(origin) + ": " + reason_of_current_exception(what);
}

void throw_component_error(const ComponentOrigin& origin, std::string_view what) {
  try {
    throw;
  } catch (const abi::__forced_unwind&) {
    end_with_thread(what);
  } catch (const ProcessChanged& change) {
    throw ComponentChangedProcess(origin, change);
  } catch (...) {
    throw ComponentError(origin, reason_of_current_exception(what));
  }
}

std::string reason_of(const Error& error) {
  if (const auto* of_component = dynamic_cast<const ComponentError*>(&error)) return of_component->reason();
  if (const auto* input = dynamic_cast<const BadInput*>(&error); input != nullptr && !input->problems().empty()) {
    const Problem& first = input->problems().front();
    return first.reason.empty() ? first.message : first.reason;
  }
  return error.what();
}

}  // namespace lacuna
