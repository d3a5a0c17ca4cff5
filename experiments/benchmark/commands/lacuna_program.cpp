#include "commands/lacuna_program.h"

#include "foundation/digest.h"
#include "foundation/processes/interrupt.h"

#include <fmt/format.h>

#include <stdexcept>

namespace hidden_effects {

namespace fs = std::filesystem;

ProgramSettings program_settings(const fs::path& program, int longest) {
  const fs::path file =
      program.empty() ? fs::read_symlink("/proc/self/exe").parent_path() / "lacuna" : fs::absolute(program);
  if (!fs::exists(file))
    throw std::invalid_argument(fmt::format("there is no program {}; name it with --lacuna", file.string()));
  ProgramSettings settings;
  settings.lacuna = file;
  settings.longest = longest;
  settings.stop = [stop = lacuna::when_interrupted()] { return stop.is_due(); };
  return settings;
}

std::string identity_of(const ProgramSettings& settings, const fs::path& folder) {
  const std::string version = program_version(settings, folder);
  if (version.empty() || version.find_first_not_of("0123456789.") != std::string::npos)
    throw std::invalid_argument(
        fmt::format("--lacuna {}: is not lacuna, whose --version is a number", settings.lacuna.string()));
  return fmt::format("{}, {:.16}", version, lacuna::sha256_of_file(settings.lacuna));
}

}  // namespace hidden_effects
