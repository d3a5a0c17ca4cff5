#pragma once

#include "config/toml/toml_node.h"
#include "foundation/text/problem.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace lacuna {

/// The state of reading one file: where in its nesting we are, what has gone wrong so far, and
/// the units of numbers whose dimension cannot be judged here.
class Reading {
 public:
  /// Relative paths in the file are taken from `directory`.
  Reading(ProblemList& problems, std::filesystem::path directory)
      : problems_(&problems), directory_(std::move(directory)) {}

  /// Adds a problem at `location`, with the nesting in front of `message`.
  void problem(const SourceLocation& location, const std::string& message);
  void problem(const TomlNode& node, const std::string& message) { problem(node.location, message); }
  /// The same for the key `key` below the present place.
  void problem_at(const std::string& key, const SourceLocation& location, const std::string& message);
  /// Whether there is a problem at `key` below the present place or anywhere within it.
  bool is_troubled(const std::string& key) const;

  const std::string& path() const { return path_; }
  const std::filesystem::path& directory() const { return directory_; }

  /// The unit that the number at the present place was written with.
  void written_unit(const std::string& unit) { units_[path_] = unit; }
  const std::map<std::string, std::string>& written_units() const { return units_; }

  /// Goes one level down for as long as it lives: "target" → "target.time", "use" → "use[1]".
  class Step {
   public:
    Step(Reading& reading, const std::string& key);
    Step(Reading& reading, std::size_t index);
    ~Step() { reading_.path_.resize(length_); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Reading& reading_;
    std::size_t length_;
  };

 private:
  ProblemList* problems_;
  std::filesystem::path directory_;
  std::string path_;
  std::map<std::string, std::string> units_;
  std::set<std::string> troubled_;  ///< keys with problems
};

}  // namespace lacuna
