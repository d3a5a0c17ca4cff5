#include "loading/allocation_count.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// Libraries call `malloc` through addresses that the loader has written into their tables. These entries are replaced
/// in all libraries, so that counting costs nothing where it was not requested.
namespace lacuna {
namespace {

thread_local constinit long allocations = 0;

template <class Function>
Function* original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

void* (*real_malloc)(std::size_t);
void* (*real_calloc)(std::size_t, std::size_t);
void* (*real_realloc)(void*, std::size_t);
void* (*real_aligned_alloc)(std::size_t, std::size_t);
int (*real_posix_memalign)(void**, std::size_t, std::size_t);

void* counted_malloc(std::size_t size) {
  ++allocations;
  return real_malloc(size);
}
void* counted_calloc(std::size_t number, std::size_t size) {
  ++allocations;
  return real_calloc(number, size);
}
void* counted_realloc(void* memory, std::size_t size) {
  ++allocations;
  return real_realloc(memory, size);
}
void* counted_aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return real_aligned_alloc(alignment, size);
}
int counted_posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  ++allocations;
  return real_posix_memalign(memory, alignment, size);
}

struct Replacement {
  std::string_view name;
  void* counting;
};

const std::array<Replacement, 5>& replacements() {
  static const std::array<Replacement, 5> all = {{{"malloc", reinterpret_cast<void*>(counted_malloc)},
                                                  {"calloc", reinterpret_cast<void*>(counted_calloc)},
                                                  {"realloc", reinterpret_cast<void*>(counted_realloc)},
                                                  {"aligned_alloc", reinterpret_cast<void*>(counted_aligned_alloc)},
                                                  {"posix_memalign", reinterpret_cast<void*>(counted_posix_memalign)}}};
  return all;
}

#if defined(__x86_64__)
constexpr std::array<std::uint64_t, 2> kOfFunctions = {R_X86_64_JUMP_SLOT, R_X86_64_GLOB_DAT};
#else
constexpr std::array<std::uint64_t, 2> kOfFunctions = {R_AARCH64_JUMP_SLOT, R_AARCH64_GLOB_DAT};
#endif

/// The table may have been made read-only once it was filled.
void write_address(void** slot, void* address) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  void* const begin = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(slot) & ~(page - 1));
  if (mprotect(begin, page, PROT_READ | PROT_WRITE) == 0) *slot = address;
}

/// The tables of one library.
struct Relocations {
  const char* names = nullptr;
  const Elf64_Sym* symbols = nullptr;
  std::array<std::span<const Elf64_Rela>, 2> tables;
};

template <class Pointer>
Pointer at(Elf64_Addr address) {
  return reinterpret_cast<Pointer>(address);  // NOLINT(performance-no-int-to-ptr): the loader's own addresses
}

Relocations relocations_of(const Elf64_Dyn* entry) {
  Relocations found;
  std::array<const Elf64_Rela*, 2> begins{};
  std::array<std::size_t, 2> sizes{};
  for (; entry->d_tag != DT_NULL; ++entry) switch (entry->d_tag) {
      case DT_STRTAB: found.names = at<const char*>(entry->d_un.d_ptr); break;
      case DT_SYMTAB: found.symbols = at<const Elf64_Sym*>(entry->d_un.d_ptr); break;
      case DT_JMPREL: begins[0] = at<const Elf64_Rela*>(entry->d_un.d_ptr); break;
      case DT_RELA: begins[1] = at<const Elf64_Rela*>(entry->d_un.d_ptr); break;
      case DT_PLTRELSZ: sizes[0] = entry->d_un.d_val / sizeof(Elf64_Rela); break;
      case DT_RELASZ: sizes[1] = entry->d_un.d_val / sizeof(Elf64_Rela); break;
      default: break;
    }
  for (std::size_t i = 0; i < begins.size(); ++i)
    if (begins[i] != nullptr) found.tables[i] = {begins[i], sizes[i]};
  return found;
}

void replace_in(const Relocations& relocations, Elf64_Addr base) {
  if (relocations.names == nullptr || relocations.symbols == nullptr) return;
  for (const std::span<const Elf64_Rela> table : relocations.tables)
    for (const Elf64_Rela& entry : table) {
      if (std::find(kOfFunctions.begin(), kOfFunctions.end(), ELF64_R_TYPE(entry.r_info)) == kOfFunctions.end())
        continue;
      const std::string_view name = relocations.names + relocations.symbols[ELF64_R_SYM(entry.r_info)].st_name;
      for (const Replacement& replacement : replacements())
        if (name == replacement.name) write_address(at<void**>(base + entry.r_offset), replacement.counting);
    }
}

/// Leaves out the program, the C library, whose own calls are not a plugin's, and the loader.
bool is_counted(std::string_view file) {
  const std::string_view name = file.substr(file.rfind('/') + 1);
  return !name.empty() && !name.starts_with("libc.so") && !name.starts_with("ld-linux") &&
         !name.starts_with("linux-vdso") && !name.starts_with("libdl.so");
}

int count_in(dl_phdr_info* object, std::size_t, void*) {
  if (!is_counted(object->dlpi_name)) return 0;
  for (const Elf64_Phdr& segment : std::span(object->dlpi_phdr, object->dlpi_phnum))
    if (segment.p_type == PT_DYNAMIC)
      replace_in(relocations_of(at<const Elf64_Dyn*>(object->dlpi_addr + segment.p_vaddr)), object->dlpi_addr);
  return 0;
}

}  // namespace

void count_allocations() {
  if (real_malloc != nullptr) return;
  real_calloc = original<void*(std::size_t, std::size_t)>("calloc");
  real_realloc = original<void*(void*, std::size_t)>("realloc");
  real_aligned_alloc = original<void*(std::size_t, std::size_t)>("aligned_alloc");
  real_posix_memalign = original<int(void**, std::size_t, std::size_t)>("posix_memalign");
  real_malloc = original<void*(std::size_t)>("malloc");
  dl_iterate_phdr(count_in, nullptr);
}

long allocations_of_this_thread() { return allocations; }

}  // namespace lacuna
