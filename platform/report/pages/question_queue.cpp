#include "report/pages/question_queue.h"

namespace lacuna {

QuestionQueue::QuestionQueue(int threads, std::size_t most_waiting) : most_waiting_(most_waiting) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this](const std::stop_token& stopped) { do_work(stopped); });
}

QuestionQueue::~QuestionQueue() {
  for (std::jthread& thread : threads_) thread.request_stop();
  threads_.clear();
}

bool QuestionQueue::add(std::function<void()> work, std::function<bool()> is_wanted) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= most_waiting_) std::erase_if(waiting_, [](const Job& job) { return !job.is_wanted(); });
    if (waiting_.size() >= most_waiting_) return false;
    waiting_.push_back({std::move(work), std::move(is_wanted)});
  }
  added_.notify_one();
  return true;
}

void QuestionQueue::do_work(const std::stop_token& stopped) {
  std::unique_lock lock(mutex_);
  while (added_.wait(lock, stopped, [this] { return !waiting_.empty(); })) {
    if (stopped.stop_requested()) return;
    const Job job = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    if (job.is_wanted()) job.work();
    lock.lock();
  }
}

}  // namespace lacuna
