#include "runs/case_folder.h"

#include "runs/work_folder.h"

#include <exception>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnfinished = ".unfinished";  ///< stands in a folder while its case is run

bool holds_other_files(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none) && !fs::exists(path / kUnfinished, none) &&
         !(fs::is_directory(path, none) && fs::is_empty(path, none));
}

/// The mark goes last: whoever is ended on the way leaves it.
void remove_mark_last(const fs::path& path, std::error_code& error) {
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error))
    if (entry.path().filename() != kUnfinished) fs::remove_all(entry.path(), error);
  if (!error || !fs::exists(path)) fs::remove_all(path, error);
}

}  // namespace

CaseFolder::CaseFolder(fs::path path, bool keep)
    : path_(std::move(path)), keep_(keep), exceptions_(std::uncaught_exceptions()) {
  if (holds_other_files(path_))
    throw std::invalid_argument(path_.string() +
                                ": is there already, and no interrupted run left it; move it away, or name another "
                                "folder with --work");
  std::error_code error;
  if (fs::exists(path_, error)) remove_mark_last(path_, error);
  if (error) throw std::invalid_argument(path_.string() + ": cannot be emptied: " + error.message());
  make_folder(path_);
  if (!std::ofstream(path_ / kUnfinished).flush())
    throw std::invalid_argument(path_.string() + ": nothing can be written into this folder");
}

CaseFolder::~CaseFolder() {
  std::error_code ignored;
  const bool interrupted = std::uncaught_exceptions() > exceptions_;
  if (!keep_)
    remove_mark_last(path_, ignored);
  else if (!interrupted)
    fs::remove(path_ / kUnfinished, ignored);
}

}  // namespace hidden_effects
