#include "loading/elf_file.h"

#include "loading/built_plugins.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <elf.h>

#include <cstring>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class ElfFile : public testing::Test {
 protected:
  std::string bytes_ = read_bytes(built_plugins() / "coulomb_friction.so");
  TestFolder folder_;
};

TEST_F(ElfFile, AWholeLibraryHasNoProblem) { EXPECT_THAT(elf_problem(folder_.write("whole.so", bytes_)), IsEmpty()); }

TEST_F(ElfFile, EveryTruncationIsFound) {
  for (std::size_t size = 0; size < bytes_.size(); size += 61)
    EXPECT_FALSE(elf_problem(folder_.write("cut.so", bytes_.substr(0, size))).empty()) << size << " bytes";
  EXPECT_THAT(elf_problem(folder_.write("cut.so", bytes_.substr(0, bytes_.size() - 1))), HasSubstr("is incomplete"));
}

TEST_F(ElfFile, TextIsNotALibrary) {
  EXPECT_THAT(elf_problem(folder_.write("text.so", "#!/bin/sh\necho no\n")), HasSubstr("not a shared library"));
}

TEST_F(ElfFile, AnotherProcessorsLibraryIsRefused) {
  const Elf64_Half other = EM_S390;
  std::memcpy(bytes_.data() + offsetof(Elf64_Ehdr, e_machine), &other, sizeof(other));
  EXPECT_THAT(elf_problem(folder_.write("other.so", bytes_)), HasSubstr("another kind of processor"));
}

TEST_F(ElfFile, AProgramIsNotAPlugin) {
  const Elf64_Half program = ET_EXEC;
  std::memcpy(bytes_.data() + offsetof(Elf64_Ehdr, e_type), &program, sizeof(program));
  EXPECT_THAT(elf_problem(folder_.write("program.so", bytes_)), HasSubstr("not a shared library"));
}

TEST_F(ElfFile, AMissingFileCannotBeRead) {
  EXPECT_THAT(elf_problem(folder_.path() / "none.so"), HasSubstr("cannot be read (No such file"));
}

}  // namespace
}  // namespace lacuna
