#include "runs/case_folder.h"

#include "runs/work_folder.h"

#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnfinished = ".unfinished";  ///< stands in a folder while its case is run

bool is_anybodys(const fs::path& path) {
  std::error_code unreadable;
  return fs::exists(path) && !fs::exists(path / kUnfinished) &&
         !(fs::is_directory(path) && fs::is_empty(path, unreadable));
}

}  // namespace

CaseFolder::CaseFolder(fs::path path, bool keep) : path_(std::move(path)), keep_(keep) {
  if (is_anybodys(path_))
    throw std::invalid_argument(path_.string() +
                                ": is there already, and no interrupted run left it; move it away, or name another "
                                "folder with --work");
  std::error_code error;
  fs::remove_all(path_, error);
  if (error) throw std::invalid_argument(path_.string() + ": cannot be emptied: " + error.message());
  make_folder(path_);
  std::ofstream(path_ / kUnfinished).flush();
}

CaseFolder::~CaseFolder() {
  std::error_code ignored;
  if (keep_)
    fs::remove(path_ / kUnfinished, ignored);
  else
    fs::remove_all(path_, ignored);
}

}  // namespace hidden_effects
