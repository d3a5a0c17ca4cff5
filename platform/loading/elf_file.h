#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// What keeps a file from being a complete shared library of this machine: no ELF file, another
/// processor's, or shorter than its own headers say. Empty: nothing. Reads the headers only.
///
/// The dynamic loader maps the segments without looking at the file's size and ends the process with
/// SIGBUS when it touches a page beyond its end; a file that passes here has no such page.
std::string elf_problem(const std::filesystem::path& file);

}  // namespace lacuna
