#include "report/exports/column_spool.h"

#include "storage/queries/query_output.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace lacuna {
namespace {

enum class Tag : char { nothing, integer, real, text };

template <class Number>
void append_bits(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void append_cell(std::string& bytes, const Cell& cell) {
  const auto put_text = [&](const std::string& text) {
    bytes += static_cast<char>(Tag::text);
    append_bits(bytes, text.size());
    bytes += text;
  };
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) {
    bytes += static_cast<char>(Tag::integer);
    append_bits(bytes, *integer);
  } else if (const auto* real = std::get_if<double>(&cell)) {
    bytes += static_cast<char>(Tag::real);
    append_bits(bytes, *real);
  } else if (const auto* text = std::get_if<std::string>(&cell)) {
    put_text(*text);
  } else if (const auto* blob = std::get_if<Blob>(&cell)) {
    put_text(cell_text(*blob));
  } else {
    bytes += static_cast<char>(Tag::nothing);
  }
}

template <class Number>
Number take_bits(std::string_view& bytes) {
  Number number{};
  std::memcpy(&number, bytes.data(), sizeof(number));
  bytes.remove_prefix(sizeof(number));
  return number;
}

Cell take_cell(std::string_view& bytes) {
  const auto tag = static_cast<Tag>(bytes.front());
  bytes.remove_prefix(1);
  switch (tag) {
    case Tag::nothing: return std::monostate{};
    case Tag::integer: return take_bits<std::int64_t>(bytes);
    case Tag::real: return take_bits<double>(bytes);
    case Tag::text: break;
  }
  const auto size = take_bits<std::size_t>(bytes);
  std::string text(bytes.substr(0, size));
  bytes.remove_prefix(size);
  return text;
}

void visit_cells(std::string_view bytes, const std::function<void(const Cell&)>& visit) {
  while (!bytes.empty()) visit(take_cell(bytes));
}

[[noreturn]] void fail(const char* what) {
  throw Error(fmt::format("a temporary file {}: {}; make room in the folder for temporary files ($TMPDIR)", what,
                          std::strerror(errno)));
}

/// A file that has no name any more.
std::FILE* temporary_file() {
  std::error_code missing;
  std::string name = (std::filesystem::temp_directory_path(missing) / "lacuna-export-XXXXXX").string();
  const int descriptor = missing ? -1 : ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) fail("cannot be created");
  ::unlink(name.c_str());
  return ::fdopen(descriptor, "w+b");
}

}  // namespace

ColumnSpool::ColumnSpool(std::size_t columns, std::size_t most_bytes, const Stop& stop)
    : columns_(columns), most_bytes_(most_bytes), stop_(stop) {}

ColumnSpool::~ColumnSpool() = default;

void ColumnSpool::add(std::size_t column, const Cell& cell) {
  append_cell(columns_[column].waiting, cell);
  if (columns_[column].waiting.size() > most_bytes_) write_out(columns_[column]);
}

void ColumnSpool::write_out(Column& column) {
  stop_.throw_if_due();
  if (!file_) file_.reset(temporary_file());
  const std::string& bytes = column.waiting;
  if (!file_ || ::fseeko(file_.get(), end_, SEEK_SET) != 0 ||
      std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) < bytes.size() || std::fflush(file_.get()) != 0)
    fail("cannot be written completely");
  column.written.push_back({end_, bytes.size()});
  end_ += static_cast<std::int64_t>(bytes.size());
  column.waiting.clear();
}

void ColumnSpool::visit(std::size_t column, const std::function<void(const Cell&)>& visit) {
  std::string piece;
  for (const Extent& extent : columns_[column].written) {
    stop_.throw_if_due();
    piece.resize(extent.size);
    if (::fseeko(file_.get(), extent.place, SEEK_SET) != 0 ||
        std::fread(piece.data(), 1, piece.size(), file_.get()) < piece.size())
      fail("cannot be read");
    visit_cells(piece, visit);
  }
  visit_cells(columns_[column].waiting, visit);
}

}  // namespace lacuna
