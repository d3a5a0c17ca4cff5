#include "app/output.h"

#include <lacuna/error.h>

#include <cstdio>
#include <fstream>

namespace lacuna {

void write_output(const std::string& to, const std::string& text) {
  if (to.empty()) {
    std::fputs(text.c_str(), stdout);
    return;
  }
  std::ofstream stream(to, std::ios::binary);
  if (!(stream << text) || !stream.flush())
    throw Error(to + ": cannot be written; check that its folder exists and is writable");
}

bool takes_standard_output(const std::optional<std::string>& option) { return option && option->empty(); }

}  // namespace lacuna
