#include "report/pages/page_answers.h"

namespace lacuna {
namespace {
constexpr std::size_t kMostBytes = 32'000'000;
}

PageAnswers::Text PageAnswers::find(const std::string& stamp, const std::string& question) {
  const std::lock_guard lock(mutex_);
  if (stamp != stamp_ || bytes_ > kMostBytes) {
    answers_.clear();
    bytes_ = 0;
    stamp_ = stamp;
  }
  const auto known = answers_.find(question);
  return known == answers_.end() ? nullptr : known->second;
}

void PageAnswers::keep(const std::string& stamp, const std::string& question, const Text& answer) {
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = question.size() + answer->size();
  if (stamp != stamp_ || bytes > kMostBytes / 4) return;
  bytes_ += bytes;
  answers_.insert_or_assign(question, answer);
}

}  // namespace lacuna
