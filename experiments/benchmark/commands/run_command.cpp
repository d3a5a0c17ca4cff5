#include "commands/commands.h"
#include "commands/lacuna_program.h"
#include "commands/not_empty.h"
#include "commands/sets_text.h"

#include "command_line/whole_number.h"
#include "contacts/contact_plan.h"
#include "dirty/dirty_plan.h"
#include "foundation/text/figure_text.h"
#include "foundation/processes/interrupt.h"
#include "runs/case_store.h"
#include "runs/dirty_store.h"
#include "runs/run_case.h"
#include "runs/run_dirty_case.h"
#include "runs/run_set.h"
#include "runs/selection.h"
#include "runs/work_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  std::string set, cases, part, version;
  fs::path database, work, lacuna;
  int jobs = 1, most_diagnoses = ProgramSettings{}.most_diagnoses;
  int longest = 1800;
  bool keep = false, baselines = false, settle = false, without_oracle = false, again = false;
};

std::string duration_text(double seconds) {
  const auto minutes = static_cast<long>(seconds / 60.0);
  if (minutes < 1) return fmt::format("{:.0f} s", seconds);
  return minutes < 60 ? fmt::format("{} min", minutes) : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

/// "; settled by 2 chosen tests, not by 6 random tests"; nothing where `--settle` was not given.
std::string settling_text(const CaseResult& result) {
  if (!result.settling) return "";
  std::string words;
  for (const SettlingRun& run : result.settling->runs) {
    const bool settled = !run.remaining.effect.empty();
    if (!run.failure.empty()) return "; settling ended early: " + run.failure;
    if (run.choice == "none" && settled) return "; settled without a test";
    if (run.choice == "none") continue;
    words += fmt::format("{} {}by {} {} tests", words.empty() ? "" : ",", settled ? "" : "not ", run.tests.size(),
                         run.choice);
  }
  return words.empty() ? "; no test was carried out" : "; settled" + words;
}

std::string answer_text(const CaseResult& result) {
  if (!result.failure.empty()) return result.failure;
  const DiagnosisRecord& first = result.diagnoses.front();
  std::string words = first.verdict;
  if (first.verdict == "effect_found" && !first.ranking.empty())
    for (const RankedEffectRecord& effect : first.ranking.front().effects)
      words += fmt::format(" {} @ {}", effect.what.effect, effect.what.place);
  if (!std::isnan(first.probability)) words += ", P " + lacuna::probability_text(first.probability);
  return fmt::format("{}, {:.0f} s{}", words, first.seconds, settling_text(result));
}

/// A line a case, with the time that the rest takes if it goes on like this.
class Telling {
 public:
  void operator()(const CaseResult& result, const SetProgress& progress) const {
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    fmt::print(stderr, "{}-{:04} {} · {} left, {}\n", result.about.set, result.about.number, answer_text(result),
               progress.left, duration_text(passed / progress.kept * progress.left));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string failures_text(int failed) {
  return failed == 0 ? "" : fmt::format(", of which {} ended early (--again runs such cases, too)", failed);
}

void run(const RunOptions& options) {
  const std::vector<CasePlan> plans = selected(plans_of_set(options.set), options.cases, options.part);
  const WorkFolder work(options.work);
  ProgramSettings settings = program_settings(options.lacuna, options.longest);
  settings.most_diagnoses = options.most_diagnoses;
  Database database(options.database);
  keep_version(database, options.version, identity_of(settings, work.path()));
  const bool is_dirty = dirty::is_dirty_set(options.set);
  if (is_dirty) make_dirty_table(database);
  const Telling told;
  const SetProgress progress = run_set(
      database, options.version, plans, options.jobs, options.again,
      [&](const CasePlan& plan) {
        if (is_dirty) return run_dirty_case(plan, options.version, work.path(), options.keep, settings);
        return run_case(plan, options.version,
                        {work.path(), options.keep, !options.without_oracle, options.baselines, options.settle},
                        settings);
      },
      [stop = lacuna::when_interrupted()] { return stop.is_due(); }, told);
  fmt::print(stderr, "{} cases run{}, {} were there before, {} left\n", progress.kept, failures_text(progress.failed),
             progress.before, progress.left);
  if (progress.stopped) throw lacuna::Interrupted("interrupted; run the same command again to go on");
}

}  // namespace

void add_run_command(CLI::App& program) {
  auto options = std::make_shared<RunOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("run", "Send the cases that the database does not have through the program");
  command->add_option("--set", options->set, kSets)->required()->option_text("SET");
  command->add_option("--db", options->database, "Database, made if it is not there")
      ->required()
      ->check(not_empty())
      ->option_text("FILE");
  command->add_option("--work", options->work, "Folder for the files of cases under way")
      ->required()
      ->check(not_empty())
      ->option_text("FOLDER");
  command->add_option("--cases", options->cases, "Numbers of the cases (default: all)")
      ->check(not_empty())
      ->option_text("A-B");
  command->add_option("--part", options->part, "The K-th of N equal parts of them")
      ->check(not_empty())
      ->option_text("K/N");
  command->add_option("--jobs", options->jobs, "Cases at a time (default: 1)")
      ->check(lacuna::whole_number(1, 1024))
      ->option_text("J");
  command->add_option("--lacuna", options->lacuna, "The program (default: the one beside this)")
      ->check(not_empty())
      ->option_text("PATH");
  command->add_option("--version", options->version, "Name of the method's version, such as a commit")
      ->required()
      ->check(not_empty())
      ->option_text("TEXT");
  command->add_option("--time-limit", options->longest, "Seconds that one call may take (default: 1800)")
      ->check(lacuna::whole_number(1, 1000000))
      ->option_text("S");
  command->add_option("--diagnoses", options->most_diagnoses, "Of a case at most (default: 3); 1 adds nothing")
      ->check(lacuna::whole_number(1, 100))
      ->option_text("N");
  command->add_flag("--keep", options->keep, "Keep the files of the cases");
  command->add_flag("--baselines", options->baselines, "Ask other methods, too: as long again as a diagnosis");
  command->add_flag("--settle", options->settle,
                    "Carry out the tests that are proposed, and random ones, until the answer is told from its closest "
                    "look-alike: up to thirteen short diagnoses more");
  command->add_flag("--again", options->again, "Run those cases, too, that ended early before");
  command->add_flag("--without-oracle", options->without_oracle, "Do not ask what the data could tell at all");
  command->callback([options] {
    try {
      run(*options);
    } catch (const CaseStopped&) {
      throw lacuna::Interrupted("interrupted; run the same command again to go on");
    }
  });
}

}  // namespace hidden_effects
