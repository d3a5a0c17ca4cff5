#include "report/file_name.h"

#include <cctype>

namespace lacuna {

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-' ? c : '-';
  return name;
}

}  // namespace lacuna
