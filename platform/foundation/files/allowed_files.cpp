#include "foundation/files/allowed_files.h"

#include "foundation/text/problem.h"
#include "foundation/files/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> paths_in(const char* variable, char separator) {
  std::vector<fs::path> paths;
  const char* text = std::getenv(variable);
  std::istringstream list(text == nullptr ? "" : text);
  for (std::string path; std::getline(list, path, separator);)
    if (!path.empty()) paths.emplace_back(path);
  return paths;
}

/// Both without links.
bool lies_in(const fs::path& place, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), place.begin(), place.end()).first == folder.end();
}

bool lies_in_one_of(const fs::path& place, const std::vector<fs::path>& folders) {
  return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) { return lies_in(place, folder); });
}

const AllowedFiles& of_now() {
  static const AllowedFiles files = AllowedFiles::of_this_process();
  return files;
}

}  // namespace

AllowedFiles::AllowedFiles(std::vector<fs::path> folders) : folders_(std::move(folders)) {}

AllowedFiles AllowedFiles::of_this_process() { return AllowedFiles(paths_in(kAllowedFolders, '\n')); }

std::vector<fs::path> AllowedFiles::of_the_program() {
  std::vector<fs::path> folders;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  if (!unknown)
    for (const char* part : {"lib/lacuna", "share/lacuna"})
      folders.push_back(place_of(program.parent_path().parent_path() / part));
  for (const fs::path& folder : paths_in("LACUNA_PLUGIN_PATH", ':')) folders.push_back(place_of(folder));
  return folders;
}

std::string AllowedFiles::refusal(const fs::path& file, const std::vector<fs::path>& besides) const {
  const fs::path place = place_of(file);
  if (!are_limited() || lies_in_one_of(place, folders_) || lies_in_one_of(place, besides)) return {};
  return fmt::format("lies outside {}, the folder in which lacuna mcp was started; name a file in this folder",
                     folders_.front().string());
}

std::string AllowedFiles::why_not_read(const fs::path& file) const {
  return are_limited() ? refusal(file, of_the_program()) : std::string();
}

std::string AllowedFiles::why_not_written(const fs::path& file) const {
  return are_limited() ? refusal(file, {}) : std::string();
}

std::string why_may_not_read(const fs::path& file) { return of_now().why_not_read(file); }

void check_may_read(const fs::path& file) {
  if (std::string why = why_may_not_read(file); !why.empty()) throw_problem({file.string()}, std::move(why));
}

void check_may_write(const fs::path& file) {
  if (std::string why = of_now().why_not_written(file); !why.empty()) throw_problem({file.string()}, std::move(why));
}

bool files_are_limited() { return of_now().are_limited(); }

}  // namespace lacuna
