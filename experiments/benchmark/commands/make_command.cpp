#include "commands/commands.h"
#include "commands/not_empty.h"
#include "commands/sets_text.h"

#include "cases/make_case.h"
#include "cases/write_case.h"
#include "command_line/whole_number.h"
#include "contacts/contact_plan.h"
#include "dirty/write_dirty_case.h"
#include "foundation/files/whole_file.h"
#include "runs/case_truth.h"
#include "runs/dirty_truth.h"
#include "runs/run_contact_case.h"
#include "runs/selection.h"
#include "runs/work_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

namespace hidden_effects {
namespace {

struct MakeOptions {
  std::string set;
  int number = 0;
  std::filesystem::path out;
  bool truth = false;
};

/// Makes and writes a case; what is hidden in it.
std::string make_planar(const CasePlan& plan, const std::filesystem::path& folder) {
  const MadeCase made = make_case(plan);
  write_case(made, folder);
  return truth_json(plan, about_case(made, ""), true_free_values(made));
}

std::string make_on_ground(const CasePlan& plan, const std::filesystem::path& folder) {
  const MadeContactCase made = make_contact_case(plan, folder);
  return truth_json(plan, about_contact_case(made, ""), true_contact_values(made));
}

std::string make_dirty(const CasePlan& plan, const std::filesystem::path& folder) {
  const dirty::DirtyCase made = dirty::make_dirty_case(dirty_plan_of(plan));
  dirty::write_dirty_case(made, folder);
  return dirty_truth_json(made);
}

std::string make_any(const CasePlan& plan, const std::filesystem::path& folder) {
  if (dirty::is_dirty_set(plan.set)) return make_dirty(plan, folder);
  return is_contact_case(plan) ? make_on_ground(plan, folder) : make_planar(plan, folder);
}

void make(const MakeOptions& options) {
  const std::vector<CasePlan> plans = plans_of_set(options.set);
  if (options.number >= static_cast<int>(plans.size()))
    throw std::invalid_argument(
        fmt::format("--case {}: the set {} has the numbers 0 to {}", options.number, options.set, plans.size() - 1));
  make_folder(options.out);
  if (!std::filesystem::is_empty(options.out))
    throw std::invalid_argument(options.out.string() +
                                ": is not empty; files of another case must not stand beside "
                                "these, so name a new folder");
  const CasePlan& plan = plans[static_cast<std::size_t>(options.number)];
  const std::string truth = make_any(plan, options.out);
  fmt::print("{} is in {}\n", plan.name(), options.out.string());
  if (!options.truth) return;
  lacuna::write_whole(options.out / "truth.json", truth, lacuna::Link::replaced);
}

}  // namespace

void add_make_command(CLI::App& program) {
  auto options = std::make_shared<MakeOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("make", "Write one case as a user would have it");
  command->add_option("--set", options->set, kSets)->required()->option_text("SET");
  command->add_option("--case", options->number, "Its number")
      ->required()
      ->check(lacuna::whole_number(0, 1000000))
      ->option_text("N");
  command->add_option("--out", options->out, "Folder for its files")
      ->required()
      ->check(not_empty())
      ->option_text("FOLDER");
  command->add_flag("--truth", options->truth, "And what is hidden, as truth.json");
  command->callback([options] { make(*options); });
}

}  // namespace hidden_effects
