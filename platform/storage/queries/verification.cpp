#include "storage/queries/verification.h"

#include "foundation/processes/stop.h"
#include "foundation/text/counted.h"
#include "storage/core/one_state.h"
#include "storage/core/schema_check.h"
#include "storage/core/statement.h"
#include "storage/results/stored_run.h"
#include "storage/traces/read_trace.h"

#include <lacuna/error.h>

#include <fmt/format.h>

namespace lacuna {
namespace {

/// What is asked of a damaged file may itself fail.
template <class Question>
void ask(std::vector<std::string>& damage, const Question& question) try {
  question();
} catch (const Interrupted&) {
  throw;
} catch (const std::exception& error) {
  damage.emplace_back(error.what());
}

void check_pages(const Database& database, std::vector<std::string>& damage) {
  Statement found(database, "PRAGMA integrity_check");
  while (found.step())
    if (found.text(0) != "ok") damage.push_back("SQLite: " + found.text(0));
  Statement keys(database, "PRAGMA foreign_key_check");
  while (keys.step()) damage.push_back(fmt::format("a row of {} refers to a missing {}", keys.text(0), keys.text(2)));
}

void check_traces(const Database& database, std::vector<std::string>& damage) {
  std::vector<TraceId> traces;
  Statement all(database, "SELECT id FROM trace ORDER BY id");
  while (all.step()) traces.push_back(TraceId{all.integer(0)});
  for (const TraceId trace : traces) {
    database.stop().throw_if_requested();
    try {
      read_trace(database, trace);
    } catch (const Error& error) {
      damage.push_back(fmt::format("trace {}: {}", trace.value, error.what()));
    }
  }
}

}  // namespace

Verification verify(const Database& database, const std::function<void(double)>& progress) {
  Verification found;
  hold_one_state(database);
  ask(found.damage, [&] { check_pages(database, found.damage); });
  ask(found.damage, [&] {
    for (const std::string& name : changed_schema(database))
      found.damage.push_back(name + " differs from the one that this program makes");
  });
  ask(found.damage, [&] { found.seals = check_seals(database, progress); });
  ask(found.damage, [&] { check_traces(database, found.damage); });
  ask(found.damage, [&] { check_stored_texts(database); });
  return found;
}

}  // namespace lacuna
