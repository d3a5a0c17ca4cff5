#include "tasks/task_folder.h"

#include "foundation/problem.h"
#include "foundation/whole_file.h"
#include "storage/core/clock.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/utsname.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kBetweenSigns{15};
constexpr std::chrono::seconds kSilence{60};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void copy_whole(const fs::path& from, const fs::path& to) {
  std::ifstream source(from, std::ios::binary);
  if (!source) throw Error(from.string() + ": cannot be read");
  WholeFile whole(to, Link::replaced);
  if (fs::file_size(from) > 0) whole.stream() << source.rdbuf();
  whole.publish();
}

/// As Slurm calls it, where it does.
std::string name_of_this_machine() {
  if (const char* const node = std::getenv("SLURMD_NODENAME")) return node;
  utsname names{};
  return uname(&names) == 0 ? names.nodename : "a machine without a name";
}

void make_folders(const fs::path& folder) {
  for (const char* name : {"", "shards", "checkpoints", "signs", "logs"}) {
    std::error_code failure;
    fs::create_directories(folder / name, failure);
    if (failure) throw_problem({(folder / name).string()}, "cannot be made: " + failure.message());
  }
}

bool shows_life(const fs::path& sign) {
  std::error_code gone;
  const fs::file_time_type last = fs::last_write_time(sign, gone);
  return !gone && fs::file_time_type::clock::now() - last < kSilence;
}

std::vector<std::string> ids_of(const TaskPlan& plan) {
  std::vector<std::string> ids;
  for (const Task& task : plan.tasks) ids.push_back(task.id);
  return ids;
}

}  // namespace

TaskFolder TaskFolder::make(const fs::path& folder, const TaskPlan& plan) {
  const fs::path file = folder / "plan.json";
  if (fs::exists(file)) {
    TaskFolder there(folder);
    if (ids_of(there.plan()) != ids_of(plan))
      throw_problem({folder.string()}, "has another plan already; remove the folder, or name another one");
    return there;
  }
  if (folder.empty()) throw_problem({}, "--out is empty; name a new folder");
  std::error_code missing;
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw_problem({folder.string()}, "is a file; name a new folder with --out");
  if (fs::exists(folder) && !fs::is_empty(folder, missing))
    throw_problem({folder.string()}, "has other files in it; name a new folder with --out");
  make_folders(folder);
  write_whole(file, text_of_plan(plan), Link::replaced);
  return TaskFolder(folder);
}

TaskFolder::TaskFolder(const fs::path& folder) : folder_(folder) {
  const fs::path file = folder / "plan.json";
  if (!fs::is_regular_file(file))
    throw_problem({folder.string()}, "is not the folder of a plan; `lacuna plan` makes one");
  plan_ = read_plan(bytes_of(file), file);
}

void TaskFolder::make_ready() const { make_folders(folder_); }

const Task& TaskFolder::task(std::size_t number) const {
  if (number >= plan_.tasks.size())
    throw_problem({folder_.string()},
                  fmt::format("has no task {}; its tasks are 0 to {}", number, plan_.tasks.size() - 1));
  return plan_.tasks[number];
}

fs::path TaskFolder::shard(std::size_t number) const { return folder_ / "shards" / fmt::format("{}.db", number); }
fs::path TaskFolder::checkpoint(std::size_t number) const {
  return folder_ / "checkpoints" / fmt::format("{}.db", number);
}
fs::path TaskFolder::sign(std::size_t number) const { return folder_ / "signs" / fmt::format("{}.json", number); }

bool TaskFolder::is_done(std::size_t number) const { return fs::exists(shard(number)); }

TaskStatus TaskFolder::status(std::size_t number) const {
  TaskStatus status;
  const auto sign_file = sign(number);
  const auto json =
      fs::exists(sign_file) ? nlohmann::json::parse(bytes_of(sign_file), nullptr, false) : nlohmann::json();
  const auto text = [&](const char* key) {
    const auto value = json.is_object() ? json.find(key) : json.end();
    return value != json.end() && value->is_string() ? value->get<std::string>() : std::string();
  };
  status.machine = text("machine");
  status.time = text("time");
  status.reason = text("reason");
  const std::string said = text("state");
  if (is_done(number))
    status.state = TaskState::done;
  else if (said == "failed")
    status.state = TaskState::failed;
  else if (said == "interrupted")
    status.state = TaskState::interrupted;
  else if (said == "begun")
    status.state = shows_life(sign_file) ? TaskState::running : TaskState::silent;
  return status;
}

std::vector<std::size_t> TaskFolder::open_tasks() const {
  std::vector<std::size_t> open;
  for (std::size_t number = 0; number < plan_.tasks.size(); ++number)
    if (!is_done(number)) open.push_back(number);
  return open;
}

bool TaskFolder::take_checkpoint(std::size_t number, const fs::path& file) const {
  if (!fs::exists(checkpoint(number))) return false;
  copy_whole(checkpoint(number), file);
  return true;
}

void TaskFolder::keep_checkpoint(std::size_t number, const fs::path& file) const {
  if (fs::exists(file)) copy_whole(file, checkpoint(number));
}

void TaskFolder::note_interruption(std::size_t number, const std::string& reason) const {
  write_sign(number, "interrupted", reason);
}

void TaskFolder::keep_shard(std::size_t number, const fs::path& file) const {
  if (!is_done(number)) copy_whole(file, shard(number));
  std::error_code gone;
  fs::remove(checkpoint(number), gone);
  write_sign(number, "done", "");
}

void TaskFolder::note_failure(std::size_t number, const std::string& reason) const {
  write_sign(number, "failed", reason);
}

void TaskFolder::write_sign(std::size_t number, const char* state, const std::string& reason) const {
  const nlohmann::ordered_json json = {
      {"state", state}, {"machine", name_of_this_machine()}, {"time", utc_now()}, {"reason", reason}};
  write_whole(sign(number), json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n", Link::replaced);
}

TaskSign::TaskSign(const TaskFolder& folder, std::size_t number) {
  folder.write_sign(number, "begun", "");
  beating_ = std::jthread([file = folder.sign(number)](const std::stop_token& stop) {
    std::mutex unused;
    std::unique_lock lock(unused);
    std::condition_variable_any until;
    while (!until.wait_for(lock, stop, kBetweenSigns, [&] { return stop.stop_requested(); })) {
      std::error_code lost;  // what cannot be written here is said where the shard is
      fs::last_write_time(file, fs::file_time_type::clock::now(), lost);
    }
  });
}

}  // namespace lacuna
