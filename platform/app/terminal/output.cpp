#include "app/terminal/output.h"

#include "app/terminal/plain_streams.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstring>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& place, const std::string& message) {
  throw_problem({place.string(), 0, 0}, message);
}

struct CommandFiles {
  std::vector<fs::path> outputs, inputs;
};

/// Of this command.
CommandFiles& files() {
  static CommandFiles files;
  return files;
}

constexpr const char* kWhatToDo = "choose another file for the results";

/// SQLite keeps these beside a database while it is open, and replays what it finds in them.
bool is_log_of(const fs::path& output, const fs::path& input) {
  const std::string place = place_of(input).string();
  const auto is_one = [&](const char* tail) { return are_one_file(output, place + tail); };
  return is_one("-wal") || is_one("-shm") || is_one("-journal");
}

void refuse_one_of(const fs::path& output, const fs::path& input) {
  if (output == input) refuse(output, fmt::format("is read by this command; {}", kWhatToDo));
  if (are_one_file(output, input))
    refuse(output, fmt::format("is {}, which this command reads; {}", input.string(), kWhatToDo));
  if (is_log_of(output, input))
    refuse(output, fmt::format("has the name of a log of {}, which this command reads; {}", input.string(), kWhatToDo));
}

void refuse_input(const fs::path& output) {
  for (const fs::path& input : files().inputs) refuse_one_of(output, input);
}

/// Of files and folders alike.
void note_output(const fs::path& output) {
  for (const fs::path& other : files().outputs)
    if (are_one_file(output, other)) refuse(output, "is named by two options; name two different files");
  refuse_input(output);
  files().outputs.push_back(output);
}

void check_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) refuse(file, "is a folder; name a file for the results");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) refuse(file, "cannot be written: there is no folder " + folder.string());
  if (const auto why = why_not_writable(file, when_interrupted())) refuse(file, "cannot be written: " + *why);
}

/// The folder itself, or else the one in which it, or what it lies in, would be made.
fs::path first_there(fs::path folder) {
  std::error_code ignored;
  while (!folder.empty() && !fs::exists(fs::symlink_status(folder, ignored))) folder = folder.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

void check_folder(const fs::path& folder) {
  for (const fs::path& part : folder)
    if (part.native().size() > NAME_MAX)
      refuse(folder, "cannot be a folder for results: " + std::string(std::strerror(ENAMETOOLONG)));
  const fs::path place = first_there(folder);
  std::error_code failure;
  if (!fs::is_directory(place, failure))
    refuse(folder, "cannot be a folder for results: " + std::string(std::strerror(ENOTDIR)));
  if (const auto why = why_not_writable_into(place)) refuse(folder, "cannot be written into: " + *why);
  refuse_input(folder);
}

}  // namespace

void write_output(const std::string& to, const std::string& text, Existing existing) {
  if (to.empty()) {
    exact_output() << text << std::flush;
    return;
  }
  refuse_input(to);
  write_whole(to, text, Link::followed, existing, when_interrupted());
}

bool takes_standard_output(const std::optional<std::string>& option) { return option && option->empty(); }

void check_output(const std::optional<std::string>& option, const std::optional<std::string>& other) {
  if (takes_standard_output(option) && takes_standard_output(other))
    throw_problem({}, "--json and --csv cannot both go to standard output; name a file for one of them");
  for (const std::optional<std::string>& file : {option, other}) {
    if (!file || file->empty()) continue;
    check_file(*file);
    note_output(*file);
  }
}

void check_new_output(const std::optional<std::string>& option, Existing existing) {
  check_output(option);
  if (option && !option->empty() && existing == Existing::refused && is_replaceable(*option))
    refuse(*option, "exists already; name another file, or replace it with --force");
}

void forget_command_files() { files() = {}; }

void refuse_outputs_among(const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs) {
    for (const fs::path& output : files().outputs) refuse_one_of(output, input);
    files().inputs.push_back(input);
  }
}

void check_output_folder(const fs::path& folder) {
  if (folder.empty()) return;
  check_folder(folder);
  note_output(folder);
}

fs::path file_for_picture(const fs::path& folder, const std::string& name) {
  fs::path file = folder / name;
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) refuse(file, "is a folder; --out FOLDER puts the pictures somewhere else");
  refuse_input(file);
  return file;
}

void make_output_folder(const fs::path& folder) {
  if (folder.empty()) return;
  check_folder(folder);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) refuse(folder, "cannot be a folder for results: " + failure.message());
}

}  // namespace lacuna
