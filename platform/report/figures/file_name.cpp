#include "report/figures/file_name.h"

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
  constexpr std::size_t kLongest = 240;  // of the 255 characters that a name may have; a number fits behind it
  const std::filesystem::path wanted = file_name(text);
  const std::string ending = wanted.extension().string();
  const std::string stem = wanted.stem().string().substr(0, kLongest - ending.size());
  std::string name = stem + ending;
  for (int number = 2; !taken_.insert(name).second; ++number) name = fmt::format("{}-{}{}", stem, number, ending);
  return name;
}

}  // namespace lacuna
