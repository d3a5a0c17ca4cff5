#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>

/// In place of the C library's rename(2) (LD_PRELOAD): kills the process before or after an experiment file gets its
/// new text, as LACUNA_KILL says.
extern "C" int rename(const char* from, const char* to) noexcept {
  const char* chosen = std::getenv("LACUNA_KILL");
  const std::string_view when = chosen != nullptr && std::string_view(to).ends_with(".toml") ? chosen : "";
  if (when == "before") kill(getpid(), SIGKILL);
  const int result = renameat(AT_FDCWD, from, AT_FDCWD, to);
  if (when == "after") kill(getpid(), SIGKILL);
  return result;
}
