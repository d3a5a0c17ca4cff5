#include "app/runs/run_faults.h"

#include "app/runs/store_journal.h"
#include "foundation/processes/stop.h"
#include "storage/core/statement.h"
#include "storage/eea/eea_store.h"
#include "storage/results/carried_out.h"
#include "storage/results/stored_run.h"

#include <fmt/format.h>

#include <mutex>
#include <optional>
#include <utility>

namespace lacuna {
namespace {

/// A run that is done is not gone on with: its checkpoint may be one of an earlier version.
void read_whole_run(Database& database, const EeaRunListing& listing) {
  stored_run(database, listing.run);
  std::mutex unused;
  const EeaStore store(database, unused, listing.run, {});
  store.record();
  if (listing.ending == "done" || !read_checkpoint(store)) stored_trials(store);
  for (const PassRow& pass : store.passes())
    if (pass.best_model && !store.model(*pass.best_model))
      throw Error(fmt::format("the best model of pass {} is missing", pass.number));
}

/// What a question that reads stored things says against them.
template <class Question>
std::optional<std::string> fault_in(const std::string& what, const Stop& stop, const Question& question) try {
  stop.throw_if_requested();
  question();
  return std::nullopt;
} catch (const Interrupted&) {
  throw;
} catch (const std::exception& wrong) {
  return fmt::format("{}: {}", what, wrong.what());
}

struct CarriedOut {
  std::string experiment, target;
};

std::vector<CarriedOut> all_carried_out(const Database& database) {
  std::vector<CarriedOut> all;
  if (!Statement(database, "SELECT 1 FROM sqlite_schema WHERE name = 'carried_out'").step()) return all;
  Statement row(database,
                "SELECT DISTINCT experiment.name, target FROM carried_out JOIN trial ON trial.id = carried_out.trial"
                " JOIN experiment ON experiment.id = trial.experiment ORDER BY 1, 2");
  while (row.step()) all.push_back({row.text(0), row.text(1)});
  return all;
}

}  // namespace

std::vector<std::string> faults_of_runs(Database& database) {
  std::vector<std::string> faults;
  const auto note = [&](std::optional<std::string> fault) {
    if (fault) faults.push_back(std::move(*fault));
  };
  for (const EeaRunListing& listing : eea_runs(database))
    note(fault_in(fmt::format("run {}", listing.run.value), database.stop(),
                  [&] { read_whole_run(database, listing); }));
  for (const CarriedOut& one : all_carried_out(database))
    note(fault_in("trials of " + one.experiment, database.stop(),
                  [&] { carried_out_trials(database, one.experiment, one.target); }));
  return faults;
}

}  // namespace lacuna
