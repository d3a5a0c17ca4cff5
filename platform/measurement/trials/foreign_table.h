#pragma once

#include "measurement/csv/csv_table.h"
#include "measurement/trials/recording_formats.h"

namespace lacuna {

/// The query to a format for what is wanted of one of its tables.
TableQuery rows_query(const CsvQuery& query, const std::string& table);

/// The rows that a format gave for `rows_query` as if a CSV file had them: a row without a time is a problem where it
/// has a value and is passed over where it has none, infinities are problems, missing values are noted.
CsvTable table_of_rows(RecordedRows rows, const CsvQuery& query, FileReport& report);

/// Hands on what a format says of its reading.
void report_reading(const ReadRows& read, FileReport& report);

}  // namespace lacuna
