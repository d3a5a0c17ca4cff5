#include "mat_variables.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>

namespace lacuna::mat {
namespace {

constexpr std::size_t kHeader = 128;        ///< bytes: text, an unused number, version, byte order
constexpr std::size_t kLongestName = 4096;  ///< bytes
constexpr std::size_t kMostDimensions = 64;
constexpr std::size_t kMostFields = 65536;
constexpr std::size_t kDeepest = 32;
constexpr std::uint32_t kComplex = 0x0800;  ///< flag of an array

/// Classes of arrays (table 1-3).
enum class MatClass : std::uint32_t {
  cell = 1,
  structure = 2,
  object = 3,
  text = 4,
  sparse = 5,
  real64 = 6,
  uint64 = 15
};

/// The header of an array.
struct ArrayHead {
  std::uint32_t flags = 0;
  std::vector<std::uint64_t> sizes;
  std::string name;

  MatClass kind() const { return static_cast<MatClass>(flags & 0xff); }
  std::uint64_t elements() const {
    std::uint64_t count = 1;
    for (const std::uint64_t size : sizes)
      if (__builtin_mul_overflow(count, size, &count)) throw BadFile("has an array with too many elements");
    return count;
  }
};

/// Why an array does not consist of numbers; empty: it does.
std::string why_no_numbers(const ArrayHead& head) {
  switch (head.kind()) {
    case MatClass::cell: return "is a cell array; store the recording in plain arrays";
    case MatClass::text: return "is text";
    case MatClass::sparse: return "is sparse; store full(...) of it";
    default: break;
  }
  const bool has_numbers = head.kind() >= MatClass::real64 && head.kind() <= MatClass::uint64;
  if (has_numbers && head.sizes.size() != 2) return "has more than two dimensions";
  if (has_numbers) return (head.flags & kComplex) != 0 ? "is complex" : "";
  return "is an object, such as a timeseries or a Simulink dataset; store its times and data as plain arrays";
}

/// Reads the variables of one file.
class VariableReader {
 public:
  VariableReader(const std::string& path, MatVisitor& visitor) : file_(path), visitor_(visitor) {}

  void read() {
    read_header();
    std::uint64_t place = kHeader;
    while (place < file_.size()) {
      if (file_.size() - place < 8)
        throw BadFile("ends after its last variable without an end mark; copy the file again");
      ByteStream stream(file_, place, file_.size() - place, Packing::none);
      MatReader reader(stream, is_big_endian_, file_.size() - place);
      const MatTag tag = reader.read_tag();
      if (tag.is_small) throw BadFile("has a small data element instead of a variable; the file is damaged");
      read_element(tag, place + 8);
      place += 8 + tag.size;
    }
  }

 private:
  void read_header() {
    std::array<unsigned char, kHeader> header{};
    const std::size_t got = file_.read_at(0, header.data(), header.size());
    const std::string_view text(reinterpret_cast<const char*>(header.data()), got);
    if (text.starts_with("MATLAB 7.3") || text.starts_with("\x89HDF"))
      throw BadFile("is a MAT file of version 7.3, which is HDF5; write it with save('run.mat', ..., '-v7')");
    const std::string_view order = got == kHeader ? text.substr(126, 2) : std::string_view();
    if (order != "IM" && order != "MI")
      throw BadFile("is not a MAT file of version 5; write it with save('run.mat', ..., '-v7')");
    is_big_endian_ = order == "MI";
    const unsigned version = is_big_endian_ ? header[124] : header[125];
    if (version != 1) throw BadFile("is a MAT file of another version; write it with save('run.mat', ..., '-v7')");
  }

  void read_element(const MatTag& tag, std::uint64_t place) {
    if (tag.type == MatType::compressed) {
      ByteStream stream(file_, place, tag.size, Packing::zlib);
      MatReader reader(stream, is_big_endian_, std::numeric_limits<std::uint64_t>::max());
      const MatTag inside = reader.read_tag();
      if (inside.type == MatType::matrix) read_whole(stream, inside);
    } else if (tag.type == MatType::matrix) {
      ByteStream stream(file_, place, tag.size, Packing::none);
      read_whole(stream, tag);
    }
  }

