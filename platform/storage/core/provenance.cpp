#include "storage/core/provenance.h"

#include "storage/core/source_revision.h"

#include <Eigen/Core>
#include <sqlite3.h>
#include <sys/utsname.h>

#include <fstream>

namespace lacuna {
namespace {

std::string processor_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
    if (start != std::string::npos) return line.substr(start);
  }
  return "unknown";
}

std::string kernel_and_machine() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.machine;
}

std::string eigen_version() {
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace

Provenance provenance_of_this_program() {
  return {.program = LACUNA_VERSION,
          .source_revision = LACUNA_SOURCE_REVISION,
          .compiler = compiler(),
          .build_type = LACUNA_BUILD_TYPE,
          .ode = LACUNA_ODE_VERSION,
          .sqlite = sqlite3_libversion(),
          .eigen = eigen_version(),
          .processor = processor_model(),
          .system = kernel_and_machine()};
}

}  // namespace lacuna
