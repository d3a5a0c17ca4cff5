#include "runs/settle.h"

#include "cases/write_case.h"
#include "runs/carried_out_test.h"
#include "runs/random_test.h"
#include "runs/settling_question.h"

#include <fmt/format.h>

#include <functional>
#include <exception>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCommandFile = "commands.csv";

/// Of what is random here, beside those of the case (cases/make_case.cpp).
enum SettlingStream : std::uint64_t { kLines = 5000, kOtherSeeds = 5001, kTestNoise = 5100 };

/// The test after these, given the last diagnosis.
using NextLine = std::function<std::string(const DiagnosisRecord& last)>;

class Settling {
 public:
  Settling(const MadeCase& made, const DiagnosisRecord& first, const fs::path& folder, const ProgramSettings& settings)
      : made_(made), first_(first), folder_(folder), settings_(settings) {}

  std::optional<SettlingRecord> run() {
    const std::optional<SettlingQuestion> question = question_of(first_);
    if (!question) return std::nullopt;
    question_ = *question;
    SettlingRecord record{question_.answer, question_.rival, "", {}};
    if (question_.answer.effect == question_.rival.effect) {
      record.left_out = "both are one effect, at two places";
      return record;
    }
    record.runs = {no_tests()};
    if (record.runs.front().remaining.effect.empty()) {
      record.runs.push_back(chosen_tests());
      record.runs.push_back(random_tests());
    }
    return record;
  }

 private:
  SettlingRun no_tests() const {
    return carefully("none", [&](SettlingRun& run) {
      write_case(made_, folder_ / run.choice);
      UserSession session(settings_, folder_ / run.choice, {});
      run.remaining = remaining(question_, session.diagnose_among(question_.among));
    });
  }

  SettlingRun chosen_tests() const {
    Draw draw(made_.plan.seed, kOtherSeeds);
    std::string line;
    const NextLine next_line = [&](const DiagnosisRecord& last) {
      return line = last.next_test.empty() ? reseeded_test(line, draw) : last.next_test;
    };
    return carefully("chosen", [&](SettlingRun& run) { carry_out_tests(run, next_line); });
  }

  SettlingRun random_tests() const {
    Draw draw(made_.plan.seed, kLines);
    const NextLine next_line = [&](const DiagnosisRecord&) {
      return random_test(command_ranges(made_), duration_of_test(first_.next_test), draw);
    };
    return carefully("random", [&](SettlingRun& run) { carry_out_tests(run, next_line); });
  }

  /// What goes wrong is a sentence beside what was done before.
  static SettlingRun carefully(const std::string& choice, const std::function<void(SettlingRun&)>& fill) {
    SettlingRun run{choice, {}, {}, ""};
    try {
      fill(run);
    } catch (const CaseStopped&) {
      throw;
    } catch (const std::exception& error) {
      run.failure = error.what();
    }
    return run;
  }

  void carry_out_tests(SettlingRun& run, const NextLine& next_line) const {
    const fs::path folder = folder_ / run.choice;
    MadeCase known = made_;
    write_case(known, folder);
    UserSession session(settings_, folder, {});
    DiagnosisRecord last = first_;
    for (std::uint64_t test = 1; test <= kMostSettlingTests && run.remaining.effect.empty(); ++test) {
      const std::string line = next_line(last);
      session.write_commands(line, kCommandFile);
      known.trials.push_back(carried_out_test(known, folder / kCommandFile, mixed(made_.plan.seed, kTestNoise + test)));
      known.trials.back().name = fmt::format("test_{}", test);
      write_case(known, folder);
      last = session.diagnose_among(question_.among);
      run.tests.push_back({line, last.verdict, last.processor_seconds});
      run.remaining = remaining(question_, last);
    }
  }

  const MadeCase& made_;
  const DiagnosisRecord& first_;
  const fs::path folder_;
  const ProgramSettings& settings_;
  SettlingQuestion question_;
};

}  // namespace

std::optional<SettlingRecord> settle(const MadeCase& made, const DiagnosisRecord& first, const fs::path& folder,
                                     const ProgramSettings& settings) {
  return Settling(made, first, folder, settings).run();
}

}  // namespace hidden_effects
