#include "bad_effect.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

/// Components that do in one of their calls what the variable HOSTILE says, as in "add_loads exit" or
/// "describe segfault 3", from the third time on that it is called in a process; where the variable HOSTILE_ONCE names
/// a file, only the process that makes this file does it.
namespace {

struct Trouble {};

/// Each call needs the one within it, so that the compiler makes no loop of it.
int recurse(int depth) {
  volatile char frame[4096];
  frame[depth % 4096] = static_cast<char>(depth);
  return recurse(depth + 1) + frame[depth % 4096];
}

void do_it(const std::string& deed) {
  if (deed == "exit") std::exit(0);
  if (deed == "_exit") _exit(0);
  if (deed == "abort") std::abort();
  if (deed == "terminate") std::terminate();
  if (deed == "segfault") raise(SIGSEGV);
  if (deed == "kill") raise(SIGKILL);
  if (deed == "throw") throw Trouble{};
  if (deed == "hang")
    for (;;) pause();
  if (deed == "stack") recurse(0);
  if (deed == "thread") std::thread([] { throw Trouble{}; }).join();
  if (deed == "hog")
    for (std::vector<std::vector<char>> all;;) all.emplace_back(std::size_t{1} << 28, 'x');
}

bool has_been_done() {
  const char* const file = std::getenv("HOSTILE_ONCE");
  if (file == nullptr) return false;
  const int made = open(file, O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (made >= 0) close(made);
  return made < 0;
}

void misbehave(const std::string& where) {
  const char* const variable = std::getenv("HOSTILE");
  if (variable == nullptr) return;
  static std::atomic<int> calls = 0;
  const std::string order = variable;
  const std::size_t deed = order.find(' '), count = order.find(' ', deed + 1);
  if (order.substr(0, deed) != where) return;
  const int wanted = count == std::string::npos ? 1 : std::atoi(order.c_str() + count);
  if (++calls >= wanted && !has_been_done()) do_it(order.substr(deed + 1, count - deed - 1));
}

class Effect : public bad::Effect {
 public:
  Effect() { misbehave("factory"); }
  lacuna::EffectDescription describe() const override {
    misbehave("describe");
    return bad::Effect::describe();
  }
  lacuna::EffectStages stages() const override {
    misbehave("stages");
    return {};
  }
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext&, std::span<const double>,
                 lacuna::StepLoads&) const override {
    misbehave("add_loads");
  }
};

class Accumulator : public lacuna::ScoreAccumulator {
 public:
  void add(std::span<const double>, std::span<const double>) override { misbehave("add"); }
  double bound() const override { return 0.0; }
  double score() const override { return 1.0; }
  void reset() override {}
};

class Metric : public lacuna::FitnessMetric {
 public:
  std::string summary() const override {
    misbehave("summary");
    return "Broken on purpose";
  }
  std::unique_ptr<lacuna::ScoreAccumulator> accumulator(const lacuna::ComparisonShape&,
                                                        std::span<const double>) const override {
    return std::make_unique<Accumulator>();
  }
};

class Searching : public lacuna::SearchStrategy {
 public:
  std::string summary() const override { return "Broken on purpose"; }
  std::unique_ptr<lacuna::Search> begin(const lacuna::SearchTask&, std::span<const double>) const override {
    misbehave("begin");
    throw lacuna::Error("it has begun");
  }
};

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, Effect>("hostile"),
              lacuna::component<lacuna::PhysicalEffect, bad::Effect>("harmless_neighbour"),
              lacuna::component<lacuna::FitnessMetric, Metric>("hostile_metric"),
              lacuna::component<lacuna::SearchStrategy, Searching>("hostile_search"))
