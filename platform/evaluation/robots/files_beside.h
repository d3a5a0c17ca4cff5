#pragma once

#include <lacuna/robot_format.h>

#include <filesystem>
#include <map>
#include <vector>

namespace lacuna {

/// The files in the folder of a robot file and below it, for formats that use several files. Nothing for a path that is
/// absolute or leads out of the folder, by ".." or by a link; nor for a file that cannot be read, is longer than 4 MiB,
/// or comes after 1000 others.
class FolderOfRobot : public FilesBeside {
 public:
  explicit FolderOfRobot(const std::filesystem::path& robot_file);

  std::optional<std::string> text_of(const std::string& path) const override;

  /// Those that were read, with their texts.
  const std::map<std::filesystem::path, std::string>& read_files() const { return read_; }

 private:
  std::filesystem::path folder_;            ///< as the user names it
  std::filesystem::path canonical_folder_;  ///< without links
  mutable std::map<std::filesystem::path, std::string> read_;
};

}  // namespace lacuna
