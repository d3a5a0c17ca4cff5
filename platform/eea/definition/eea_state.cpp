#include "eea/definition/eea_state.h"

#include <lacuna/error.h>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace lacuna {
namespace {

constexpr double kVersion = 2.0;
constexpr double kLargestCount = 9007199254740992.0;  // 2^53, the last integer that a double counts to

/// Writes numbers one after the other.
class Writer {
 public:
  template <class Number>
  void number(Number value) {
    numbers.push_back(static_cast<double>(value));
  }
  void list(const std::vector<double>& values) {
    number(values.size());
    numbers.insert(numbers.end(), values.begin(), values.end());
  }
  std::vector<double> numbers;
};

class Reader {
 public:
  explicit Reader(std::span<const double> numbers) : numbers_(numbers) {}

  template <class Number>
  void number(Number& value) {
    const double stored = next();
    if constexpr (std::is_integral_v<Number>)  // integers are counts
      if (!(stored >= 0.0 &&
            stored <= std::min(kLargestCount, static_cast<double>(std::numeric_limits<Number>::max()))))
        fail();
    value = static_cast<Number>(stored);
  }
  void list(std::vector<double>& values) {
    const double size = next();
    if (!(size >= 0.0 && size <= static_cast<double>(numbers_.size()))) fail();
    const auto count = static_cast<std::size_t>(size);
    values.assign(numbers_.begin(), numbers_.begin() + static_cast<std::ptrdiff_t>(count));
    numbers_ = numbers_.subspan(count);
  }
  bool ended() const { return numbers_.empty(); }
  [[noreturn]] static void fail() {
    throw Error(
        "the checkpoint comes from another version of this program; run the experiment again from its beginning");
  }

 private:
  double next() {
    if (numbers_.empty()) fail();
    const double value = numbers_.front();
    numbers_ = numbers_.subspan(1);
    return value;
  }

  std::span<const double> numbers_;
};

Phase phase_from(int number) {
  for (const Phase phase : {Phase::trial, Phase::estimation, Phase::exploration, Phase::transfer, Phase::finished})
    if (static_cast<int>(phase) == number) return phase;
  Reader::fail();
}

/// The fields that are stored, for reading and writing.
template <class Archive, class Count>
void archive_counts(Archive& archive, Count& counts) {
  archive.number(counts.evaluations);
  archive.number(counts.abandoned);
  archive.number(counts.reused);
  archive.number(counts.invalid);
  archive.number(counts.steps);
  archive.number(counts.test_evaluations);
  archive.number(counts.invalid_tests);
  archive.number(counts.test_steps);
}

template <class Archive, class State>
void archive_scalars(Archive& archive, State& state) {
  archive.number(state.pass);
  archive.number(state.models);
  archive.number(state.tests);
  archive.number(state.search_begin);
  archive.list(state.search);
  archive.number(state.restart);
  archive.number(state.passes_without_progress);
  archive_counts(archive, state.counts);
}

template <class Archive, class Known>
void archive_model(Archive& archive, Known& model) {
  archive.number(model.number);
  archive.list(model.genome);
  archive.list(model.model.values);
  archive.number(model.score);
  archive.number(model.restart);
}

void archive_models(Writer& writer, const std::vector<KnownModel>& models) {
  writer.number(models.size());
  for (const KnownModel& model : models) archive_model(writer, model);
}

void read_models(Reader& reader, std::vector<KnownModel>& models) {
  std::size_t count = 0;
  reader.number(count);
  for (std::size_t i = 0; i < count; ++i) archive_model(reader, models.emplace_back());
}

}  // namespace

const char* to_string(Phase phase) {
  switch (phase) {
    case Phase::trial: return "trial";
    case Phase::estimation: return "estimation";
    case Phase::exploration: return "exploration";
    case Phase::transfer: return "transfer";
    case Phase::finished: return "finished";
  }
  return "";
}

std::vector<double> save(const EeaState& state) {
  Writer writer;
  writer.number(kVersion);
  writer.number(static_cast<int>(state.phase));
  archive_scalars(writer, state);
  writer.number(state.next_test.has_value() ? 1 : 0);
  if (state.next_test) {
    writer.number(state.next_test->number);
    writer.list(state.next_test->genome);
    writer.number(state.next_test->predicted_fitness);
  }
  archive_models(writer, state.best);
  archive_models(writer, state.found);
  writer.number(state.least_surprise);
  std::vector<double> set_aside;  // one per trial; 0: the trial counts
  for (const TargetTrial& trial : state.trials) set_aside.push_back(trial.set_aside_in.value_or(0));
  writer.list(set_aside);
  return std::move(writer.numbers);
}

EeaState load_state(std::span<const double> saved) {
  Reader reader(saved);
  EeaState state;
  double version = 0.0;
  int phase = 0, has_test = 0;
  reader.number(version);
  if (version != kVersion) Reader::fail();
  reader.number(phase);
  state.phase = phase_from(phase);
  archive_scalars(reader, state);
  reader.number(has_test);
  if (has_test != 0) {
    PendingTest& test = state.next_test.emplace();
    reader.number(test.number);
    reader.list(test.genome);
    reader.number(test.predicted_fitness);
  }
  read_models(reader, state.best);
  read_models(reader, state.found);
  reader.number(state.least_surprise);
  std::vector<double> set_aside;
  reader.list(set_aside);
  for (const double pass : set_aside) {
    if (!(pass >= 0.0 && pass <= std::numeric_limits<int>::max())) Reader::fail();
    TargetTrial& trial = state.trials.emplace_back();
    if (pass > 0.0) trial.set_aside_in = static_cast<int>(pass);
  }
  if (!reader.ended()) Reader::fail();
  return state;
}

}  // namespace lacuna
