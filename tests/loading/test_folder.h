#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace lacuna {

/// A new empty folder that is removed with its content when the test ends.
class TestFolder {
 public:
  TestFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lacuna_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The folder with the plugins of this build.
inline std::filesystem::path built_plugins() {
  return std::filesystem::path(LACUNA_BINARY_DIRECTORY) / "lib" / "lacuna" / "plugins";
}

}  // namespace lacuna
