#include "tasks/task_folder.h"

#include "foundation/text/json_depth.h"
#include "foundation/text/problem.h"
#include "foundation/files/whole_file.h"
#include "storage/integrity/backup.h"
#include "storage/core/clock.h"
#include "tasks/task_database.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kBetweenSigns{15};
constexpr std::chrono::minutes kLongestSilence{3};  // network file systems tell of changes a minute later

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file)) throw Error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// As Slurm calls it, where it does.
std::string name_of_this_machine() {
  if (const char* const node = std::getenv("SLURMD_NODENAME")) return node;
  utsname names{};
  return uname(&names) == 0 ? names.nodename : "a machine without a name";
}

std::string name_of_database(std::size_t task) { return fmt::format("{}.db", task); }

constexpr std::array kFolders = {"shards", "checkpoints", "signs", "logs"};

bool is_own_folder(const std::string& name) {
  return std::find(kFolders.begin(), kFolders.end(), name) != kFolders.end();
}

void make_folders(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  for (const char* name : kFolders) {
    if (failure) break;
    fs::create_directories(folder / name, failure);
  }
  if (failure) throw_problem({folder.string()}, "cannot be created: " + failure.message());
}

/// Makes now, by the clock of the file system, which all machines share, the time of its last change.
void touch(const fs::path& file) { utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

bool shows_life(const fs::path& sign, fs::file_time_type now) {
  std::error_code gone;
  const fs::file_time_type last = fs::last_write_time(sign, gone);
  return !gone && now - last < kLongestSilence;
}

/// Than the folders of a plan, which one that was killed has made before it wrote its plan, or whose plan was lost.
bool has_other_files(const fs::path& folder) {
  std::error_code none;
  for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none))
    if (!entry->is_directory() || !is_own_folder(entry->path().filename())) return true;
  return false;
}

/// What a lost plan's tasks have found must be of the plan that takes its place.
void check_found(const fs::path& folder, const TaskPlan& plan, const Stop& stop) {
  const fs::path shards = folder / "shards";
  if (!fs::exists(shards)) return;
  ProblemList problems;
  for (std::size_t number = 0; number < plan.tasks.size(); ++number) {
    const fs::path shard = shards / name_of_database(number);
    if (!fs::exists(shard)) continue;
    if (const auto fault = why_not_of_task(shard, plan.tasks[number], TaskDatabase::shard, stop))
      problems.add({shard.string()}, fault->reason + "; move it away, or name a new folder with --out");
  }
  problems.throw_if_any();
}

std::vector<std::string> ids_of(const TaskPlan& plan) {
  std::vector<std::string> ids;
  for (const Task& task : plan.tasks) ids.push_back(task.id);
  return ids;
}

}  // namespace

fs::path checkpoint_in(const fs::path& folder, std::size_t task) {
  return folder / "checkpoints" / name_of_database(task);
}

TaskFolder TaskFolder::make(const fs::path& folder, const TaskPlan& plan, const Stop& stop) {
  const fs::path file = folder / "plan.json";
  if (fs::exists(file)) {
    TaskFolder there(folder);
    if (ids_of(there.plan()) != ids_of(plan))
      throw_problem({folder.string()}, "already contains another plan; move this folder away, or name another one");
    if (text_of_plan(there.plan()) == text_of_plan(plan)) return there;
    write_whole(file, text_of_plan(plan), Link::replaced);  // the same tasks, whose files have moved
    return TaskFolder(folder);
  }
  if (folder.empty()) throw_problem({}, "--out is empty; name a new folder");
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw_problem({folder.string()}, "is a file; name a new folder with --out");
  if (has_other_files(folder)) throw_problem({folder.string()}, "contains other files; name a new folder with --out");
  check_found(folder, plan, stop);
  make_folders(folder);
  write_whole(file, text_of_plan(plan), Link::replaced);
  return TaskFolder(folder);
}

