#include "bench/timed_run.h"

#include "app/runs/replicates.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace lacuna {
namespace {

class NoJournal : public EeaJournal {
 public:
  void add(ModelRow) override {}
  void add(TestRow) override {}
  void add(TargetTrialRow, const Trial&) override {}
  void add_prediction(std::uint64_t, int, const TimeSeries&, const TimeSeries&) override {}
  void add(PassRow) override {}
  void note_failure(const FailedTrialRecord&) override {}
  void checkpoint(const EeaState&, bool) override {}
};

OpenEeaRun bench_of(const std::filesystem::path& experiment, int passes) {
  CommonOptions options;
  options.experiment = experiment;
  options.overrides = {fmt::format("experiment.passes={}", passes)};
  options.plugin_paths = {LACUNA_PLUGINS_DIRECTORY};
  return OpenEeaRun(open_experiment(options));
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<PassRow> passes_of_run(const OpenEeaRun& opened, const std::filesystem::path& file, int threads) {
  for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(file.string() + ending);
  Database database = Database::open(file);
  ResultStore store(database);
  const RunId run = store.begin_run({"bench_run", 1, threads}, provenance_of_this_program());
  const Experiment& experiment = opened.opened().experiment;
  const ExperimentId id =
      store.record_experiment({experiment.name, experiment.file.string(), experiment.text, experiment.overrides});
  store.hand_over();
  const std::vector<PlannedReplicate> planned = {{run, 1}};
  Replicates replicates(opened, database, id);
  replicates.enter(planned);
  RunDisplay display(planned, true, nullptr);
  const std::vector<ReplicateEnd> ends = replicates.run(planned, threads, display);
  if (ends.front().ending != RunEnding::done) throw Error(ends.front().problem);
  return ends.front().passes;
}

/// Runs `work` in a process of its own.
pid_t begin_process(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child < 0) throw Error("no process could be made");
  if (child > 0) return child;
  try {
    work();
    _exit(EXIT_SUCCESS);
  } catch (...) {
    _exit(EXIT_FAILURE);
  }
}

void await(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS)
    throw Error("a process of the comparison failed");
}

}  // namespace

TimedRun::TimedRun(const std::filesystem::path& experiment, int passes)
    : opened_(bench_of(experiment, passes)),
      folder_(std::filesystem::temp_directory_path() / fmt::format("lacuna-bench-{}", getpid())) {
  std::filesystem::create_directories(folder_);
}

TimedRun::~TimedRun() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

double TimedRun::stored(int threads) const {
  return seconds_of([&] { passes_of_run(opened_, folder_ / "run.db", threads); });
}

double TimedRun::unstored(int threads) const {
  return seconds_of([&] {
    NoJournal journal;
    EeaState state = beginning(opened_);
    const ReplicateTarget target(opened_, 1, 1);
    eea_loop({.definition = opened_.definition(),
              .journal = journal,
              .seed = 1,
              .replicate = 1,
              .work = {threads},
              .truth = opened_.truth(1),
              .target = opened_.target() ? &opened_.target()->structure.robot : nullptr,
              .progress = {}},
             target.target(), state);
  });
}

double TimedRun::two_processes() const {
  return seconds_of([&] {
    std::array<pid_t, 2> children = {};
    for (std::size_t i = 0; i < children.size(); ++i)
      children[i] = begin_process([&] { passes_of_run(opened_, folder_ / fmt::format("process-{}.db", i), 1); });
    for (const pid_t child : children) await(child);
  });
}

/// The naive loop simulates every individual of every generation on all trials to their end; the population and the
/// number of generations are the search's parameters.
RunSteps TimedRun::steps() const {
  const EeaDefinition& definition = opened_.definition();
  const ParameterDeclarations declared = definition.estimation.strategy->parameters();
  const auto parameter = [&](const char* name) {
    for (std::size_t i = 0; i < declared.size(); ++i)
      if (declared[i].name == name) return static_cast<std::uint64_t>(definition.estimation.strategy.parameters[i]);
    throw Error(std::string("the search has no parameter \"") + name + "\" to count the naive loop's steps by");
  };
  const auto in_trial = static_cast<std::uint64_t>(
      std::llround(opened_.opened().experiment.test.duration / definition.model.engine.step));
  RunSteps steps;
  for (const PassRow& pass : passes_of_run(opened_, folder_ / "steps.db", 2)) {
    const std::uint64_t of_model = in_trial * static_cast<std::uint64_t>(pass.number);
    steps.taken += pass.steps;
    steps.without_survivors += pass.evaluations * of_model;
    steps.naive += parameter("population") * parameter("generations") * of_model;
  }
  return steps;
}

}  // namespace lacuna
