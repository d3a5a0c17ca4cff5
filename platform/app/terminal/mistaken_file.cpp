#include "app/terminal/mistaken_file.h"

#include "app/terminal/options.h"
#include "config/experiment_reader.h"
#include "foundation/files/allowed_files.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "foundation/files/special_file.h"
#include "storage/core/database.h"
#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "SQLite format 3";

/// The experiment file that the newest run was made from; empty where that is not known, or not there.
std::string experiment_of(const fs::path& file) try {
  const Database database = Database::open_read_only(file, when_interrupted());
  Statement newest(database, "SELECT file FROM experiment_text ORDER BY id DESC LIMIT 1");
  const std::string experiment = newest.step() ? newest.text(0) : "";
  return why_no_regular_file(experiment).empty() ? experiment : "";
} catch (const Error&) {
  return {};
}

std::string database_of(const fs::path& file) try {
  return read_experiment(file, {}).name + ".db";
} catch (const Error&) {
  return file.stem().string() + ".db";
}

/// The line that was typed, with another file.
std::string line_with(const std::string& other, const std::string& file) {
  std::string line = command_line();
  const std::string before = " " + shell_word(file);
  if (const std::size_t at = line.find(before); at != std::string::npos)
    line.replace(at, before.size(), " " + shell_word(other));
  return line;
}

}  // namespace

bool is_database(const fs::path& file) {
  check_may_read(file);
  if (!why_no_regular_file(file).empty()) return false;
  std::array<char, kMagic.size()> begin{};
  std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), begin.size()) == kMagic;
}

void refuse_database_as_experiment(const std::string& file) {
  if (!is_database(file)) return;
  const std::string experiment = experiment_of(file);
  throw_problem({file}, "is a database, but this command needs an experiment file: " +
                            line_with(experiment.empty() ? "FILE.toml" : experiment, file));
}

void refuse_experiment_as_database(const std::string& file) {
  if (fs::path(file).extension() != ".toml" || !why_no_regular_file(file).empty() || is_database(file)) return;
  const std::string database = database_of(file);
  const bool is_there = why_no_regular_file(database).empty();
  throw_problem({file},
                "is an experiment file, but this command needs a database: " + line_with(database, file) +
                    (is_there ? "" : "; it does not exist yet, make it with lacuna compare " + shell_word(file)));
}

}  // namespace lacuna