TaskFolder::TaskFolder(const fs::path& folder) : folder_(folder) {
  const fs::path file = folder / "plan.json";
  if (!fs::is_regular_file(file))
    throw_problem({folder.empty() ? "the empty name" : folder.string()},
                  "is not the folder of a plan; make one with `lacuna plan`");
  plan_ = read_plan(bytes_of(file), file);
}

void TaskFolder::make_ready() const { make_folders(folder_); }

const Task& TaskFolder::task(std::size_t number) const {
  if (number >= plan_.tasks.size())
    throw_problem({folder_.string()},
                  fmt::format("has no task {}; its tasks are 0 to {}", number, plan_.tasks.size() - 1));
  return plan_.tasks[number];
}

fs::path TaskFolder::shard(std::size_t number) const { return folder_ / "shards" / name_of_database(number); }
fs::path TaskFolder::checkpoint(std::size_t number) const { return checkpoint_in(folder_, number); }
fs::path TaskFolder::sign(std::size_t number) const { return folder_ / "signs" / fmt::format("{}.json", number); }

bool TaskFolder::is_done(std::size_t number) const { return fs::exists(shard(number)); }

fs::file_time_type TaskFolder::now() const {
  std::string name = (folder_ / "signs" / ".now-XXXXXX").string();
  const int probe = mkostemp(name.data(), O_CLOEXEC);
  std::error_code lost;
  const fs::file_time_type now = fs::last_write_time(name, lost);
  if (probe < 0) return fs::file_time_type::clock::now();
  close(probe);
  fs::remove(name, lost);
  return now;
}

TaskStatus TaskFolder::status(std::size_t number, fs::file_time_type now) const {
  TaskStatus status;
  const auto sign_file = sign(number);
  const std::string content = fs::exists(sign_file) ? bytes_of(sign_file) : "";
  const auto json = nests_too_deep(content) ? nlohmann::json() : nlohmann::json::parse(content, nullptr, false);
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
    status.state = shows_life(sign_file, now) ? TaskState::running : TaskState::silent;
  return status;
}

std::vector<std::size_t> TaskFolder::open_tasks() const {
  std::vector<std::size_t> open;
  for (std::size_t number = 0; number < plan_.tasks.size(); ++number)
    if (!is_done(number)) open.push_back(number);
  return open;
}

bool TaskFolder::take_checkpoint(std::size_t number, const fs::path& file) const {
  const fs::path from = checkpoint(number);
  if (!fs::exists(from)) return false;
  std::error_code failure;
  fs::copy_file(from, file, fs::copy_options::overwrite_existing, failure);
  if (failure)
    throw Error(fmt::format("{}: cannot be copied to {}: {}", from.string(), file.string(), failure.message()));
  return true;
}

fs::path TaskFolder::put_checkpoint_aside(std::size_t number) const {
  const fs::path aside = checkpoint(number).string() + ".unusable";
  std::error_code gone;  // another process has done so
  fs::rename(checkpoint(number), aside, gone);
  return aside;
}

void TaskFolder::keep_checkpoint(std::size_t number, const fs::path& file) const {
  if (fs::exists(file) && !is_done(number)) hand_on(file, checkpoint(number));
}

void TaskFolder::note_interruption(std::size_t number, const std::string& reason) const {
  try_to_write_sign(number, "interrupted", reason);
}

void TaskFolder::keep_shard(std::size_t number, const fs::path& file) const {
  if (!is_done(number)) hand_on(file, shard(number));
  std::error_code gone;
  fs::remove(checkpoint(number), gone);
  try_to_write_sign(number, "done", "");
}

void TaskFolder::note_failure(std::size_t number, const std::string& reason) const {
  try_to_write_sign(number, "failed", reason);
}

void TaskFolder::try_to_write_sign(std::size_t number, const char* state, const std::string& reason) const try {
  write_sign(number, state, reason);
} catch (const Error& full) {
  fmt::print(stderr, "{}\n", full.what());
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
    while (!until.wait_for(lock, stop, kBetweenSigns, [&] { return stop.stop_requested(); })) touch(file);
  });
}

}  // namespace lacuna
