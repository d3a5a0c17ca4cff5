#include "plugin_checks/exercises/damaged_texts.h"

#include <lacuna/error.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace lacuna {
namespace {

constexpr std::size_t kPlaces = 8;
constexpr std::size_t kOverwritten = 24;

}  // namespace

std::vector<std::string> damaged_texts(const std::string& whole) {
  std::vector<std::string> all = {"", "nonsense\n", std::string(64, '\0'), std::string(200, '\xff')};
  for (std::size_t i = 1; i < kPlaces; ++i) {
    const std::size_t place = whole.size() * i / kPlaces;
    all.push_back(whole.substr(0, place));
    for (const char byte : {'\0', '\x7f', '9'}) {
      std::string text = whole;
      const std::size_t count = std::min(kOverwritten, text.size() - place);
      std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(place), count, byte);
      all.push_back(text);
    }
  }
  return all;
}

std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || !text) throw Error(file.string() + ": cannot be read; name a file of the plugin's format");
  return text.str();
}

}  // namespace lacuna
