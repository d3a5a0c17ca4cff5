#pragma once

#include <filesystem>

namespace lacuna {

/// A new folder in the system's place for such, which other users cannot read and which is removed with the object.
/// What killed processes of this machine have left is removed by a later one, a day after.
class ScratchFolder {
 public:
  /// Throws `Error` where none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const char* name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  /// It stays, under another name (`keep_scratch`).
  void keep();

 private:
  std::filesystem::path path_;
  int lock_ = -1;
  bool kept_ = false;
};

/// Gives such a folder, of this process or of another one that has ended, a name under which it stays for a user to
/// look after. Returns that; where it cannot be had, the old one.
std::filesystem::path keep_scratch(const std::filesystem::path& folder);

}  // namespace lacuna
