#include "evaluation/robots/files_beside.h"

#include "config/toml/text_file.h"
#include "foundation/text/problem.h"

#include <algorithm>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;

bool lies_below(const fs::path& file, const fs::path& folder) {
  const auto [end_of_folder, ignored] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end_of_folder == folder.end();
}

}  // namespace

FolderOfRobot::FolderOfRobot(const fs::path& robot_file) : folder_(robot_file.parent_path()) {
  std::error_code error;
  canonical_folder_ = fs::canonical(folder_.empty() ? fs::path(".") : folder_, error);
}

std::optional<std::string> FolderOfRobot::text_of(const std::string& path) const {
  if (canonical_folder_.empty() || path.empty() || path.find('\0') != std::string::npos) return std::nullopt;
  std::error_code error;
  const fs::path file = fs::canonical(canonical_folder_ / path, error);
  if (error || !lies_below(file, canonical_folder_) || !fs::is_regular_file(file, error)) return std::nullopt;
  const fs::path named = folder_ / fs::relative(file, canonical_folder_, error);
  if (const auto known = read_.find(named); known != read_.end()) return known->second;
  if (read_.size() >= kMostFiles) return std::nullopt;
  try {
    return read_.emplace(named, read_text_file(file)).first->second;
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

}  // namespace lacuna
