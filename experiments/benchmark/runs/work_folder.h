#pragma once

#include <filesystem>

namespace hidden_effects {

/// A folder for the files of cases under way, which one process has to itself: cases of the same number, of another
/// version for instance, would take each other's files. Throws `std::invalid_argument` where another process has it, or
/// where it is no folder.
class WorkFolder {
 public:
  explicit WorkFolder(std::filesystem::path path);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;  ///< of the folder itself, locked
};

/// Makes a folder and those above it. Throws `std::invalid_argument` where that cannot be.
void make_folder(const std::filesystem::path& path);

}  // namespace hidden_effects
