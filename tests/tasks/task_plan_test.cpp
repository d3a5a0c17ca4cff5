#include "tasks/made_up_plan.h"

#include "foundation/text/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace lacuna {
namespace {

using test::made_up_plan;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TaskPlanTest : public testing::Test {
 protected:
  std::string complaint(const std::string& text) const {
    try {
      read_plan(text, "plan.json");
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "none";
  }

  TestFolder folder_;
  TaskPlan plan_ = made_up_plan(folder_.path());
};

TEST_F(TaskPlanTest, IsReadAsItWasWritten) {
  const TaskPlan read = read_plan(text_of_plan(plan_), "plan.json");
  EXPECT_EQ(read.command, plan_.command);
  EXPECT_EQ(read.plugin_paths, plan_.plugin_paths);
  EXPECT_EQ(read.inputs, plan_.inputs);
  EXPECT_EQ(read.tasks, plan_.tasks);
}

/// Whatever a result follows from changes the id; where the files lie does not.
TEST_F(TaskPlanTest, AnIdFollowsFromAllThatResultsFollowFrom) {
  const Task task = plan_.tasks.front();
  std::set<std::string> ids = {task.id};
  const auto changed = [&](const auto& change) {
    Task other = task;
    std::vector<TaskInput> inputs = plan_.inputs;
    change(other, inputs);
    return id_of(other, inputs);
  };
  ids.insert(changed([](Task& t, auto&) { t.kind = TaskKind::diagnosis; }));
  ids.insert(changed([](Task& t, auto&) { t.seed = 8; }));
  ids.insert(changed([](Task& t, auto&) { t.replicate = 2; }));
  ids.insert(changed([](Task& t, auto&) { t.name = "other"; }));
  ids.insert(changed([](Task& t, auto&) { t.settings = {}; }));
  ids.insert(changed([](Task&, auto& inputs) { inputs[0].sha256 = std::string(64, '0'); }));
  EXPECT_EQ(ids.size(), 7U);
  EXPECT_EQ(changed([](Task&, auto& inputs) { inputs[0].file = "/elsewhere/rig.toml"; }), task.id);
}

TEST_F(TaskPlanTest, NamesInputsThatAreOthersNow) {
  EXPECT_THAT(changed_inputs(plan_, plan_.tasks[0]), IsEmpty());
  write_text(folder_ / "rig.toml", "[experiment]\nname = \"other\"\n");
  EXPECT_THAT(changed_inputs(plan_, plan_.tasks[0]),
              ElementsAre((folder_ / "rig.toml").string() + " has changed since the plan was made"));
  std::filesystem::remove(folder_ / "rig.toml");
  EXPECT_THAT(changed_inputs(plan_, plan_.tasks[0]), ElementsAre(HasSubstr("rig.toml")));
}

TEST_F(TaskPlanTest, RefusesWhatIsNoPlanOrWasEdited) {
  EXPECT_THAT(complaint("{"), HasSubstr("plan.json: is not a plan"));
  EXPECT_THAT(complaint("{}"), HasSubstr("plan.json: is not a plan"));
  std::string text = text_of_plan(plan_);
  text.replace(text.find("\"seed\": 7"), 9, "\"seed\": 9");
  EXPECT_THAT(complaint(text), HasSubstr("task 0 was changed after planning"));
  for (const std::string seed : {"1e308", "-1", "7.5", "[7]"}) {
    text = text_of_plan(plan_);
    text.replace(text.find("\"seed\": 7"), 9, "\"seed\": " + seed);
    EXPECT_THAT(complaint(text), HasSubstr("plan.json: has " + seed.substr(0, 1)));
  }
  text = text_of_plan(plan_);
  text.replace(text.find("lacuna-plan/1"), 13, "lacuna-plan/9");
  EXPECT_THAT(complaint(text), HasSubstr("lacuna-plan/9"));
  plan_.tasks[1].inputs = {3};
  EXPECT_THAT(complaint(text_of_plan(plan_)), HasSubstr("task 1 was changed after planning"));
}

TEST_F(TaskPlanTest, RefusesWhatNestsTooDeep) {
  EXPECT_THAT(complaint(R"({"format": )" + std::string(80'000, '[') + std::string(80'000, ']') + "}"),
              HasSubstr("nests arrays and objects"));
}

}  // namespace
}  // namespace lacuna
