#pragma once

#include <lacuna/error.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// A place in a file a user wrote. Lines and columns count from 1; 0: not known.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// `file:line:column`, without unknown parts.
std::string to_string(const SourceLocation& location);

/// One complaint about a user's input: where, what, and what to do.
struct Problem {
  SourceLocation location;
  std::string message;
  std::string key = {};     ///< the key with which the message begins, "model.effects[0].where"; empty: none
  std::string reason = {};  ///< the message without the key and the name of the component; empty: the message
};

/// Thrown for bad input (exit code 2). Its text has one line per problem.
class BadInput : public Error {
 public:
  explicit BadInput(std::vector<Problem> problems);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Collects problems, so that the user sees all of them at once.
class ProblemList {
 public:
  /// A repeated message for the same place, as for each element that a pattern matches, is dropped.
  void add(SourceLocation location, std::string message) { add(Problem{std::move(location), std::move(message)}); }
  void add(Problem problem);
  /// A fault of a key's value: the message begins with the key.
  void add_of_key(SourceLocation location, const std::string& key, const std::string& message) {
    add_of_key(std::move(location), key, message, message);
  }
  void add_of_key(SourceLocation location, const std::string& key, const std::string& message,
                  const std::string& reason);
  bool empty() const { return problems_.empty(); }
  const std::vector<Problem>& all() const { return problems_; }
  /// Throws `BadInput` with everything collected so far, in file and line order, if there is anything.
  void throw_if_any() const;

 private:
  std::vector<Problem> problems_;
  std::set<std::pair<std::string, std::string>> told_;  ///< where, and what
};

/// Throws `BadInput` with one problem.
[[noreturn]] void throw_problem(SourceLocation location, std::string message);

/// " (did you mean \"x\"?)" for the nearest of `candidates`, or nothing if none is near. A candidate is also near if
/// `word` is its beginning or end, up to a point or an underscore: "hinge" of "joint.hinge", "coulomb" of
/// "coulomb_friction".
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

constexpr std::size_t kMostNearest = 5;

/// The nearest of `names` and the number of others: "a, b, c, d, e and 43 more". Of addresses, those of the same kind
/// come first. Up to `kMostNearest` names are all listed.
std::string nearest_names(const std::string& word, std::vector<std::string> names);

}  // namespace lacuna
