#pragma once

#include <filesystem>

namespace lacuna {

/// A new folder in the system's place for such, which nobody else can look into and which ends with the object.
class ScratchFolder {
 public:
  /// Throws `Error` where none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace lacuna
