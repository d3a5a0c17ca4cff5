#include "foundation/recording_folder.h"

#include "foundation/files/allowed_files.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "metadata.yaml";

std::string_view without_spaces(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "- run_0.mcap", quoted or not; early versions of ROS 2 have the folder's name before the file's.
fs::path listed_file(std::string_view line) {
  std::string_view name = without_spaces(line.substr(1));
  if (name.size() >= 2 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front())
    name = name.substr(1, name.size() - 2);
  return fs::path(name).filename();
}

std::vector<fs::path> listed_files(const fs::path& folder) {
  check_may_read(folder / kMetadata);
  std::ifstream stream(folder / kMetadata);
  std::vector<fs::path> files;
  bool in_list = false;
  for (std::string line; std::getline(stream, line);) {
    const std::string_view text = without_spaces(line);
    if (in_list && !text.starts_with('-')) return files;
    if (in_list && !listed_file(text).empty()) files.push_back(folder / listed_file(text));
    in_list = in_list || text == "relative_file_paths:";
  }
  return files;
}

/// "run_9" before "run_10": where both have digits, the shorter run of digits is the smaller number.
bool comes_before(const std::string& a, const std::string& b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
  const auto digits = [&](const std::string& text) {
    std::size_t end = i;
    while (end < text.size() && is_digit(text[end])) ++end;
    return end - i;
  };
  const std::size_t of_a = digits(a), of_b = digits(b);
  const bool in_number = (of_a > 0 && of_b > 0) || (i > 0 && is_digit(a[i - 1]) && of_a + of_b > 0);
  return in_number && of_a != of_b ? of_a < of_b : a < b;
}

std::vector<fs::path> files_there(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure))
    if (entry.is_regular_file(failure) && entry.path().filename() != kMetadata) files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return comes_before(a.filename().string(), b.filename().string());
  });
  return files;
}

}  // namespace

bool is_recording_folder(const fs::path& path) {
  std::error_code failure;
  return fs::is_directory(path, failure) && fs::is_regular_file(path / kMetadata, failure);
}

std::vector<fs::path> files_of_recording(const fs::path& folder) {
  std::vector<fs::path> files = listed_files(folder);
  return files.empty() ? files_there(folder) : files;
}

fs::path without_last_slash(const fs::path& path) {
  return path.has_filename() || !path.has_parent_path() ? path : path.parent_path();
}

}  // namespace lacuna
