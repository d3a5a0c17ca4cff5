// Whatever the files of a plan's folder hold, they are read or refused. The first byte chooses: a plan, or a task's
// sign beside a good one.

#include "fuzzing.h"
#include "support/test_folder.h"
#include "tasks/task_folder.h"
#include "tasks/task_plan.h"

namespace {

using lacuna::fuzz::require;

lacuna::TaskPlan small_plan() {
  lacuna::TaskPlan plan{.command = "lacuna plan walk.toml", .inputs = {{"/rig/walk.toml", std::string(64, 'a')}}};
  plan.tasks = {{.experiment = "/rig/walk.toml", .name = "walk", .settings = {"engine.step=0.001"}, .inputs = {0}}};
  plan.tasks[0].id = lacuna::id_of(plan.tasks[0], plan.inputs);
  return plan;
}

void read_plan(const std::string& text) {
  lacuna::fuzz::is_done([&] {
    const lacuna::TaskPlan plan = lacuna::read_plan(text, "plan.json");
    const lacuna::TaskPlan again = lacuna::read_plan(lacuna::text_of_plan(plan), "plan.json");
    require(again.tasks == plan.tasks && again.inputs == plan.inputs, "a plan that is written is read");
  });
}

void read_sign(const std::string& text) {
  static const lacuna::TestFolder scratch;
  static const lacuna::TaskFolder folder = lacuna::TaskFolder::make(scratch / "plan", small_plan());
  scratch.write("plan/signs/0.json", text);
  folder.status(0, folder.now());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text = lacuna::fuzz::text_of(data + 1, size - 1);
  if (data[0] % 2 == 0)
    read_plan(text);
  else
    read_sign(text);
  return 0;
}
