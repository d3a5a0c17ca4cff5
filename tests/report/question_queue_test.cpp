#include "report/pages/question_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>

namespace lacuna {
namespace {

TEST(QuestionQueueTest, WorksInOrderAndTakesNoMoreThanMayWait) {
  std::promise<void> open, begun;
  std::vector<int> done;
  {
    QuestionQueue queue(1, 2);
    EXPECT_TRUE(queue.add([&] {
      begun.set_value();
      open.get_future().wait();
      done.push_back(0);
    }));
    begun.get_future().wait();
    std::promise<void> last;
    EXPECT_TRUE(queue.add([&] { done.push_back(1); }));
    EXPECT_TRUE(queue.add([&] {
      done.push_back(2);
      last.set_value();
    }));
    EXPECT_FALSE(queue.add([&] { done.push_back(3); }));
    open.set_value();
    last.get_future().wait();
  }
  EXPECT_EQ(done, (std::vector{0, 1, 2}));
}

TEST(QuestionQueueTest, WhatNobodyWantsAnyMoreMakesRoom) {
  std::promise<void> open, begun;
  std::vector<int> done;
  std::atomic<bool> wanted = true;
  {
    QuestionQueue queue(1, 2);
    queue.add([&] {
      begun.set_value();
      open.get_future().wait();
    });
    begun.get_future().wait();
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(queue.add([&] { done.push_back(0); }, [&] { return wanted.load(); }));
    EXPECT_FALSE(queue.add([&] { done.push_back(1); }));
    wanted = false;
    std::promise<void> last;
    EXPECT_TRUE(queue.add([&] {
      done.push_back(2);
      last.set_value();
    }));
    open.set_value();
    last.get_future().wait();
  }
  EXPECT_EQ(done, std::vector{2});
}

TEST(QuestionQueueTest, ForgetsWhatWaitsWhenItEnds) {
  std::atomic<int> done = 0;
  std::promise<void> begun;
  {
    QuestionQueue queue(1, 100);
    queue.add([&] {
      begun.set_value();
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      ++done;
    });
    begun.get_future().wait();
    for (int i = 0; i < 50; ++i) queue.add([&] { done += 100; });
  }
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace lacuna
