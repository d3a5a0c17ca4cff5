#pragma once

#include <filesystem>

namespace lacuna {

/// A database that may have to be made. Where no run came into it, nothing is left where there was nothing. Must
/// outlive the connections to it.
class NewDatabase {
 public:
  explicit NewDatabase(const std::filesystem::path& file);
  ~NewDatabase();
  NewDatabase(const NewDatabase&) = delete;
  NewDatabase& operator=(const NewDatabase&) = delete;

 private:
  std::filesystem::path file_;
  bool was_there_;
};

}  // namespace lacuna
