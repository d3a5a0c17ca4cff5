#include "config/toml/text_file.h"

#include "foundation/files/allowed_files.h"
#include "foundation/text/problem.h"
#include "foundation/processes/process_limits.h"
#include "foundation/files/special_file.h"

#include <fstream>
#include <iterator>
#include <system_error>

namespace lacuna {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{4} << 20U;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& message) {
  throw_problem({file.string(), 0, 0}, message);
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file) {
  check_may_read(file);
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) refuse(file, "is a folder; name a file in it");
  if (const std::string why = why_no_regular_file(file); !why.empty()) refuse(file, why);
  if (std::filesystem::file_size(file, failure) > kLargestFile || failure)
    refuse(file, "is longer than 4 MiB; put measured data into separate files");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) {
    const std::string used_up = used_up_descriptors();
    refuse(file, "cannot be read; " + (used_up.empty() ? "check its permissions" : used_up));
  }
  if (text.starts_with("SQLite format 3")) refuse(file, "is a database, not a TOML file");
  return text;
}

}  // namespace lacuna
