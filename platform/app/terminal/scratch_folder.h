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
  const std::filesystem::path& path() const { return path_; }
  /// It stays, for a user to look after.
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

}  // namespace lacuna
