#pragma once

#include <lacuna/recording_format.h>

#include <string>
#include <vector>

namespace lacuna {

/// The tables and columns of all parts of a recording, such as the files of a split bag: each once, in order of first
/// appearance. A sentence begins with the names of its parts, unless all parts have it.
RecordingContents joined_contents(const std::vector<std::string>& names, std::vector<RecordingContents> parts);

std::size_t row_count(const RecordedRows& rows);

/// The query for one part: the columns that it has, and the remaining rows after the `before` rows of earlier parts. It
/// has no columns if the part lacks the table or no rows remain.
TableQuery query_of_part(const TableQuery& query, const RecordingContents& part, std::size_t before);

/// Appends the rows that `of_part` read from the next part; NaN in the columns of `query` that the part lacks. The
/// origins of numbers are those of the first part that has rows.
void append_rows(const TableQuery& query, const TableQuery& of_part, const RecordedRows& part, RecordedRows& all);

}  // namespace lacuna
