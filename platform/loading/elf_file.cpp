#include "loading/elf_file.h"

#include <elf.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

namespace lacuna {
namespace {

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#else
#error "name this processor's ELF machine here"
#endif

template <class Record>
bool read_at(std::ifstream& stream, std::uint64_t offset, Record& record) {
  stream.seekg(static_cast<std::streamoff>(offset));
  stream.read(reinterpret_cast<char*>(&record), sizeof(Record));
  return static_cast<bool>(stream);
}

std::string too_short(std::uint64_t size, std::uint64_t needed) {
  return "is incomplete: it has " + std::to_string(size) + " of at least " + std::to_string(needed) +
         " bytes; copy it or build it again";
}

/// The offset after the last byte to which the headers refer; 0 where they contradict themselves.
std::uint64_t end_of_content(std::ifstream& stream, const Elf64_Ehdr& header, std::uint64_t size) {
  const std::uint64_t segments_end = header.e_phoff + std::uint64_t{header.e_phnum} * sizeof(Elf64_Phdr);
  const std::uint64_t sections_end = header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize;
  std::uint64_t end = std::max(segments_end, sections_end);
  if (segments_end > size) return end;
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    if (!read_at(stream, header.e_phoff + i * sizeof(Elf64_Phdr), segment)) return 0;
    if (segment.p_offset + segment.p_filesz < segment.p_offset) return 0;
    end = std::max(end, segment.p_offset + segment.p_filesz);
  }
  return end;
}

/// Opening a named pipe would wait for its writer, and opening a device may have side effects.
std::string kind_problem(const std::filesystem::path& file) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(file, failure);
  const auto is = [](const char* what) {
    return std::string("is ") + what + ", not a shared library; take it out of the plugin folder";
  };
  switch (status.type()) {
    case std::filesystem::file_type::regular: return {};
    case std::filesystem::file_type::fifo: return is("a named pipe");
    case std::filesystem::file_type::socket: return is("a socket");
    case std::filesystem::file_type::directory: return is("a folder");
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block: return is("a device");
    case std::filesystem::file_type::not_found:
      if (std::filesystem::is_symlink(std::filesystem::symlink_status(file, failure)))
        return "is a link to a missing file; repair it or remove it from the plugin folder";
      return {};  // opening it tells
    default: return "cannot be read (" + failure.message() + "); check its permissions";
  }
}

}  // namespace

std::string elf_problem(const std::filesystem::path& file) {
  if (const std::string problem = kind_problem(file); !problem.empty()) return problem;
  std::ifstream stream(file, std::ios::binary);
  std::error_code failure;
  const std::uint64_t size = std::filesystem::file_size(file, failure);
  if (!stream || failure) return "cannot be read (" + std::string(std::strerror(errno)) + "); check its permissions";

  Elf64_Ehdr header{};
  const bool whole_header = read_at(stream, 0, header);
  if (size < SELFMAG || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
    return "is not a shared library; take it out of the plugin folder or build it again";
  if (!whole_header) return too_short(size, sizeof(Elf64_Ehdr));
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_machine != kMachine)
    return "was built for another kind of processor; build it on this machine";
  if (header.e_type != ET_DYN || header.e_phentsize != sizeof(Elf64_Phdr))
    return "is an ELF file but not a shared library; build it as a CMake MODULE (lacuna_add_plugin)";

  const std::uint64_t needed = end_of_content(stream, header, size);
  if (needed == 0) return "has damaged headers; copy it or build it again";
  return size < needed ? too_short(size, needed) : std::string();
}

}  // namespace lacuna
