#include "config/reading.h"

namespace lacuna {

void Reading::problem(const SourceLocation& location, const std::string& message) {
  problems_->add(location, path_.empty() ? message : path_ + ": " + message);
}

Reading::Step::Step(Reading& reading, const std::string& key) : reading_(reading), length_(reading.path_.size()) {
  reading.path_ += (reading.path_.empty() ? "" : ".") + key;
}

Reading::Step::Step(Reading& reading, std::size_t index) : reading_(reading), length_(reading.path_.size()) {
  reading.path_ += "[" + std::to_string(index) + "]";
}

}  // namespace lacuna
