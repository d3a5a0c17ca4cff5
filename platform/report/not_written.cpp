#include "report/not_written.h"

#include <lacuna/error.h>

namespace lacuna {

void throw_not_written(const std::filesystem::path& file) {
  throw Error(file.string() +
              ": cannot be written to its end; check that its folder is writable and the disk not full");
}

}  // namespace lacuna
