#include "storage/files/file_marks.h"

#include "storage/files/log_content.h"

namespace lacuna {

void add_marks(std::string_view bytes, Marks& marks) {
  for (const LogMark& mark : marks_in(bytes)) marks.insert(mark.now);
}

Marks marks_of_page(const RawFile& file, std::uint32_t page, std::uint32_t page_size) {
  Marks marks;
  add_marks(file.read(std::uint64_t{page - 1} * page_size, page_size), marks);
  return marks;
}

Marks all_marks(const RawFile& file) {
  constexpr std::size_t kStretch = 1U << 20U, kOverlap = 128;
  Marks marks;
  for (std::uint64_t at = 0; at < file.size(); at += kStretch - kOverlap) add_marks(file.read(at, kStretch), marks);
  return marks;
}

}  // namespace lacuna
