#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace lacuna {

/// What was answered since the database last changed, so that several viewers cost little more than one. Several
/// threads may ask.
class PageAnswers {
 public:
  using Text = std::shared_ptr<const std::string>;  // shared: with answers under way

  /// Null: not yet.
  Text find(const std::string& stamp, const std::string& question);
  void keep(const std::string& stamp, const std::string& question, const Text& answer);

 private:
  std::mutex mutex_;
  std::string stamp_;
  std::map<std::string, Text> answers_;
  std::size_t bytes_ = 0;
};

}  // namespace lacuna
