#include "foundation/guarded_call.h"

#include <cxxabi.h>

#include <cstdlib>
#include <exception>
#include <memory>
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
  return std::string(what) + " threw " + thrown +
         "; that is a fault of the plugin: repair it, or do without this component";
}

/// Without the component.
std::string reason_of_current_exception(std::string_view what) {
  try {
    throw;
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception& error) {
    return fault(what, type_name(&typeid(error)) + " (" + error.what() + ")");
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
  throw ComponentError(origin, reason_of_current_exception(what));
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
