#include "foundation/plugins/plugin_libraries.h"

#include <execinfo.h>
#include <link.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>

namespace lacuna {
namespace {

constexpr std::size_t kMostLibraries = 512;
constexpr int kMostFrames = 64;

/// Not initialised, so that unused entries take no memory.
struct Library {
  std::uintptr_t begin, end;  ///< of its code and data
  bool of_program;
  std::array<char, PATH_MAX> file;
};

/// Memory shared with processes that are forked later.
struct LibraryPage {
  std::atomic<std::size_t> count = 0;
  std::atomic<const Library*> culprit = nullptr;
  std::array<Library, kMostLibraries> libraries;
};

LibraryPage* library_page = nullptr;

/// The address range of the loaded object that contains an address.
struct Extent {
  std::uintptr_t address = 0;
  std::uintptr_t begin = 0, end = 0;
};

int look_for_extent(dl_phdr_info* object, std::size_t, void* data) {
  auto& extent = *static_cast<Extent*>(data);
  std::uintptr_t begin = UINTPTR_MAX, end = 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD) continue;
    begin = std::min<std::uintptr_t>(begin, object->dlpi_addr + segment.p_vaddr);
    end = std::max<std::uintptr_t>(end, object->dlpi_addr + segment.p_vaddr + segment.p_memsz);
  }
  if (extent.address < begin || extent.address >= end) return 0;
  extent.begin = begin;
  extent.end = end;
  return 1;
}

std::uintptr_t place_of(const void* address) { return reinterpret_cast<std::uintptr_t>(address); }

/// Where the program's own code lies.
Extent program;

bool is_of_program(const void* address) {
  return place_of(address) >= program.begin && place_of(address) < program.end;
}

const Library* library_of(const void* address) {
  const std::uintptr_t place = place_of(address);
  const std::size_t count = library_page->count;
  for (const Library& library : std::span(library_page->libraries).first(count))
    if (place >= library.begin && place < library.end) return &library;
  return nullptr;
}

}  // namespace

void PluginLibraries::prepare() {
  if (library_page == nullptr) {
    void* const memory =
        mmap(nullptr, sizeof(LibraryPage), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) return;  // then none is named
    library_page = new (memory) LibraryPage;
  }
  library_page->count = 0;
  library_page->culprit = nullptr;
  program.address = place_of(reinterpret_cast<const void*>(&PluginLibraries::prepare));
  dl_iterate_phdr(look_for_extent, &program);
  std::array<void*, 1> frame{};
  backtrace(frame.data(), 1);  // the first call loads what it needs, which a signal handler must not do
}

void PluginLibraries::add(const void* address, const std::string& file, bool of_program) {
  if (library_page == nullptr || library_page->count >= kMostLibraries || file.size() >= PATH_MAX) return;
  Extent extent{place_of(address)};
  if (library_of(address) != nullptr || dl_iterate_phdr(look_for_extent, &extent) == 0) return;
  Library& library = library_page->libraries[library_page->count];
  library.begin = extent.begin;
  library.end = extent.end;
  library.of_program = of_program;
  std::memcpy(library.file.data(), file.c_str(), file.size() + 1);
  ++library_page->count;
}

void PluginLibraries::blame_this_thread() noexcept {
  if (library_page == nullptr || library_page->count == 0) return;
  std::array<void*, kMostFrames> frames{};
  const int count = backtrace(frames.data(), kMostFrames);
  const auto begin = frames.begin(), end = frames.begin() + count;
  for (auto frame = std::find_if_not(begin, end, is_of_program); frame != end; ++frame) {
    if (is_of_program(*frame)) return;  // code that a plugin asked for is the program's own
    const Library* const library = library_of(*frame);
    if (library == nullptr) continue;
    const Library* nobody = nullptr;
    library_page->culprit.compare_exchange_strong(nobody, library);
    return;
  }
}

std::string PluginLibraries::culprit() {
  const Library* const library = library_page == nullptr ? nullptr : library_page->culprit.load();
  return library == nullptr ? "" : library->file.data();
}

void PluginLibraries::forget_culprit() {
  if (library_page != nullptr) library_page->culprit = nullptr;
}

std::vector<std::string> PluginLibraries::of_others() {
  std::vector<std::string> files;
  if (library_page == nullptr) return files;
  for (const Library& library : std::span(library_page->libraries).first(library_page->count))
    if (!library.of_program) files.emplace_back(library.file.data());
  return files;
}

}  // namespace lacuna
