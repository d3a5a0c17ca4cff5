#pragma once

#include "measurement/csv/csv_table.h"
#include "measurement/trials/recording_formats.h"

namespace lacuna {

/// The query to a format for the requested columns of one of its tables.
TableQuery rows_query(const CsvQuery& query, const std::string& table);

/// The rows that a format returned for `rows_query`, treated like those of a CSV file: a row without a time is a
/// problem where it has a value, and skipped where it has none; infinities are problems; missing values are noted.
CsvTable table_of_rows(RecordedRows rows, const CsvQuery& query, FileReport& report);

/// Passes on the format's remarks on its reading.
void report_reading(const ReadRows& read, FileReport& report);

}  // namespace lacuna
