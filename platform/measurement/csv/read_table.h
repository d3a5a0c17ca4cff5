#pragma once

#include "measurement/csv/csv_table.h"
#include "measurement/csv/file_report.h"

namespace lacuna {

/// A measured file as numbers, and the messages about it.
struct ReadTable {
  FileReport report;
  CsvTable table;  ///< invalid where the report has problems; a missing column is empty
};

}  // namespace lacuna
