#include "evaluation/revision.h"

#include <gtest/gtest.h>

#include <functional>

namespace lacuna {
namespace {

ModelDefinition pendulum() {
  ModelDefinition model;
  model.structure.robot.name = "pendulum";
  model.structure.robot.bodies.resize(1);
  model.structure.robot.joints.resize(1);
  model.free = {{"body.arm.mass", "kg", 0.1, 2.0, 0.5, Scale::linear, ""}};
  model.effects = {{"friction", "coulomb_friction", {"joint.hinge"}, {{"torque", 0.0}}, {}}};
  return model;
}

std::vector<Trial> one_trial() {
  Trial trial;
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.times = Eigen::Vector2d(0.0, 0.1);
  trial.measured.samples = Eigen::MatrixXd::Constant(2, 1, 0.3);
  return {trial};
}

TEST(RevisionOf, IsTheSameForTheSameModel) {
  EXPECT_EQ(revision_of(pendulum(), one_trial()).digest, revision_of(pendulum(), one_trial()).digest);
}

TEST(RevisionOf, ChangesWithEveryPartOfTheModel) {
  const std::string before = revision_of(pendulum(), one_trial()).digest;
  const std::vector<std::function<void(ModelDefinition&)>> changes = {
      [](ModelDefinition& m) { m.structure.robot.bodies[0].mass = 1.1; },
      [](ModelDefinition& m) { m.structure.robot.joints[0].upper = 1.0; },
      [](ModelDefinition& m) { m.free[0].upper = 3.0; },
      [](ModelDefinition& m) { m.effects[0].fixed = {"torque"}; },
      [](ModelDefinition& m) { m.effects.clear(); },
      [](ModelDefinition& m) { m.engine.substeps = 2; },
  };
  for (const auto& change : changes) {
    ModelDefinition model = pendulum();
    change(model);
    EXPECT_NE(revision_of(model, one_trial()).digest, before);
  }
}

TEST(RevisionOf, DependsOnFitDataAlone) {
  std::vector<Trial> trials = one_trial();
  const std::string before = revision_of(pendulum(), trials).digest;
  trials.push_back(trials[0]);
  trials[1].held_out = true;
  EXPECT_EQ(revision_of(pendulum(), trials).digest, before);
  trials[0].measured.samples(1, 0) += 1e-9;
  EXPECT_NE(revision_of(pendulum(), trials).digest, before);
}

TEST(EffectsFromJson, ReadsWhatToJsonWrote) {
  const EffectList effects = effects_from_json(to_json(pendulum().effects));
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects[0].where, std::vector<std::string>{"joint.hinge"});
  EXPECT_EQ(effects[0].start.at("torque"), 0.0);
}

}  // namespace
}  // namespace lacuna
