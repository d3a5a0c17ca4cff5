#pragma once

#include <filesystem>

namespace hidden_effects {

/// A folder that begins empty and goes away with its content, unless it is to be kept. What an interrupted run left
/// there is deleted; of a folder with anything else in it nothing is touched: throws `std::invalid_argument`.
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
};

}  // namespace hidden_effects
