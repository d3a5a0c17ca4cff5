#pragma once

#include "array_header.h"

#include <lacuna/row_columns.h>

#include <map>
#include <string>
#include <vector>

namespace lacuna::numpy {

/// The columns of an array: `q[0]`, `q[1]` of a table of numbers called q, `q` of a list of them, and fields by path.
/// Without a name `[0]`, `[1]` and the fields' paths.
std::vector<std::string> columns_of(const ArrayHeader& header, const std::string& name);

/// A requested column. Of a name that occurs again only the first is read.
struct WantedColumn {
  NumberColumn numbers;
  bool is_found = false;
};
using WantedColumns = std::map<std::string, WantedColumn>;

/// Reads the elements after a header into the requested columns, by name, at most `most_rows` rows. Throws `BadFile`
/// where there are fewer than the header states.
void read_rows(ByteStream& stream, const ArrayHeader& header, const std::string& name, std::size_t most_rows,
               WantedColumns& wanted);

}  // namespace lacuna::numpy
