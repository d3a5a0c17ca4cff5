#pragma once

#include <filesystem>

namespace hidden_effects {

/// A folder that begins empty and goes away with its content, unless it is to be kept. One that an interrupted run left
/// (a file `.unfinished` stands in it, also where an exception ended a run that keeps its folders) is emptied; of a
/// folder with anything else in it nothing is touched: throws `std::invalid_argument`.
class CaseFolder {
 public:
  CaseFolder(std::filesystem::path path, bool keep);
  ~CaseFolder();
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool keep_;
  int exceptions_;  ///< under way when it was made
};

}  // namespace hidden_effects
