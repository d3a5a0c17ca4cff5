#include "config/toml/reading.h"

namespace lacuna {
namespace {

std::string joined(const std::string& path, const std::string& key) {
  return path.empty() || key.empty() || key.front() == '[' ? path + key : path + "." + key;
}

}  // namespace

void Reading::problem(const SourceLocation& location, const std::string& message) { problem_at("", location, message); }

void Reading::problem_at(const std::string& key, const SourceLocation& location, const std::string& message) {
  const std::string full = joined(path_, key);
  troubled_.insert(full);
  problems_->add_of_key(location, full, message);
}

bool Reading::is_troubled(const std::string& key) const {
  const std::string full = joined(path_, key);
  if (full.empty()) return !troubled_.empty();
  for (auto at = troubled_.lower_bound(full); at != troubled_.end() && at->starts_with(full); ++at)
    if (at->size() == full.size() || (*at)[full.size()] == '.' || (*at)[full.size()] == '[') return true;
  return false;
}

Reading::Step::Step(Reading& reading, const std::string& key) : reading_(reading), length_(reading.path_.size()) {
  reading.path_ = joined(reading.path_, key);
}

Reading::Step::Step(Reading& reading, std::size_t index) : Step(reading, "[" + std::to_string(index) + "]") {}

}  // namespace lacuna