  void read_whole(ByteStream& stream, const MatTag& tag) {
    MatReader reader(stream, is_big_endian_, tag.size);
    if (tag.size > 0) read_matrix(reader, "", 0);
  }

  /// An array and its content. `path`: of a field; empty: its own name counts.
  void read_matrix(MatReader& reader, const std::string& path, std::size_t depth) {
    const ArrayHead head = read_head(reader);
    const std::string own = path.empty() ? head.name : path;
    if (own.empty() || own.starts_with("__")) return reader.skip_all();  // MATLAB's internal data
    if (head.kind() == MatClass::structure) return read_structure(reader, head, own, depth);
    const std::string reason = why_no_numbers(head);
    if (reason.empty()) return read_array(reader, head, own);
    visitor_.leave_out(own, reason);
    reader.skip_all();
  }

  ArrayHead read_head(MatReader& reader) {
    ArrayHead head;
    const auto flags = reader.read_data(reader.read_tag(), 8);
    head.flags = static_cast<std::uint32_t>(reader.number_at(flags, 0));
    if (head.kind() > MatClass::uint64) {  // an object has a name and no sizes
      const auto name = reader.read_data(reader.read_tag(), kLongestName);
      head.name.assign(name.begin(), name.end());
      return head;
    }
    const auto sizes = reader.read_data(reader.read_tag(), 4 * kMostDimensions);
    for (std::size_t i = 0; i + 4 <= sizes.size(); i += 4) head.sizes.push_back(reader.number_at(sizes, i));
    const auto name = reader.read_data(reader.read_tag(), kLongestName);
    head.name.assign(name.begin(), name.end());
    return head;
  }

  void read_array(MatReader& reader, const ArrayHead& head, const std::string& path) {
    const MatTag tag = reader.read_tag();
    if (MatReader::count_of(tag) != head.elements())
      throw BadFile("has " + std::to_string(MatReader::count_of(tag)) + " numbers in `" + path +
                    "`, which should have " + std::to_string(head.elements()));
    if (visitor_.begin_array({path, head.sizes[0], head.sizes[1]}))
      reader.read_numbers(tag, [&](std::uint64_t index, LongNumber number) { visitor_.take_number(index, number); });
    else
      reader.skip_data(tag);
  }

  void read_structure(MatReader& reader, const ArrayHead& head, const std::string& path, std::size_t depth) {
    if (depth == kDeepest) throw BadFile("nests structures too deeply in `" + path.substr(0, 60) + "`");
    if (head.elements() != 1) {
      visitor_.leave_out(path, "is a list of structures; store the recording in one structure of arrays");
      return reader.skip_all();
    }
    const auto length_data = reader.read_data(reader.read_tag(), 4);
    const auto length = static_cast<std::size_t>(reader.number_at(length_data, 0));
    if (length == 0 || length > kLongestName) throw BadFile("has field names of an impossible length");
    const auto names = reader.read_data(reader.read_tag(), kMostFields * 64);
    for (std::size_t at = 0; at + length <= names.size(); at += length) {
      const auto* const start = reinterpret_cast<const char*>(names.data()) + at;
      const std::string field(start, ::strnlen(start, length));
      const MatTag tag = reader.read_tag();
      if (tag.type != MatType::matrix) throw BadFile("has a field `" + path + "." + field + "` that is not an array");
      read_field(reader, tag, path + "." + field, depth);
    }
  }

  /// An element's reader must not read beyond it; the unread rest is skipped.
  void read_field(MatReader& reader, const MatTag& tag, const std::string& path, std::size_t depth) {
    if (tag.size == 0) return;
    MatReader inside = reader.within(tag);
    read_matrix(inside, path, depth + 1);
    inside.skip_all();
    reader.leave(tag);
  }

  RandomFile file_;
  MatVisitor& visitor_;
  bool is_big_endian_ = false;
};

}  // namespace

void visit_variables(const std::string& path, MatVisitor& visitor) { VariableReader(path, visitor).read(); }

}  // namespace lacuna::mat
