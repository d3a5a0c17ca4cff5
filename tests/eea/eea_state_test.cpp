#include "eea/definition/eea_state.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <limits>

namespace lacuna {
namespace {

EeaState some_state() {
  EeaState state;
  state.pass = 3;
  state.phase = Phase::exploration;
  state.models = 4711;
  state.tests = 17;
  state.next_test = PendingTest{16, {0.25, -1.0}, 3.5};
  state.best = {{40, {1.0, 2.0}, {{1.0, 2.0}}, 0.125}, {41, {3.0, 4.0}, {{3.0, 4.0}}, 0.25}};
  state.search = {1.0, 2.0, 3.0};
  state.search_begin = 5;
  state.counts.steps = 123456789;
  state.restart = 1;
  state.found = {{42, {5.0, 6.0}, {{5.0, 6.0}}, 0.5, 1}};
  state.trials.resize(3);
  state.trials[1].set_aside_in = 2;
  state.least_surprise = 0.75;
  state.passes_without_progress = 1;
  return state;
}

TEST(EeaState, ComesBackAsItWasSaved) {
  const EeaState state = some_state();
  const EeaState loaded = load_state(save(state));
  EXPECT_EQ(save(loaded), save(state));
  EXPECT_EQ(loaded.phase, Phase::exploration);
  EXPECT_EQ(loaded.next_test->genome, state.next_test->genome);
  EXPECT_EQ(loaded.best[1].model.values, state.best[1].model.values);
  EXPECT_EQ(loaded.counts.steps, state.counts.steps);
  EXPECT_EQ(loaded.found[0].restart, 1);
  ASSERT_EQ(loaded.trials.size(), 3U);
  EXPECT_EQ(loaded.trials[0].set_aside_in, std::nullopt);
  EXPECT_EQ(loaded.trials[1].set_aside_in, 2);
  EXPECT_EQ(loaded.least_surprise, 0.75);
}

TEST(EeaState, ACutOffCheckpointIsRefused) {
  std::vector<double> saved = save(some_state());
  for (std::size_t size = 0; size < saved.size(); ++size)
    EXPECT_THROW(load_state(std::span(saved).first(size)), Error) << size;
  saved.push_back(0.0);
  EXPECT_THROW(load_state(saved), Error);
}

TEST(EeaState, NumbersThatAreNoStateAreRefused) {
  const std::vector<double> saved = save(some_state());
  constexpr std::size_t kPhase = 1, kPass = 2;
  for (const double wrong : {-1.0, 5.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> other_phase = saved;
    other_phase[kPhase] = wrong;
    EXPECT_THROW(load_state(other_phase), Error) << wrong;
  }
  for (const double wrong : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> other_pass = saved;
    other_pass[kPass] = wrong;
    EXPECT_THROW(load_state(other_pass), Error) << wrong;
  }
}

}  // namespace
}  // namespace lacuna
