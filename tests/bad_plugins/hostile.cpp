#include "bad_effect.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <clocale>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

/// Components that do in one of their calls what the variable HOSTILE says, as in "add_loads exit" or
/// "describe segfault 3", from the third time on that it is called in a process; where the variable HOSTILE_ONCE names
/// a file, only the process that makes this file does it. Where HOSTILE_LATER is set, it waits until it is used in
/// earnest: it does nothing in the process that tries it. Hooks always wait.
namespace {

struct Trouble {};

struct UnspeakableTrouble : std::exception {
  const char* what() const noexcept override { std::abort(); }
};

/// Each call needs the one within it, so that the compiler makes no loop of it.
int recurse(int depth) {
  volatile char frame[4096];
  frame[depth % 4096] = static_cast<char>(depth);
  return depth < 0 ? 0 : recurse(depth + 1) + frame[depth % 4096];
}

[[noreturn]] void hang() {
  for (;;) pause();
}

[[noreturn]] void eat_memory() {
  for (std::vector<std::vector<char>> all;;) all.emplace_back(std::size_t{1} << 28, 'x');
}

void block_interrupts() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

void flush_denormals() {
#if defined(__SSE__)
  _mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
}

/// Aborts when the call has returned; the first time alone, for two threads that abort at once hide each other.
void abort_later() {
  static std::atomic_flag done = ATOMIC_FLAG_INIT;
  if (done.test_and_set()) return;
  std::thread([] {
    usleep(20'000);
    std::abort();
  }).detach();
}

const std::map<std::string, std::function<void()>>& deeds() {
  static const std::map<std::string, std::function<void()>> all = {
      {"exit", [] { std::exit(0); }},
      {"_exit", [] { _exit(0); }},
      {"abort", [] { std::abort(); }},
      {"terminate", [] { std::terminate(); }},
      {"segfault", [] { raise(SIGSEGV); }},
      {"kill", [] { raise(SIGKILL); }},
      {"throw", [] { throw Trouble{}; }},
      {"throw_unspeakable", [] { throw UnspeakableTrouble(); }},
      {"hang", hang},
      {"stop", [] { raise(SIGSTOP); }},
      {"stack", [] { recurse(0); }},
      {"thread", [] { std::thread([] { throw Trouble{}; }).join(); }},
      {"abort_later", abort_later},
      {"pthread_exit", [] { pthread_exit(nullptr); }},
      {"abort_at_exit", [] { std::atexit([] { std::abort(); }); }},
      {"hang_at_exit", [] { std::atexit([] { hang(); }); }},
      {"hog", eat_memory},
      {"fesetround", [] { std::fesetround(FE_UPWARD); }},
      {"flush_denormals", flush_denormals},
      {"feenableexcept", [] { feenableexcept(FE_DIVBYZERO | FE_INVALID); }},
      {"setlocale", [] { std::setlocale(LC_ALL, "C.UTF-8"); }},
      {"chdir",
       [] {
         if (chdir("/") != 0) std::abort();
       }},
      {"umask", [] { umask(0); }},
      {"block_interrupts", block_interrupts},
      {"ignore_interrupts", [] { signal(SIGINT, SIG_IGN); }},
      {"alarm", [] { alarm(1000); }},
      {"close_output", [] { close(STDOUT_FILENO); }},
      {"set_terminate", [] { std::set_terminate([] { _exit(0); }); }},
  };
  return all;
}

bool has_been_done() {
  const char* const file = std::getenv("HOSTILE_ONCE");
  if (file == nullptr) return false;
  const int made = open(file, O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (made >= 0) close(made);
  return made < 0;
}

/// The process that tries a component is a child of the one that has loaded the library.
bool is_tried() {
  static const pid_t loaded_by = getpid();
  return getpid() != loaded_by;
}

bool waits(const std::string& where) {
  const bool is_hook = where == "add_loads" || where == "amend" || where == "state_size";
  return is_tried() && (is_hook || std::getenv("HOSTILE_LATER") != nullptr);
}

void misbehave(const std::string& where) {
  const bool has_to_wait = waits(where);  // also where nothing is ordered, so that it knows who has loaded it
  const char* const variable = std::getenv("HOSTILE");
  if (variable == nullptr || has_to_wait) return;
  static std::atomic<int> calls = 0;
  const std::string order = variable;
  const std::size_t deed = order.find(' '), count = order.find(' ', deed + 1);
  if (order.substr(0, deed) != where) return;
  const int wanted = count == std::string::npos ? 1 : std::atoi(order.c_str() + count);
  if (++calls >= wanted && !has_been_done()) deeds().at(order.substr(deed + 1, count - deed - 1))();
}

/// Static initialisers run when a library is loaded.
const struct Loaded {
  Loaded() { misbehave("load"); }
} loaded;

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
  int state_size(const lacuna::EffectContext&) const override {
    misbehave("state_size");
    return 0;
  }
  void amend(lacuna::RobotSpec&, const lacuna::EffectContext&) const override { misbehave("amend"); }
  void add_loads(const lacuna::StepView&, const lacuna::EffectContext&, std::span<const double>,
                 lacuna::StepLoads&) const override {
    misbehave("add_loads");
  }
};

class Accumulator : public lacuna::ScoreAccumulator {
 public:
  ~Accumulator() override { misbehave("destructor"); }
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

#define lacuna_plugin sound_table
LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, Effect>("hostile"),
              lacuna::component<lacuna::PhysicalEffect, bad::Effect>("harmless_neighbour"),
              lacuna::component<lacuna::FitnessMetric, Metric>("hostile_metric"),
              lacuna::component<lacuna::SearchStrategy, Searching>("hostile_search"))
#undef lacuna_plugin

extern "C" __attribute__((visibility("default"))) const lacuna::PluginTable* lacuna_plugin() {
  misbehave("lacuna_plugin");
  return sound_table();
}
