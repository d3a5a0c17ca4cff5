#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// Why a file is not a complete shared library for this machine: not an ELF file, another processor's, or shorter than
/// its headers state. Empty: it is one. Reads the headers only.
///
/// The dynamic loader maps the segments without checking the file's size and ends the process with SIGBUS when it
/// touches a page beyond its end; a file that passes this check has no such page.
std::string elf_problem(const std::filesystem::path& file);

}  // namespace lacuna
