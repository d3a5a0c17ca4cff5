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

std::string fault(const ComponentOrigin& origin, std::string_view what, const std::string& thrown) {
  return to_string(origin) + ": " + std::string(what) + " threw " + thrown +
         "; that is a fault of the plugin: repair it, or do without this component";
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
  try {
    throw;
  } catch (const Error& error) {
    return to_string(origin) + ": " + error.what();
  } catch (const std::exception& error) {
    return fault(origin, what, type_name(&typeid(error)) + " (" + error.what() + ")");
  } catch (...) {
    return fault(origin, what, "an object of type " + type_name(abi::__cxa_current_exception_type()));
  }
}

}  // namespace lacuna
