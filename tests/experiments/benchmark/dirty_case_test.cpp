#include "dirty/dirty_case.h"
#include "dirty/owner_error.h"
#include "dirty/write_dirty_case.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace hidden_effects::dirty {
namespace {

/// Cases that take well under a second: a fall, an imposed motion, a wheel, a driven slider, a servo and a pendulum.
constexpr int kCheap[] = {3, 5, 7, 16, 21, 45};

const DirtyCase& cheap_case(int number) {
  static std::map<int, DirtyCase> made;
  if (!made.contains(number))
    made[number] = make_dirty_case(plan_dirty_cases("dirty-quick")[static_cast<std::size_t>(number)]);
  return made[number];
}

std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    files[file.path().filename().string()] = lacuna::read_bytes(file.path());
  return files;
}

TEST(DirtyCase, IsTheSameFromTheSameSeedByteForByte) {
  for (const int number : kCheap) {
    const lacuna::TestFolder first, second;
    write_dirty_case(cheap_case(number), first.path());
    write_dirty_case(make_dirty_case(cheap_case(number).plan), second.path());
    const auto files = files_in(first.path());
    EXPECT_GE(files.size(), 3U);
    EXPECT_EQ(files, files_in(second.path())) << number;
  }
}

TEST(DirtyCase, SharesAreWhatRolesSay) {
  for (const int number : kCheap) {
    const DirtyCase& made = cheap_case(number);
    const auto mains = std::count_if(made.effects.begin(), made.effects.end(),
                                     [](const DirtyEffect& one) { return one.role == Role::main; });
    EXPECT_EQ(mains, made.plan.mains) << number;
    if (made.plan.mains == 0) {
      EXPECT_LT(made.error, 1.0) << number;
      continue;
    }
    EXPECT_GE(made.error, 1.5) << number;
    double sum = 0.0;
    for (const DirtyEffect& one : made.effects) {
      const bool is_main = one.role == Role::main;
      EXPECT_TRUE(is_main ? one.share >= 0.20 : one.share <= 0.15) << number << one.what(made.rig.stated) << one.share;
      sum += one.share;
    }
    if (made.plan.mains == 1) {
      EXPECT_NEAR(sum, 1.0, 0.3) << number;
    }
  }
}

/// A model with all that is really there, at its true values, predicts what is read without noise.
TEST(DirtyCase, TheTruthExplainsTheReadings) {
  for (const int number : kCheap) {
    const DirtyCase& made = cheap_case(number);
    std::vector<TrueTrial> trials;
    for (const TrialPlan& trial : made.rig.trials)
      trials.push_back(carry_out(made.rig, made.truth, trial, made.recording.white, 7));
    OwnerModel model{made.truth.spec, {}, {}, made.truth.finer};
    Truth read = made.truth;
    read.laws.clear();
    for (const DirtyEffect& one : made.effects) {
      if (!one.kind || one.kind->law.place == Place::sensor) continue;
      const auto at = std::find(made.truth.laws.begin(), made.truth.laws.end(), one.law);
      model.of_truth.push_back(static_cast<std::size_t>(at - made.truth.laws.begin()));
      model.laws.push_back(one.law);
    }
    const OwnerError error(made.rig, made.truth, trials, made.noise, {});
    EXPECT_LT(error.unfitted(model, clean_readings(read, trials)), 0.05) << number;
  }
}

/// Readings scatter about the noise-free ones as the recording says.
TEST(DirtyCase, RecordsWithItsNoise) {
  const DirtyCase& made = cheap_case(16);
  const TrueTrial trial = carry_out(made.rig, made.truth, made.rig.trials.front(), made.recording.white, 7);
  const DenseReadings clean = read_densely(made.truth.spec, made.truth.laws, trial, 0);
  double sum = 0.0;
  for (const std::vector<double>& row : made.recorded.front().table.rows) {
    const auto place = static_cast<std::size_t>(std::lround(row[0] / clean.interval));
    sum += std::pow(row.back() - clean.values[std::min(place, clean.values.size() - 1)], 2);
  }
  const double rms = std::sqrt(sum / static_cast<double>(made.recorded.front().table.rows.size()));
  EXPECT_GT(rms, 0.5 * made.noise[0]);
  EXPECT_LT(rms, 2.0 * made.noise[0]);
}

TEST(DirtyKind, EveryAcceptedNameStandsSomewhere) {
  const PlantSpec stated = draw_rig(plan_dirty_cases("dirty-quick")[8]).stated;  // a pendulum with a motor
  for (const DirtyKind& kind : dirty_kinds()) {
    EXPECT_FALSE(accepted_at(kind.accepted, stated, 0).empty()) << kind.law.name;
    EXPECT_NE(std::find(kind.accepted.begin(), kind.accepted.end(), kind.law.effect), kind.accepted.end())
        << kind.law.name;
  }
}

TEST(DirtyKind, AWrongMassIsNamedByItsAddressAndItsStandIns) {
  const PlantSpec stated = draw_rig(plan_dirty_cases("dirty-quick")[8]).stated;
  const std::vector<std::string> heavier = accepted_for({Quantity::mass, 0}, 2.0, stated);
  EXPECT_EQ(heavier.front(), "wrong_value @ body.arm.mass");
  EXPECT_NE(std::find(heavier.begin(), heavier.end(), "payload @ body.arm"), heavier.end());
  const std::vector<std::string> lighter = accepted_for({Quantity::mass, 0}, 0.5, stated);
  EXPECT_EQ(std::find(lighter.begin(), lighter.end(), "payload @ body.arm"), lighter.end());
}

}  // namespace
}  // namespace hidden_effects::dirty
