#pragma once

#include "measurement/csv/csv_table.h"
#include "measurement/csv/file_report.h"

namespace lacuna {

/// A measured file as numbers, and what was noticed in it.
struct ReadTable {
  FileReport report;
  CsvTable table;  ///< of no meaning where the report has problems; a column that the file lacks is empty
};

}  // namespace lacuna
