#include "runs/run_case.h"

#include "cases/make_case.h"
#include "cases/write_case.h"
#include "runs/case_loop.h"
#include "runs/case_truth.h"

#include <exception>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

/// A folder that begins empty and goes away with its content, unless it is to be kept.
class CaseFolder {
 public:
  CaseFolder(fs::path path, bool keep) : path_(std::move(path)), keep_(keep) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~CaseFolder() {
    std::error_code ignored;
    if (!keep_) fs::remove_all(path_, ignored);
  }
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  bool keep_;
};

/// What the library is not to have.
std::vector<std::string> withheld(const CaseRecord& about) {
  std::vector<std::string> effects;
  if (about.group == "withheld")
    for (const HiddenLawRecord& law : about.hidden) effects.push_back(law.answer.effect);
  return effects;
}

}  // namespace

CaseResult run_case(const CasePlan& plan, const std::string& version, const fs::path& work, bool keep,
                    const ProgramSettings& settings) {
  const CaseFolder folder(work / plan.name(), keep);
  CaseResult result;
  result.about = about_plan(plan, version);
  try {
    const MadeCase made = make_case(plan);
    write_case(made, folder.path());
    const CaseRecord about = about_case(made, version);
    result = go_through({about, folder.path(), true_free_values(made), withheld(about)}, settings);
  } catch (const CaseStopped&) {
    throw;
  } catch (const std::exception& error) {
    result.failure = std::string("the case cannot be made: ") + error.what();
  }
  return result;
}

}  // namespace hidden_effects
