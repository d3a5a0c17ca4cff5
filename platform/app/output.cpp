#include "app/output.h"

#include "app/plain_streams.h"
#include "foundation/problem.h"
#include "foundation/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& place, const std::string& message) {
  throw_problem({place.string(), 0, 0}, message);
}

/// Of this command.
std::vector<fs::path>& checked_outputs() {
  static std::vector<fs::path> files;
  return files;
}

bool are_one_file(const fs::path& a, const fs::path& b) {
  std::error_code missing;
  return fs::equivalent(a, b, missing) || fs::weakly_canonical(a, missing) == fs::weakly_canonical(b, missing);
}

void check_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) refuse(file, "is a folder; name a file for the results");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) refuse(file, "cannot be written: there is no folder " + folder.string());
  if (const auto why = why_not_writable(file)) refuse(file, "cannot be written: " + *why);
}

/// The folder itself, or else the one in which it, or what it lies in, would be made.
fs::path first_there(fs::path folder) {
  std::error_code ignored;
  while (!folder.empty() && !fs::exists(fs::symlink_status(folder, ignored))) folder = folder.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

void write_output(const std::string& to, const std::string& text) {
  if (to.empty()) {
    exact_output() << text << std::flush;
    return;
  }
  write_whole(to, text, Link::followed);
}

bool takes_standard_output(const std::optional<std::string>& option) { return option && option->empty(); }

void check_output(const std::optional<std::string>& option, const std::optional<std::string>& other) {
  if (takes_standard_output(option) && takes_standard_output(other))
    throw_problem({}, "--json and --csv cannot both go to standard output; give one of them a file");
  if (option && other && !option->empty() &&
      fs::path(*option).lexically_normal() == fs::path(*other).lexically_normal())
    refuse(*option, "is named by two options; give each its own file");
  for (const std::optional<std::string>& file : {option, other}) {
    if (!file || file->empty()) continue;
    check_file(*file);
    checked_outputs().emplace_back(*file);
  }
}

void forget_outputs() { checked_outputs().clear(); }

void refuse_outputs_among(const std::vector<fs::path>& inputs) {
  for (const fs::path& output : checked_outputs())
    for (const fs::path& input : inputs)
      if (are_one_file(output, input))
        refuse(output, input == output
                           ? "is read by this command; give the results another file"
                           : "is " + input.string() + ", which this command reads; give the results another file");
}

void check_output_folder(const fs::path& folder) {
  if (folder.empty()) return;
  const fs::path place = first_there(folder);
  std::error_code failure;
  if (!fs::is_directory(place, failure))
    refuse(folder, "cannot be a folder for results: " + std::string(std::strerror(ENOTDIR)));
  if (::access(place.c_str(), W_OK) != 0)
    refuse(folder, std::string("cannot be written into: ") + std::strerror(errno));
}

void make_output_folder(const fs::path& folder) {
  if (folder.empty()) return;
  check_output_folder(folder);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) refuse(folder, "cannot be a folder for results: " + failure.message());
}

}  // namespace lacuna
