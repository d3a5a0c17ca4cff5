#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/progress_line.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/plain_text.h"
#include "storage/integrity/backup.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace lacuna {
namespace {

struct BackupOptions {
  std::filesystem::path database, to;
  bool quiet = false;
};

constexpr double kBytesInMegabyte = 1e6;

void make_backup(const BackupOptions& options) {
  refuse_empty(options.database);
  const LogLeft log(options.database);
  ProgressLine line(options.quiet);
  const std::uintmax_t bytes = back_up(options.database, options.to, when_interrupted(), [&](double part) {
    line.show({.what = "copy of " + options.database.filename().string(), .fraction = part});
  });
  if (!options.quiet)
    fmt::print("{}: {:.1f} MB, a checked copy of {}\n", plain_text(options.to.string()),
               static_cast<double>(bytes) / kBytesInMegabyte, plain_text(options.database.string()));
}

}  // namespace

void add_backup_command(CLI::App& program) {
  auto options = std::make_shared<BackupOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("backup", "Copy a database, even while a run writes to it");
  add_database_argument(*command, options->database);
  command->add_option("to", options->to, "File of the copy; it must not exist yet")->required()->option_text("TO");
  command->add_flag("--quiet", options->quiet, "Print nothing");
  command->callback([options] { make_backup(*options); });
}

}  // namespace lacuna
