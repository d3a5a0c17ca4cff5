#include "figures/figure_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace hidden_effects {
namespace {

void count_cases(const Database& database, FigureValues& all) {
  const Row of = {list_cell(all.versions), all.set};
  const Row counts = database.query(
      "SELECT count(*), count(nullif(made, 0)) FROM judged "
      "WHERE version IN (SELECT value FROM json_each(?)) AND set_name = ?",
      of)[0];
  all.cases = static_cast<std::size_t>(integer(counts[0]));
  all.made = static_cast<std::size_t>(integer(counts[1]));
  const Row others = database.query(
      "SELECT count(*) FROM not_withheld "
      "WHERE version IN (SELECT value FROM json_each(?)) AND set_name = ?",
      of)[0];
  all.not_withheld = static_cast<std::size_t>(integer(others[0]));
}

std::string strength_text(const Cell& strength) {
  return std::isnan(real(strength)) ? "not made" : fmt::format("{:g}", real(strength));
}

/// The plus signs keep SQLite from choosing cases by version inside of each view, where that takes a hundred times
/// longer.
void read_values(const Database& database, FigureValues& all) {
  for (const Row& row : database.query("WITH v AS MATERIALIZED (SELECT * FROM figure_value WHERE value IS NOT NULL) "
                                       "SELECT v.figure, v.value, v.probability, j.noise, j.strength, j.rig, j.effect, "
                                       "j.form "
                                       "FROM v CROSS JOIN judged j USING (version, set_name, number) "
                                       "WHERE +v.version IN (SELECT value FROM json_each(?)) AND +v.set_name = ? "
                                       "ORDER BY number, v.version",
                                       {list_cell(all.versions), all.set}))
    all.values.push_back({text(row[0]), real(row[1]), real(row[2]), text(row[3]), strength_text(row[4]), text(row[5]),
                          text(row[6]), text(row[7])});
}

std::string what_is_there(const Database& database) {
  std::vector<std::string> all;
  for (const Row& row : database.query("SELECT set_name, group_concat(version, ', ') FROM "
                                       "(SELECT DISTINCT set_name, version FROM bench_case ORDER BY 1, 2) GROUP BY 1"))
    all.push_back(fmt::format("--set {} of --version {}", text(row[0]), text(row[1])));
  return all.empty() ? "none at all" : fmt::format("{}", fmt::join(all, "; "));
}

/// Those of the set, oldest first; refuses what it does not have.
std::vector<std::string> known_versions(const Database& database, const std::vector<std::string>& asked,
                                        const std::string& set) {
  std::vector<std::string> known = versions_of(database, set);
  std::vector<std::string> missing;
  std::copy_if(asked.begin(), asked.end(), std::back_inserter(missing), [&](const std::string& version) {
    return std::find(known.begin(), known.end(), version) == known.end();
  });
  if (known.empty() || !missing.empty())
    throw std::invalid_argument(fmt::format("the database has no case of --set {}{}{}; it has {}", set,
                                            missing.empty() ? "" : " --version ", fmt::join(missing, " or "),
                                            what_is_there(database)));
  return known;
}

}  // namespace

bool FigureKind::has_goal() const { return !std::isnan(least) || !std::isnan(most); }

bool FigureKind::met_by(double value) const {
  return !(value < least) && !(value > most);  // NaN bounds bound nothing
}

std::string version_text(const FigureValues& all) {
  const std::vector<std::string>& versions = all.versions;
  if (versions.size() > 2) return fmt::format("{} versions", versions.size());
  return fmt::format("version{} {}", versions.size() == 1 ? "" : "s", fmt::join(versions, " and "));
}

std::vector<std::string> versions_of(const Database& database, const std::string& set) {
  std::vector<std::string> versions;
  for (const Row& row : database.query(
           "SELECT version FROM version WHERE version IN (SELECT version FROM bench_case WHERE set_name = ?) "
           "ORDER BY begun, version",
           {set}))
    versions.push_back(text(row[0]));
  return versions;
}

std::string last_version(const Database& database, const std::string& set) {
  const std::vector<std::string> versions = versions_of(database, set);
  if (versions.empty()) throw std::invalid_argument(fmt::format("the database has no case of {}", set));
  return versions.back();
}

FigureValues read_figures(const Database& database, const std::vector<std::string>& versions, const std::string& set) {
  const std::vector<std::string> known = known_versions(database, versions, set);
  FigureValues all;
  all.set = set;
  for (const std::string& version : known)
    if (std::find(versions.begin(), versions.end(), version) != versions.end()) all.versions.push_back(version);
  if (all.versions.empty()) all.versions = {known.back()};
  count_cases(database, all);
  for (const Row& row : database.query("SELECT figure, title, kind, least, most FROM figure ORDER BY position"))
    all.figures.push_back({text(row[0]), text(row[1]), text(row[2]), real(row[3]), real(row[4])});
  read_values(database, all);
  return all;
}

Estimate estimate_of(const FigureValues& all, const FigureKind& figure,
                     const std::function<bool(const FigureValue&)>& chosen) {
  std::vector<double> values;
  std::vector<Stated> stated;
  for (const FigureValue& one : all.values) {
    if (one.figure != figure.name || !chosen(one)) continue;
    values.push_back(one.value);
    stated.push_back({one.probability, one.value});
  }
  if (figure.kind == "share") return share(values);
  if (figure.kind == "mean") return bootstrap(values, mean);
  if (figure.kind == "median") return bootstrap(values, median);
  if (figure.kind == "calibration by chance") return calibration_error_by_chance(stated);
  return bootstrap(stated, [](const std::vector<Stated>& sample) { return calibration_error(sample); });
}

}  // namespace hidden_effects
