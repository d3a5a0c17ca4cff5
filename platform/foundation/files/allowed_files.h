#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// The variable that `lacuna mcp` sets for the commands that it runs: the folders in which they may read and write, one
/// per line. Unset or empty: anywhere.
inline constexpr const char* kAllowedFolders = "LACUNA_ALLOWED_FOLDERS";

/// The folders in which a command may read and write, plus the program's own files, which it may read.
class AllowedFiles {
 public:
  /// `folders`: without links, absolute; none: anywhere.
  explicit AllowedFiles(std::vector<std::filesystem::path> folders);
  /// From the variable.
  static AllowedFiles of_this_process();

  bool are_limited() const { return !folders_.empty(); }
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// Additional files that the program reads: its plugins and its data, and the folders of LACUNA_PLUGIN_PATH.
  static std::vector<std::filesystem::path> of_the_program();

  /// Why a file, which need not exist yet, may not be read or written, as a clause that follows its name; empty: it
  /// may. Links, `.` and `..` are followed first.
  std::string why_not_read(const std::filesystem::path& file) const;
  std::string why_not_written(const std::filesystem::path& file) const;

 private:
  std::string refusal(const std::filesystem::path& file, const std::vector<std::filesystem::path>& besides) const;

  std::vector<std::filesystem::path> folders_;
};

/// `AllowedFiles::why_not_read` of this process.
std::string why_may_not_read(const std::filesystem::path& file);
/// Called where this process opens a file that a user or another file names: throws `BadInput` with the file's name
/// where it may not.
void check_may_read(const std::filesystem::path& file);
void check_may_write(const std::filesystem::path& file);

/// Whether this process works for an agent, which may name files in certain folders only.
bool files_are_limited();

}  // namespace lacuna
