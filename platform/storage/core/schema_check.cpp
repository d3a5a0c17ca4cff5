#include "storage/core/schema_check.h"

#include "foundation/digest.h"
#include "storage/core/migrate.h"
#include "storage/core/statement.h"

#include <map>

namespace lacuna {
namespace {

/// By "table model".
std::map<std::string, std::string> schema_of(const Database& database) {
  std::map<std::string, std::string> texts;
  Statement entry(database, "SELECT type || ' ' || name, sql FROM sqlite_schema WHERE sql IS NOT NULL");
  while (entry.step()) texts[entry.text(0)] = entry.text(1);
  return texts;
}

bool has_views_of_this_program(const Database& database) {
  Statement views(database, "SELECT 1 FROM schema_text WHERE name = 'views' AND sha256 = ?");
  return views.with(sha256(schema_views())).step();
}

}  // namespace

std::vector<std::string> changed_schema(const Database& database) {
  Database blank = Database::open_blank();
  bring_up_to_date(blank, schema_migrations());
  const std::map<std::string, std::string> there = schema_of(database);
  if (!there.contains("table schema_text")) return {"table schema_text"};
  if (has_views_of_this_program(database)) refresh_views(blank, schema_views());
  std::vector<std::string> changed;
  for (const auto& [name, text] : schema_of(blank))
    if (const auto same = there.find(name); same == there.end() || same->second != text) changed.push_back(name);
  return changed;
}

}  // namespace lacuna
