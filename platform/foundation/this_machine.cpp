#include "foundation/this_machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdint>
#include <functional>
#include <string_view>

namespace lacuna {

const std::string& digits_of_this_machine() {
  static const std::string digits = [] {
    utsname names{};
    uname(&names);
    return fmt::format("{:08x}", static_cast<std::uint32_t>(std::hash<std::string_view>()(names.nodename)));
  }();
  return digits;
}

}  // namespace lacuna
