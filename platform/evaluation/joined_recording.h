#pragma once

#include <lacuna/recording_format.h>

#include <string>
#include <vector>

namespace lacuna {

/// The tables and columns of all parts of a recording, such as the files of a bag that was split: each once, in the
/// order in which they appear. Sentences begin with the name of the part where the parts do not all say the same.
RecordingContents joined_contents(const std::vector<std::string>& names, std::vector<RecordingContents> parts);

std::size_t row_count(const RecordedRows& rows);

/// Of a query those columns that a part has, and the rows that may come after the `before` of earlier parts; without
/// columns where the part has none of the table, or nothing more may come.
TableQuery query_of_part(const TableQuery& query, const RecordingContents& part, std::size_t before);

/// Appends the rows of the next part, read by `of_part`, to those of `query`; NaN in the columns that it lacks. The
/// numbers keep the origins of the first part that has rows.
void append_rows(const TableQuery& query, const TableQuery& of_part, const RecordedRows& part, RecordedRows& all);

}  // namespace lacuna
