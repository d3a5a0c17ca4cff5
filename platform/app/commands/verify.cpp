#include "app/commands/commands.h"
#include "app/runs/run_faults.h"
#include "app/terminal/options.h"
#include "app/terminal/progress_line.h"
#include "foundation/text/counted.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/plain_text.h"
#include "storage/files/log_left.h"
#include "storage/queries/verification.h"

#include <lacuna/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace lacuna {
namespace {

struct VerifyOptions {
  std::filesystem::path database;
  bool quiet = false;
};

std::string numbers(const std::vector<RunId>& runs) {
  std::vector<std::int64_t> all;
  for (const RunId run : runs) all.push_back(run.value);
  return fmt::format("{} {}", runs.size() == 1 ? "run" : "runs", fmt::join(all, ", "));
}

void print(const Verification& found) {
  for (const BrokenSeal& broken : found.seals.broken)
    fmt::print("run {}, table {}: changed since the run ended: {}\n", broken.run.value, broken.table,
               plain_text(broken.reason));
  for (const std::string& damage : found.damage) fmt::print("{}\n", plain_text(damage));
  if (!found.seals.not_ended.empty())
    fmt::print("not checked, because they have not ended: {}\n", numbers(found.seals.not_ended));
  if (!found.seals.ended_unsealed.empty())
    fmt::print("not checked, because an older version stored no hashes for them: {}\n",
               numbers(found.seals.ended_unsealed));
}

/// And what `lacuna run --resume`, `replay` and `reproduce` would find.
Verification verified(Database& database, const std::function<void(double)>& progress) {
  Verification found = verify(database, progress);
  try {
    for (std::string& fault : faults_of_runs(database)) found.damage.push_back(std::move(fault));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& unreadable) {  // which runs there are
    found.damage.emplace_back(unreadable.what());
  }
  return found;
}

void verify_database(const VerifyOptions& options) {
  refuse_empty(options.database);
  const LogLeft log(options.database);
  Database database = Database::open_read_only(options.database, when_interrupted());
  const Verification found = [&] {
    ProgressLine line(options.quiet);
    return verified(database, [&](double part) { line.show({.what = "hashes of runs", .fraction = part}); });
  }();
  if (!options.quiet) print(found);
  const std::string name = plain_text(options.database.string());
  if (!found.is_sound())
    throw Error(name +
                ": differs from what was stored; keep the file, and restore a backup (lacuna backup makes them)");
  if (options.quiet) return;
  const std::size_t sealed = found.seals.sealed.size();
  fmt::print("{}: {}\n", name,
             sealed > 0 ? counted(sealed, "run") + " as stored" : "intact, but no run has hashes to check against");
}

}  // namespace

void add_verify_command(CLI::App& program) {
  auto options = std::make_shared<VerifyOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("verify", "Check a database against its stored hashes");
  add_database_argument(*command, options->database);
  command->add_flag("--quiet", options->quiet, "Print nothing if the database matches its hashes, otherwise one line");
  command->callback([options] { verify_database(*options); });
}

}  // namespace lacuna
