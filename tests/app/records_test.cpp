#include "app/workspace/records.h"
#include "storage/small_database.h"

#include <gtest/gtest.h>

#include <limits>

namespace lacuna {
namespace {

/// Every field has a value that no other has and that is not its own when nothing is said.
FitResult filled_fit() {
  FitResult fit;
  const double infinite = std::numeric_limits<double>::infinity();
  fit.values = {{"body.arm.mass", "kg", 0.5, 1.0 / 3.0, 0.01, 0.31, 0.35, false, true, true},
                {"joint.hinge.damping", "N*m*s/rad", 0.1, 0.0, infinite, 0.0, 2.0, true, false, false}};
  fit.covariance.resize(2, 2);
  fit.covariance << 1e-4, 2e-5, 2e-5, 4e-3;
  fit.stages = {{"segments of 0.1 s", 0.1, 24, 8, 7, 12, true, 1.25, {0.3, 0.2}},
                {"free run", 0.0, 2, 5, 4, 9, true, 1.125, {1.0 / 3.0, 0.0}}};
  fit.starts = 8;
  fit.agreeing = 6;
  fit.cannot_tell = {"only their product"};
  fit.notes = {"a note"};
  fit.simulations = 1234;
  fit.invalid_simulations = 5;
  fit.samples = 6000;
  fit.correlation_time = 0.0375;
  fit.seconds = 2.5;
  return fit;
}

void expect_same(const FittedValue& read, const FittedValue& kept) {
  const auto& [address, unit, start, value, error, lower, upper, at_lower, at_upper, identified] = read;
  EXPECT_EQ(address, kept.address);
  EXPECT_EQ(unit, kept.unit);
  EXPECT_EQ(start, kept.start);
  EXPECT_EQ(value, kept.value);
  EXPECT_EQ(error, kept.standard_error);
  EXPECT_EQ(lower, kept.lower_95);
  EXPECT_EQ(upper, kept.upper_95);
  EXPECT_EQ(at_lower, kept.at_lower_bound);
  EXPECT_EQ(at_upper, kept.at_upper_bound);
  EXPECT_EQ(identified, kept.identified);
}

void expect_same(const FitStage& read, const FitStage& kept) {
  const auto& [name, segment, segments, starts, agreeing, iterations, converged, residual, values] = read;
  EXPECT_EQ(name, kept.name);
  EXPECT_EQ(segment, kept.segment);
  EXPECT_EQ(segments, kept.segments);
  EXPECT_EQ(starts, kept.starts);
  EXPECT_EQ(agreeing, kept.agreeing);
  EXPECT_EQ(iterations, kept.iterations);
  EXPECT_EQ(converged, kept.converged);
  EXPECT_EQ(residual, kept.residual);
  EXPECT_EQ(values, kept.values);
}

/// A new member of what is kept does not compile here until it is written, read and compared.
TEST(Records, AFitIsReadFromTheDatabaseDigitForDigit) {
  const TestFolder folder;
  Database database = Database::open(folder / "rig.db");
  ResultStore store(database);
  store.begin_run({.command = "lacuna fit", .seed = 7, .threads = 1}, {});
  RevisionRecord revision = test::revision_with({});
  revision.free.push_back({"joint.hinge.damping", "N*m*s/rad", 0.0, 2.0, 0.1});
  const RevisionId id =
      store.find_or_add_revision(store.record_experiment({"rig", "rig.toml", "text", {}}), revision).id;
  const FitResult kept = filled_fit();
  store.record_fit(id, fit_record(kept, {}, "settings"));
  const std::optional<StoredFit> stored = store.last_fit_of(id, "settings");
  ASSERT_TRUE(stored);

  const auto [values, covariance, stages, starts, agreeing, cannot_tell, notes, noise, simulations, invalid, samples,
              correlation_time, seconds, stopped] = fit_result(stored->record);
  ASSERT_EQ(values.size(), 2U);
  for (std::size_t i = 0; i < values.size(); ++i) expect_same(values[i], kept.values[i]);
  EXPECT_EQ(covariance, kept.covariance);
  ASSERT_EQ(stages.size(), 2U);
  for (std::size_t i = 0; i < stages.size(); ++i) expect_same(stages[i], kept.stages[i]);
  EXPECT_EQ(starts, kept.starts);
  EXPECT_EQ(agreeing, kept.agreeing);
  EXPECT_EQ(cannot_tell, kept.cannot_tell);
  EXPECT_EQ(notes, kept.notes);
  EXPECT_TRUE(noise.empty()) << "follows from the trials, which the fit weighs anew";
  EXPECT_EQ(simulations, kept.simulations);
  EXPECT_EQ(invalid, kept.invalid_simulations);
  EXPECT_EQ(samples, kept.samples);
  EXPECT_EQ(correlation_time, kept.correlation_time);
  EXPECT_EQ(seconds, kept.seconds);
  EXPECT_FALSE(stopped) << "a fit that was stopped is never read again";
}

}  // namespace
}  // namespace lacuna
