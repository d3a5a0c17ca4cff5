#pragma once

#include "config/schema/experiment.h"
#include "foundation/processes/guarded_call.h"

#include <cstddef>
#include <string>

namespace lacuna {

/// Collects problems of an experiment at the place of the key that causes them.
class Complaints {
 public:
  explicit Complaints(const Experiment& experiment) : experiment_(experiment) {}

  /// `key` as in "model.effects[0].where[1]".
  void add(const std::string& key, const std::string& message) {
    problems_.add_of_key(experiment_.where(key), key, message);
  }
  void add(const std::string& key, const Error& error) {
    problems_.add_of_key(experiment_.where(key), key, error.what(), reason_of(error));
  }
  /// For a problem at another place, such as in the robot file.
  void add_at(const SourceLocation& place, const std::string& message) { problems_.add(place, message); }
  /// The place of `key`, or of the nearest table around it.
  SourceLocation where(const std::string& key) const { return experiment_.where(key); }
  /// Complains where the number at `key` was written in a unit of another dimension.
  void check_unit(const std::string& key, const std::string& unit) { experiment_.check_unit(key, unit, problems_); }
  std::size_t count() const { return problems_.all().size(); }
  void throw_if_any() const { problems_.throw_if_any(); }

 private:
  const Experiment& experiment_;
  ProblemList problems_;
};

}  // namespace lacuna
