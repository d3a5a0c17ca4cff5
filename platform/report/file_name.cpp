#include "report/file_name.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

namespace lacuna {

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-' ? c : '-';
  return name;
}

std::string FileNames::next(const std::string& text) {
  const std::filesystem::path wanted = file_name(text);
  std::string name = wanted.string();
  for (int number = 2; !taken_.insert(name).second; ++number)
    name = fmt::format("{}-{}{}", wanted.stem().string(), number, wanted.extension().string());
  return name;
}

}  // namespace lacuna
