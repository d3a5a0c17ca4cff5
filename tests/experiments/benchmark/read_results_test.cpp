#include "runs/read_results.h"

#include "documents/diagnosis_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What the program itself writes.
TEST(ReadDiagnosis, TakesWhatTheProgramWrites) {
  lacuna::Diagnosis diagnosis;
  diagnosis.verdict = lacuna::Verdict::effect_found;
  diagnosis.probability = 0.75;
  diagnosis.p_by_chance = 0.01;
  diagnosis.method = lacuna::DiagnosisMethod::prediction;
  diagnosis.base = {lacuna::ChannelError{}};
  diagnosis.base_times_floor = 3.5;
  diagnosis.seconds = 12.0;
  diagnosis.next_test = "triangle motor 0.3 N*m 0.1 Hz 20 s";
  lacuna::RankedModel model;
  model.effects = {{"coulomb_friction", "joint.hinge", {{"torque", "N*m", 0.2, 0.1, 0.3}}},
                   {"mount_tilt", "world", {{"angle", "rad", 0.05, kNone, kNone}}}};
  model.look_alikes = {"joint_offset_torque @ joint.hinge", "mount_tilt @ world"};
  model.gain.value = 40.0;
  diagnosis.ranking = {model};
  diagnosis.values = {{"body.arm.mass", "kg", 1.0, 0.9, kNone}};

  const DiagnosisRecord record = read_diagnosis(lacuna::diagnosis_json(diagnosis));
  EXPECT_EQ(record.verdict, "effect_found");
  EXPECT_EQ(record.probability, 0.75);
  EXPECT_EQ(record.times_floor, 3.5);
  EXPECT_EQ(record.next_test, "triangle motor 0.3 N*m 0.1 Hz 20 s");
  ASSERT_EQ(record.ranking.size(), 1U);
  const RankedModelRecord& first = record.ranking.front();
  EXPECT_EQ(first.gain, 40.0);
  EXPECT_EQ(first.effects.at(0).what, (EffectAt{"coulomb_friction", "joint.hinge"}));
  EXPECT_EQ(first.effects.at(0).parameters.at(0).upper, 0.3);
  EXPECT_TRUE(std::isnan(first.effects.at(1).parameters.at(0).lower));
  EXPECT_EQ(first.look_alikes.at(0), (EffectAt{"joint_offset_torque", "joint.hinge"}));
  EXPECT_EQ(first.look_alikes.at(1), (EffectAt{"mount_tilt", "world"}));
  EXPECT_EQ(record.values.at(0).parameter, "body.arm.mass");
  EXPECT_EQ(record.values.at(0).lower, 0.9);
  EXPECT_TRUE(std::isnan(record.values.at(0).upper));
}

TEST(ReadDiagnosis, RefusesAnythingElse) {
  EXPECT_THROW(read_diagnosis(""), std::runtime_error);
  EXPECT_THROW(read_diagnosis("{\"verdict\": 3}"), std::runtime_error);
}

TEST(ReadComparison, TakesTheHeldOutErrors) {
  const ReadComparison read = read_comparison(R"({"pooled": [
      {"channel": "angle", "held_out": false, "failed_trials": 0, "rmse": 0.1},
      {"channel": "angle", "held_out": true, "failed_trials": 0, "rmse": 0.2},
      {"channel": "speed", "held_out": true, "failed_trials": 1, "rmse": 0.3}]})");
  ASSERT_EQ(read.held_out.size(), 2U);
  EXPECT_EQ(read.held_out[0].value, 0.2);
  EXPECT_TRUE(std::isnan(read.held_out[1].value));
}

}  // namespace
}  // namespace hidden_effects
