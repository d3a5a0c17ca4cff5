#include "config/text_file.h"

#include "foundation/problem.h"

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
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) refuse(file, "is a folder; name a file in it");
  if (!std::filesystem::is_regular_file(file, failure)) refuse(file, "no such file");
  if (std::filesystem::file_size(file, failure) > kLargestFile || failure)
    refuse(file, "longer than 4 MiB; measured data belongs into files of its own");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) refuse(file, "cannot be read; check its permissions");
  return text;
}

}  // namespace lacuna
