#include "config/toml/path_variables.h"

#include "foundation/files/special_file.h"
#include "foundation/recording_folder.h"

#include <lacuna/error.h>

#include <cstdlib>
#include <system_error>

namespace lacuna {

namespace {

std::string value_of(const std::string& name, const std::string& written) {
  const char* value = std::getenv(name.c_str());
  if (value != nullptr) return value;
  throw Error("the environment variable " + name + " is not set; set it to the folder for \"" + written + "\"");
}

}  // namespace

std::string replace_variables(const std::string& written) {
  std::string text;
  std::size_t at = 0;
  for (std::size_t open = written.find("${"); open != std::string::npos; open = written.find("${", at)) {
    const std::size_t close = written.find('}', open);
    if (close == std::string::npos) throw Error("\"" + written + "\": the \"${\" has no closing brace");
    text += written.substr(at, open - at);
    text += value_of(written.substr(open + 2, close - open - 2), written);
    at = close + 1;
  }
  return text + written.substr(at);
}

namespace {

std::filesystem::path resolve(const std::string& written, const std::filesystem::path& directory) {
  std::filesystem::path path = replace_variables(written);
  if (path.is_relative()) path = directory / path;
  return path.lexically_normal();
}

}  // namespace

std::filesystem::path resolve_existing_file(const std::string& written, const std::filesystem::path& directory) {
  std::filesystem::path path = resolve(written, directory);
  std::error_code failure;
  if (!std::filesystem::exists(std::filesystem::status(path, failure))) throw Error("no such file: " + path.string());
  if (const std::string why = why_no_regular_file(path); !why.empty()) throw Error(path.string() + " " + why);
  return path;
}

std::filesystem::path resolve_recording(const std::string& written, const std::filesystem::path& directory) {
  const std::filesystem::path path = without_last_slash(resolve(written, directory));
  if (is_recording_folder(path)) return path;
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure))
    throw Error(path.string() + " is a folder without metadata.yaml, so no recording of ROS 2; name a file in it");
  return resolve_existing_file(written, directory);
}

}  // namespace lacuna
