#include "commands/commands.h"
#include "commands/not_empty.h"

#include "dirty/dirty_plan.h"
#include "figures/baseline_table.h"
#include "figures/dirty_table.h"
#include "figures/pictures.h"
#include "figures/tables.h"
#include "figures/withheld_table.h"
#include "foundation/files/whole_file.h"
#include "runs/dirty_store.h"
#include "runs/work_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

struct FiguresOptions {
  std::string set = "reporting";
  std::vector<std::string> versions;
  bool every_version = false;
  fs::path database, out;
};

void show_dirty(const Database& database, const FiguresOptions& options) {
  if (options.every_version || options.versions.size() > 1)
    throw std::invalid_argument("the figures of a dirty set are those of one --version");
  const std::string version = options.versions.empty() ? last_version(database, options.set) : options.versions.front();
  const std::vector<CaseResult> results = read_dirty_results(database, version, options.set);
  const bool is_withheld = dirty::plan_dirty_cases(options.set).front().must_be_force;
  const std::string page = is_withheld ? withheld_tables(results) : dirty_tables(results);
  if (options.out.empty()) return fmt::print("{}", page);
  make_folder(options.out);
  lacuna::write_whole(options.out / "figures.md", page, lacuna::Link::replaced);
  fmt::print("figures.md is in {}\n", options.out.string());
}

void show_figures(const FiguresOptions& options) {
  if (!fs::exists(options.database))
    throw std::invalid_argument(options.database.string() + ": no such database; `run` makes one");
  const Database database(options.database, Access::read);
  if (dirty::is_dirty_set(options.set)) return show_dirty(database, options);
  const FigureValues all = read_figures(
      database, options.every_version ? versions_of(database, options.set) : options.versions, options.set);
  const std::string page = markdown(all) + baseline_table(database, all);
  if (options.out.empty()) return fmt::print("{}", page);
  make_folder(options.out);
  lacuna::write_whole(options.out / "figures.md", page, lacuna::Link::replaced);
  draw_pictures(database, all, options.out);
  fmt::print("figures.md and the pictures are in {}\n", options.out.string());
}

}  // namespace

void add_figures_command(CLI::App& program) {
  auto options = std::make_shared<FiguresOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("figures", "What the cases in a database say of the method");
  command->add_option("--db", options->database, "Database that `run` wrote")
      ->required()
      ->check(not_empty())
      ->option_text("FILE");
  command->add_option("--set", options->set, "tuning, reporting, fixed or a dirty set (default: reporting)")
      ->option_text("SET");
  CLI::Option* versions = command
                              ->add_option("--version", options->versions,
                                           "Versions of the method, counted together (default: the one begun last)")
                              ->check(not_empty())
                              ->option_text("TEXT...");
  command->add_flag("--every-version", options->every_version, "All versions, counted together")->excludes(versions);
  command
      ->add_option("--out", options->out,
                   "Folder for figures.md and the pictures (SVG); without it, the figures are printed")
      ->check(not_empty())
      ->option_text("FOLDER");
  command->callback([options] { show_figures(*options); });
}

}  // namespace hidden_effects
