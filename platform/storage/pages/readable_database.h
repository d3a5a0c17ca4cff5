#pragma once

#include "foundation/processes/stop.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace lacuna {

/// A database file as this version of the program reads it: the file itself or, of one that an older version wrote, a
/// copy that was brought up to date, one for each state of the file. Several threads may ask.
class ReadableDatabase {
 public:
  /// Copies are made in the folder `scratch` and go with the last who reads them.
  ReadableDatabase(std::filesystem::path database, std::filesystem::path scratch, const Stop& stop = {});

  /// Where it can be read now. Throws as `Database::open_read_only` does.
  std::shared_ptr<const std::filesystem::path> file();  // shared: by questions under way

 private:
  std::shared_ptr<const std::filesystem::path> find();
  const std::filesystem::path database_, scratch_;
  const Stop stop_;
  std::mutex looking_;
  std::string stamp_;
  std::shared_ptr<const std::filesystem::path> file_;
  int copies_ = 0;
};

}  // namespace lacuna
