#include "foundation/files/special_file.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr double kReaderComes = 3.0;  // s, as where a shell starts both at once
constexpr double kLook = 0.05;        // s

}  // namespace

std::string special_file(const fs::path& file) {
  std::error_code unknown;
  switch (fs::status(file, unknown).type()) {
    case fs::file_type::fifo: return "a pipe";
    case fs::file_type::socket: return "a socket";
    case fs::file_type::character: return "a device";
    case fs::file_type::block: return "a disk";
    default: return {};
  }
}

bool is_unnamed_pipe(const fs::path& file) {
  struct statfs system {};
  return ::statfs(file.c_str(), &system) == 0 && system.f_type == PIPEFS_MAGIC;
}

std::string why_no_regular_file(const fs::path& file) {
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (fs::is_regular_file(status)) return {};
  if (fs::is_directory(status)) return "is a folder, not a file";
  if (const std::string special = special_file(file); !special.empty()) return "is " + special + ", not a regular file";
  if (failure && status.type() != fs::file_type::not_found) return "cannot be read: " + failure.message();
  return "no such file";
}

int open_pipe_to_reader(const fs::path& file, const Stop& stop) {
  int pipe = -1;
  for (double waited = 0.0; waited <= kReaderComes; waited += kLook) {
    pipe = ::open(file.c_str(), O_WRONLY | O_APPEND | O_NONBLOCK | O_CLOEXEC);
    if (pipe >= 0 || errno != ENXIO) break;
    stop.pause_for(kLook);
    errno = ENXIO;
  }
  if (pipe >= 0) ::fcntl(pipe, F_SETFL, ::fcntl(pipe, F_GETFL) & ~O_NONBLOCK);
  return pipe;
}

}  // namespace lacuna
