#include "commands/commands.h"
#include "commands/not_empty.h"

#include "calibration/calibrate.h"
#include "dirty/dirty_plan.h"
#include "figures/figure_values.h"
#include "foundation/files/whole_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

struct CalibrateOptions {
  std::string set = "dirty-tuning", version;
  fs::path database, out;
};

/// Of a verdict that was too rare to be calibrated nothing is stated.
void add_stated(const lacuna::Calibration& calibration, const JudgedVerdict& one, std::vector<Stated>& to) {
  const auto known = calibration.find(one.verdict);
  if (known != calibration.end()) to.push_back({known->second.probability(one.evidence), one.is_right});
}

/// Stated probabilities, of the calibration of all and of that without the rig.
struct Told {
  std::vector<Stated> own, left_out;
};

Told told_by(const std::vector<JudgedVerdict>& verdicts, const lacuna::ShippedCalibration& calibration) {
  Told told;
  for (const JudgedVerdict& one : verdicts) {
    add_stated(calibration.all, one, told.own);
    add_stated(calibration.without.at(one.rig), one, told.left_out);
  }
  if (told.own.empty() || told.left_out.empty())
    throw std::invalid_argument(
        fmt::format("{} verdicts are too few: none came often enough to be calibrated and tried on a rig left out",
                    verdicts.size()));
  return told;
}

/// How far off the probabilities are on the rigs that they were not fitted to, and on the cases that they were.
void tell_errors(const Told& told) {
  const auto& [own, left_out] = told;
  fmt::print("{} verdicts; calibration error {:.3f}, on rigs left out {:.3f} (Brier score {:.3f} and {:.3f})\n",
             own.size(), calibration_error(own), calibration_error(left_out), brier_score(own), brier_score(left_out));
}

void calibrate(const CalibrateOptions& options) {
  if (!dirty::is_dirty_set(options.set) || options.set == "dirty-reporting")
    throw std::invalid_argument(fmt::format(
        "--set {}: probabilities are fitted to a dirty set, and judged on dirty-reporting; take dirty-tuning",
        options.set));
  if (!fs::exists(options.database))
    throw std::invalid_argument(options.database.string() + ": no such database; `run` makes one");
  const Database database(options.database, Access::read);
  const std::string version = options.version.empty() ? last_version(database, options.set) : options.version;
  const std::vector<JudgedVerdict> verdicts = judged_verdicts(database, version, options.set);
  if (verdicts.empty()) throw std::invalid_argument("the database has no verdict to calibrate on");
  const lacuna::ShippedCalibration calibration = calibrate_and_leave_out(verdicts);
  if (calibration.without.size() < 2)
    throw std::invalid_argument("the verdicts are of one rig alone; what is fitted to it cannot be tried on another");
  const Told told = told_by(verdicts, calibration);
  const std::string source = fmt::format("lacuna-benchmark hidden-effects calibrate --set {} --version {}: {} verdicts",
                                         options.set, version, verdicts.size());
  lacuna::write_whole(options.out, lacuna::calibration_json(calibration, source), lacuna::Link::followed);
  tell_errors(told);
}

}  // namespace

void add_calibrate_command(CLI::App& program) {
  auto options = std::make_shared<CalibrateOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("calibrate", "Fit the probabilities of verdicts to how often they were right");
  command->add_option("--db", options->database, "Database that `run` wrote")
      ->required()
      ->check(not_empty())
      ->option_text("FILE");
  command->add_option("--set", options->set, "A dirty set but dirty-reporting (default: dirty-tuning)")
      ->option_text("SET");
  command->add_option("--version", options->version, "Version of the method (default: the one begun last)")
      ->check(not_empty())
      ->option_text("TEXT");
  command->add_option("--out", options->out, "File to write: platform/answer/calibration.json")
      ->required()
      ->option_text("FILE");
  command->callback([options] { calibrate(*options); });
}

}  // namespace hidden_effects
