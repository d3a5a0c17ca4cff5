#include "tasks/task_plan.h"

#include "foundation/digest.h"
#include "foundation/text/json_depth.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "lacuna-plan/1";
constexpr const char* kDiagnosis = "diagnosis";
constexpr const char* kRun = "run";

const char* to_string(TaskKind kind) { return kind == TaskKind::run ? kRun : kDiagnosis; }

Json json_of(const Task& task) {
  return {{"id", task.id},
          {"kind", to_string(task.kind)},
          {"experiment", task.experiment.string()},
          {"name", task.name},
          {"settings", task.settings},
          {"seed", task.seed},
          {"replicate", task.replicate},
          {"inputs", task.inputs}};
}

/// Other numbers would be made whole somehow.
template <class Number>
Number whole(const Json& json) {
  if (!json.is_number_unsigned() || !std::in_range<Number>(json.get<std::uint64_t>()))
    throw Error(fmt::format("has {} instead of a whole number", json.dump()));
  return json.get<Number>();
}

std::vector<std::size_t> whole_numbers(const Json& json) {
  std::vector<std::size_t> numbers;
  for (const Json& number : json) numbers.push_back(whole<std::size_t>(number));
  return numbers;
}

Task task_of(const Json& json) {
  return {.id = json.at("id").get<std::string>(),
          .kind = json.at("kind").get<std::string>() == kRun ? TaskKind::run : TaskKind::diagnosis,
          .experiment = json.at("experiment").get<std::string>(),
          .name = json.at("name").get<std::string>(),
          .settings = json.at("settings").get<std::vector<std::string>>(),
          .seed = whole<std::uint64_t>(json.at("seed")),
          .replicate = whole<int>(json.at("replicate")),
          .inputs = whole_numbers(json.at("inputs"))};
}

TaskPlan plan_of(const Json& json) {
  if (json.at("format").get<std::string>() != kFormat)
    throw Error(fmt::format("has the format {}; this program reads {}", json.at("format").dump(), kFormat));
  TaskPlan plan{.command = json.at("command").get<std::string>(), .plugin_paths = {}, .inputs = {}, .tasks = {}};
  for (const Json& path : json.at("plugin_paths")) plan.plugin_paths.emplace_back(path.get<std::string>());
  for (const Json& input : json.at("inputs"))
    plan.inputs.push_back({input.at("file").get<std::string>(), input.at("sha256").get<std::string>()});
  for (const Json& task : json.at("tasks")) plan.tasks.push_back(task_of(task));
  return plan;
}

void check_tasks(const TaskPlan& plan) {
  if (plan.tasks.empty()) throw Error("has no tasks");
  for (std::size_t number = 0; number < plan.tasks.size(); ++number) {
    const Task& task = plan.tasks[number];
    const auto has_file = [&](std::size_t input) { return plan.inputs[input].file == task.experiment; };
    const bool known = std::all_of(task.inputs.begin(), task.inputs.end(),
                                   [&](std::size_t input) { return input < plan.inputs.size(); });
    if (!known || std::none_of(task.inputs.begin(), task.inputs.end(), has_file) || task.id != id_of(task, plan.inputs))
      throw Error(fmt::format("task {} was changed after planning", number));
  }
}

}  // namespace

std::string id_of(const Task& task, const std::vector<TaskInput>& inputs) {
  std::vector<std::string> contents;
  for (const std::size_t input : task.inputs) contents.push_back(inputs.at(input).sha256);
  std::sort(contents.begin(), contents.end());
  return sha256(Json{to_string(task.kind), task.name, task.settings, task.seed, task.replicate, contents}.dump());
}

std::string text_of_plan(const TaskPlan& plan) {
  Json json = {{"format", kFormat}, {"command", plan.command}};
  json["plugin_paths"] = Json::array();
  for (const std::filesystem::path& path : plan.plugin_paths) json["plugin_paths"].push_back(path.string());
  json["inputs"] = Json::array();
  for (const TaskInput& input : plan.inputs)
    json["inputs"].push_back({{"file", input.file.string()}, {"sha256", input.sha256}});
  json["tasks"] = Json::array();
  for (const Task& task : plan.tasks) json["tasks"].push_back(json_of(task));
  try {
    return json.dump(1) + "\n";
  } catch (const Json::exception&) {
    throw Error("a file name or a setting is not UTF-8, as plans need it; rename or rewrite it");
  }
}

TaskPlan read_plan(const std::string& text, const std::filesystem::path& file) try {
  TaskPlan plan = plan_of(Json::parse(shallow_json(text)));
  check_tasks(plan);
  return plan;
} catch (const Json::exception&) {
  throw_problem({file.string()},
                "is not a plan of `lacuna plan`, or is damaged; restore a copy, or remove it and make the plan again "
                "there: the results of its tasks stay");
} catch (const BadInput&) {
  throw;
} catch (const Error& wrong) {
  throw_problem({file.string()}, fmt::format("{}; make the plan again with `lacuna plan`", wrong.what()));
}

std::vector<std::string> changed_inputs(const TaskPlan& plan, const Task& task) {
  std::vector<std::string> changed;
  for (const std::size_t number : task.inputs) {
    const TaskInput& input = plan.inputs.at(number);
    try {
      if (sha256_of_file(input.file) != input.sha256)
        changed.push_back((input.file == kThisProgram ? "this program" : input.file.string()) +
                          " has changed since the plan was made");
    } catch (const Error& unreadable) {
      changed.emplace_back(unreadable.what());
    }
  }
  return changed;
}

}  // namespace lacuna
