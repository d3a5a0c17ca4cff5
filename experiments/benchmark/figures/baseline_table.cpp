#include "figures/baseline_table.h"

#include "figures/tables.h"

#include <fmt/format.h>

#include <map>

namespace hidden_effects {
namespace {

/// By method, then by figure and noise ("" for all).
using Values = std::map<std::string, std::map<std::string, std::map<std::string, std::vector<double>>>>;

Values read_baselines(const Database& database, const FigureValues& all) {
  Values values;
  for (const Row& row : database.query(
           "WITH v AS MATERIALIZED (SELECT * FROM baseline_value) SELECT v.method, v.figure, j.noise, v.value "
           "FROM v CROSS JOIN judged j USING (version, set_name, number) "
           "WHERE +v.version IN (SELECT value FROM json_each(?)) AND +v.set_name = ? ORDER BY number, v.version",
           {list_cell(all.versions), all.set}))
    for (const std::string& noise : {text(row[2]), std::string()})
      values[text(row[0])][text(row[1])][noise].push_back(real(row[3]));
  return values;
}

std::string cell_of(const std::string& figure, const std::vector<double>& values) {
  const bool seconds = figure == "processor seconds";
  const FigureKind kind{figure, figure, seconds ? "median" : "share", 0.0, 0.0};
  return estimate_text(kind, seconds ? bootstrap(values, median) : share(values));
}

}  // namespace

std::string baseline_table(const Database& database, const FigureValues& all) {
  Values values = read_baselines(database, all);
  if (values.empty()) return "";
  std::string table =
      "\n## Other methods on the same data\n\n| method | figure | disturbed | all |\n|---|---|---|---|\n";
  for (auto& [method, figures] : values)
    for (auto& [figure, by_noise] : figures)
      table += fmt::format("| {} | {} | {} | {} |\n", method, figure, cell_of(figure, by_noise["disturbed"]),
                           cell_of(figure, by_noise[""]));
  return table;
}

}  // namespace hidden_effects
