#include "numpy_file.h"

#include "array_rows.h"
#include "zip_archive.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace lacuna::numpy {
namespace {

constexpr const char* kEnding = ".npy";
constexpr std::size_t kEndPiece = std::size_t{1} << 16;
constexpr std::size_t kLargestRow = std::size_t{1} << 24;  ///< bytes

/// An array of a file, with its header.
struct Array {
  std::string name;  ///< name in an archive; empty for a separate file
  ZipMember member;
  ArrayHeader header;
};

ByteStream stream_of(RandomFile& file, const ZipMember& member) {
  return {file, member.place, member.packed_size, member.is_deflated ? Packing::deflate : Packing::none};
}

std::string in_archive(const Array& array, const std::string& fault) {
  return array.name.empty() ? fault : "array `" + array.name + "` " + fault;
}

bool is_archive(RandomFile& file) {
  std::array<unsigned char, 2> start{};
  return file.read_at(0, start.data(), start.size()) == start.size() && start[0] == 'P' && start[1] == 'K';
}

/// A whole .npy file is treated like a stored array.
std::vector<Array> places_of(RandomFile& file) {
  std::vector<Array> arrays;
  if (!is_archive(file)) {
    ZipMember whole;
    whole.size = whole.packed_size = file.size();
    arrays.push_back({"", whole, {}});
    return arrays;
  }
  for (ZipMember& member : members_of(file)) {
    std::string name = member.name;
    if (!name.ends_with(kEnding)) continue;
    name.resize(name.size() - std::string_view(kEnding).size());
    arrays.push_back({std::move(name), std::move(member), {}});
  }
  return arrays;
}

/// Why an array has no columns; empty: it may.
std::string why_none(const ArrayHeader& header) {
  if (header.shape.empty()) return "is a single value";
  if (header.rows() == 0) return "has no rows";
  if (std::find(header.shape.begin(), header.shape.end(), 0) != header.shape.end()) return "has no columns";
  if (header.row_elements() == 0) return "has more than 4096 numbers per row";
  if (header.fields.empty()) return "contains no numbers";
  if (header.row_elements() * header.fields.size() > kMostNumbers) return "has more than 4096 numbers per row";
  if (header.row_elements() * header.element_size > kLargestRow) return "has rows of more than 16 MiB";
  return {};
}

bool names_time(const std::string& name) {
  constexpr std::array<std::string_view, 8> kTimes = {"t",      "time",      "times",      "t_s",
                                                      "time_s", "timestamp", "timestamps", "stamp"};
  return std::find(kTimes.begin(), kTimes.end(), name) != kTimes.end();
}

/// Number of rows of the array that is the time, else of most arrays, else the largest.
std::uint64_t rows_of_table(const std::vector<Array>& arrays) {
  std::map<std::uint64_t, int> counts;
  for (const Array& array : arrays) {
    if (names_time(array.name) && array.header.shape.size() == 1) return array.header.rows();
    ++counts[array.header.rows()];
  }
  std::pair<int, std::uint64_t> most{0, 0};
  for (const auto& [rows, count] : counts) most = std::max(most, {count, rows});
  return most.second;
}

/// The arrays of one table, and the remarks about the others.
struct OpenedArrays {
  std::vector<Array> arrays;
  std::vector<RecordingSentence> remarks;
};

OpenedArrays open_arrays(RandomFile& file) {
  OpenedArrays opened;
  std::vector<Array> all;
  for (Array& array : places_of(file)) {
    std::string reason;
    try {
      ByteStream stream = stream_of(file, array.member);
      array.header = read_header(stream);
      reason = why_none(array.header);
    } catch (const BadFile& bad) {
      if (array.name.empty()) throw;
      reason = bad.what();
    }
    if (reason.empty())
      all.push_back(std::move(array));
    else if (array.name.empty())
      throw BadFile(reason + ", so it is not a recording");
    else
      opened.remarks.push_back({0, "array `" + array.name + "` is left out: it " + reason});
  }
  const std::uint64_t rows = rows_of_table(all);
  for (Array& array : all) {
    if (array.header.rows() == rows)
      opened.arrays.push_back(std::move(array));
    else
      opened.remarks.push_back({0, "array `" + array.name + "` is left out: it has " +
                                       std::to_string(array.header.rows()) + " rows, but the others have " +
                                       std::to_string(rows)});
  }
  return opened;
}

/// Reads a compressed or stored array to its end, so that its checksum can be verified.
void check_end(ByteStream& stream, const Array& array) {
  std::vector<unsigned char> piece(kEndPiece);
  std::size_t behind = 0;
  while (const std::size_t got = stream.read(piece.data(), piece.size())) behind += got;
  if (behind > 0 && !array.name.empty())
    throw BadFile("continues after its last row; write the file again with numpy.savez");
  if (!array.name.empty() && stream.checksum() != array.member.checksum)
    throw BadFile("is damaged: its checksum is wrong; copy the file again or write it anew");
}

void read_array(RandomFile& file, const Array& array, std::size_t most_rows, WantedColumns& wanted) {
  const std::vector<std::string> columns = columns_of(array.header, array.name);
  if (std::none_of(columns.begin(), columns.end(), [&](const std::string& one) { return wanted.contains(one); }))
    return;
  try {
    ByteStream stream = stream_of(file, array.member);
    read_header(stream);
    read_rows(stream, array.header, array.name, most_rows, wanted);
    if (most_rows >= array.header.rows()) check_end(stream, array);
  } catch (const BadFile& bad) {
    throw BadFile(in_archive(array, bad.what()));
  }
}

RecordedRows read_query(RandomFile& file, const std::vector<Array>& arrays, const TableQuery& query) {
  WantedColumns wanted;
  for (const std::string& column : query.columns) wanted.emplace(column, WantedColumn());
  for (const Array& array : arrays) read_array(file, array, query.most_rows, wanted);
  RecordedRows rows;
  for (const std::string& column : query.columns) {
    NumberColumn& numbers = wanted.at(column).numbers;
    rows.origins.push_back(numbers.origin());
    rows.columns.push_back(numbers.take());
  }
  return rows;
}

}  // namespace

RecordingContents contents_of(const std::string& path) {
  RecordingContents contents;
  try {
    RandomFile file(path);
    OpenedArrays opened = open_arrays(file);
    contents.remarks = std::move(opened.remarks);
    ColumnNames names;
    for (const Array& array : opened.arrays)
      for (const std::string& column : columns_of(array.header, array.name)) names.add_single(column);
    if (const std::string repeated = names.repeated(); !repeated.empty()) contents.remarks.push_back({0, repeated});
    if (names.size() > 0) contents.tables.push_back({"", names.columns(), ""});
  } catch (const BadFile& bad) {
    contents.problems.push_back({0, bad.what()});
  }
  return contents;
}

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries) {
  ReadRows read;
  try {
    RandomFile file(path);
    const OpenedArrays opened = open_arrays(file);
    for (const TableQuery& query : queries) read.tables.push_back(read_query(file, opened.arrays, query));
  } catch (const BadFile& bad) {
    read.problems.push_back({0, bad.what()});
  }
  return read;
}

}  // namespace lacuna::numpy
