#include "array_rows.h"

#include <algorithm>

namespace lacuna::numpy {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;

/// "[2][0]" for the element at that position in a row, in C order.
std::string indices_of(std::size_t place, const ArrayHeader& header) {
  std::string text;
  for (std::size_t d = header.shape.size(); d-- > 1; place /= header.shape[d])
    text.insert(0, "[" + std::to_string(place % header.shape[d]) + "]");
  return text;
}

std::string column_name(const ArrayHeader& header, const std::string& name, std::size_t element, const Field& field) {
  std::string text = name;
  if (header.shape.size() > 1) text += indices_of(element, header);
  if (text.empty() && field.path.empty()) return "[0]";
  return text + (text.empty() || field.path.empty() ? "" : ".") + field.path;
}

/// A requested field of an element of a row, and its column.
struct WantedField {
  std::size_t element = 0;
  const Field* field = nullptr;
  NumberColumn* column = nullptr;
};

std::vector<WantedField> wanted_fields(const ArrayHeader& header, const std::string& name, WantedColumns& wanted) {
  std::vector<WantedField> fields;
  for (std::size_t element = 0; element < header.row_elements(); ++element)
    for (const Field& field : header.fields) {
      const auto found = wanted.find(column_name(header, name, element, field));
      if (found == wanted.end() || found->second.is_found) continue;
      found->second.is_found = true;
      fields.push_back({element, &field, &found->second.numbers});
    }
  return fields;
}

[[noreturn]] void throw_short(std::uint64_t got, std::uint64_t rows) {
  throw BadFile("ends after " + std::to_string(got) + " of " + std::to_string(rows) + " rows; copy the file again");
}

/// Rows one after another.
void read_in_rows(ByteStream& stream, const ArrayHeader& header, std::uint64_t rows,
                  const std::vector<WantedField>& fields) {
  const std::size_t row_size = header.row_elements() * header.element_size;
  const std::size_t at_once = std::max<std::size_t>(kPiece / row_size, 1);
  std::vector<unsigned char> piece(at_once * row_size);
  for (std::uint64_t done = 0; done < rows;) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(at_once, rows - done));
    const std::size_t got = stream.read(piece.data(), count * row_size) / row_size;
    for (std::size_t row = 0; row < got; ++row)
      for (const WantedField& one : fields) {
        const std::size_t place = row * row_size + one.element * header.element_size + one.field->offset;
        one.column->add(read_scalar(piece.data() + place, one.field->type));
      }
    done += got;
    if (got < count) throw_short(done, header.rows());
  }
}

/// Position of an element of a row in Fortran order: the first index after that of the row changes fastest.
std::size_t fortran_place(std::size_t element, const ArrayHeader& header) {
  std::size_t place = 0;
  std::vector<std::size_t> index(header.shape.size(), 0);
  for (std::size_t d = header.shape.size(); d-- > 1; element /= header.shape[d]) index[d] = element % header.shape[d];
  for (std::size_t d = header.shape.size(); d-- > 1;) place = place * header.shape[d] + index[d];
  return place;
}

/// Columns one after another.
void read_in_columns(ByteStream& stream, const ArrayHeader& header, std::uint64_t most_rows,
                     const std::vector<WantedField>& fields) {
  std::multimap<std::size_t, WantedField> by_place;
  for (const WantedField& one : fields) by_place.emplace(fortran_place(one.element, header), one);
  const std::size_t size = header.element_size, at_once = std::max<std::size_t>(kPiece / size, 1);
  std::vector<unsigned char> piece(at_once * size);
  for (std::size_t place = 0; place < header.row_elements(); ++place)
    for (std::uint64_t done = 0; done < header.rows();) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(at_once, header.rows() - done));
      const std::size_t got = stream.read(piece.data(), count * size) / size;
      const auto [first, last] = by_place.equal_range(place);
      for (auto one = first; one != last; ++one)
        for (std::size_t row = 0; row < got && done + row < most_rows; ++row)
          one->second.column->add(
              read_scalar(piece.data() + row * size + one->second.field->offset, one->second.field->type));
      done += got;
      if (got < count) throw_short(done, header.rows());
    }
}

}  // namespace

std::vector<std::string> columns_of(const ArrayHeader& header, const std::string& name) {
  std::vector<std::string> columns;
  for (std::size_t element = 0; element < header.row_elements(); ++element)
    for (const Field& field : header.fields)
      if (columns.size() < kMostNumbers) columns.push_back(column_name(header, name, element, field));
  return columns;
}

void read_rows(ByteStream& stream, const ArrayHeader& header, const std::string& name, std::size_t most_rows,
               WantedColumns& wanted) {
  const std::vector<WantedField> fields = wanted_fields(header, name, wanted);
  if (fields.empty()) return;
  if (header.is_fortran_order && header.shape.size() > 1)
    read_in_columns(stream, header, most_rows, fields);
  else
    read_in_rows(stream, header, std::min<std::uint64_t>(header.rows(), most_rows), fields);
}

}  // namespace lacuna::numpy
