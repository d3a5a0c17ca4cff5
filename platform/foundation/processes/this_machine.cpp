#include "foundation/processes/this_machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string_view>

namespace lacuna {
namespace {

std::string digits_of(std::string_view name) {
  return fmt::format("{:08x}", static_cast<std::uint32_t>(std::hash<std::string_view>()(name)));
}

}  // namespace

const std::string& digits_of_this_machine() {
  static const std::string digits = [] {
    utsname names{};
    uname(&names);
    return digits_of(names.nodename);
  }();
  return digits;
}

const std::string& digits_of_this_start() {
  static const std::string digits = [] {
    std::string start;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> start;
    std::error_code unknown;
    const std::string space = std::filesystem::read_symlink("/proc/self/ns/pid", unknown).string();
    return start.empty() || space.empty() ? "" : digits_of(start + space);
  }();
  return digits;
}

}  // namespace lacuna
