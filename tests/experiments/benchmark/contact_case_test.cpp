#include "contacts/contact_case.h"

#include "config/experiment_reader.h"
#include "contacts/contact_rig.h"
#include "evaluation/model/model_definition.h"
#include "measurement/recording.h"
#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

constexpr double kFar = 1.6;  // factor by which a measured strength may differ from the wanted one

CasePlan plan_of(const std::string& rig, const std::string& law, NoiseLevel noise) {
  CasePlan plan;
  plan.set = "test";
  plan.group = "contact";
  plan.rig = rig;
  plan.noise = noise;
  plan.seed = 3;
  const std::vector<ContactLaw>& laws = contact_rig_named(rig).laws;
  for (std::size_t l = 0; l < laws.size(); ++l)
    if (laws[l].name == law) plan.hidden = {{law, static_cast<int>(l)}};
  if (!plan.hidden.empty()) plan.strength = 3.0;
  return plan;
}

std::string all_bytes(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string bytes;
  for (const fs::path& file : files) bytes += file.filename().string() + '\n' + lacuna::read_bytes(file);
  return bytes;
}

class ContactCaseOf : public testing::TestWithParam<std::string> {};

TEST_P(ContactCaseOf, IsReadByTheProgram) {
  const lacuna::TestFolder folder;
  const MadeContactCase made = make_contact_case(plan_of(GetParam(), "", NoiseLevel::disturbed), folder.path());
  const lacuna::Experiment experiment = lacuna::read_experiment(folder / "rig.toml");
  const lacuna::ModelDefinition definition = lacuna::define_model(experiment, lacuna::built_catalog());
  ASSERT_EQ(definition.free.size(), 1U);
  EXPECT_EQ(definition.free.front().address, made.rig->free);
  const std::vector<lacuna::Trial> trials =
      lacuna::read_recording(experiment.target.recording, definition.structure.robot).trials;
  ASSERT_EQ(trials.size(), made.trials.size());
  EXPECT_EQ(trials.front().measured.channels.size(), made.rig->channels.size());
  EXPECT_EQ(trials.front().measured.times.size(), made.rig->samples());
  EXPECT_FALSE(made.absorbed) << "nothing is hidden that the base could explain";
}

INSTANTIATE_TEST_SUITE_P(All, ContactCaseOf, testing::Values("wheeled_base", "hopper", "quadruped"),
                         [](const auto& given) { return given.param; });

TEST(ContactCase, HasTheWantedStrength) {
  const lacuna::TestFolder folder;
  const MadeContactCase made = make_contact_case(plan_of("hopper", "restitution", NoiseLevel::coloured), folder.path());
  EXPECT_GT(made.strength, made.plan.strength / kFar);
  EXPECT_LT(made.strength, made.plan.strength * kFar);
  EXPECT_GT(made.hidden.value().value, 0.0);
}

TEST(ContactCase, IsTheSameAgain) {
  const CasePlan plan = plan_of("hopper", "", NoiseLevel::disturbed);
  const lacuna::TestFolder first, second;
  make_contact_case(plan, first.path());
  make_contact_case(plan, second.path());
  EXPECT_EQ(all_bytes(first.path()), all_bytes(second.path()));
}

TEST(ContactBench, RecordsSomethingElseForAnotherSeed) {
  const ContactRig& rig = contact_rig_named("hopper");
  const auto first_trial = [&](std::uint64_t seed) {
    return ContactBench(rig, ".", {}, rig.nominal, NoiseLevel::white, seed).record(0);
  };
  EXPECT_NE(first_trial(3).commands, first_trial(4).commands);
  EXPECT_EQ(first_trial(3).readings, first_trial(3).readings);
}

}  // namespace
}  // namespace hidden_effects
