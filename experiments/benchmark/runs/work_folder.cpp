#include "runs/work_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace hidden_effects {

WorkFolder::WorkFolder(std::filesystem::path path) : path_(std::move(path)) {
  make_folder(path_);
  descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  if (descriptor_ >= 0) close(descriptor_);
  throw std::invalid_argument(
      path_.string() + (reason == EWOULDBLOCK ? ": another run is at work in this folder; name another one with --work"
                                              : std::string(": cannot be used: ") + std::strerror(reason)));
}

WorkFolder::~WorkFolder() { close(descriptor_); }

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::invalid_argument(path.string() + ": this folder cannot be made: " + error.message());
  if (!std::filesystem::is_directory(path)) throw std::invalid_argument(path.string() + ": is no folder");
}

}  // namespace hidden_effects
