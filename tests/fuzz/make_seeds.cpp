// Writes the first inputs of targets that read no text: make_seeds FOLDER, FOLDER/TARGET/seeds gets each target's.

#include "isolation/carried.h"
#include "plugins/mcap_bytes.h"
#include "storage/made_up_run.h"
#include "storage/traces/trace_codec.h"
#include "tasks/made_up_plan.h"

#include <SQLiteCpp/Database.h>

namespace {

namespace fs = std::filesystem;

constexpr lacuna::test::MadeUpRun kSmallRun{.passes = 2, .generations = 2, .models = 3, .tests = 3, .samples = 5};

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

/// In small pages, so that most bytes are of rows.
void make_small(const fs::path& database) {
  SQLite::Database(database.string(), SQLite::OPEN_READWRITE)
      .exec("PRAGMA journal_mode = DELETE; PRAGMA page_size = 512; VACUUM");
}

void write_shards(const fs::path& folder) {
  fs::create_directories(folder);
  const fs::path compared = folder / "compared.db", run = folder / "run.db";
  {
    lacuna::Database database = lacuna::Database::open(compared);
    lacuna::ResultStore store(database);
    lacuna::test::fill_small_database(store);
  }
  lacuna::test::MadeUpDatabase(run).advance(kSmallRun, kSmallRun.commits());
  for (const fs::path& database : {compared, run}) make_small(database);
}

std::string trace_input(const lacuna::EncodedTrace& trace) {
  const auto text = [](const std::vector<std::byte>& bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const auto times = static_cast<std::uint16_t>(trace.times.size());
  const auto channels = static_cast<std::uint16_t>(trace.channels.size());
  std::string input;
  for (const auto size : {times, channels}) input.append(reinterpret_cast<const char*>(&size), sizeof size);
  input.append(reinterpret_cast<const char*>(&trace.sample_count), sizeof trace.sample_count);
  input += static_cast<char>(trace.precision == lacuna::TracePrecision::float64);
  return input + trace.channels + text(trace.times) + text(trace.samples);
}

void write_traces(const fs::path& folder) {
  lacuna::TimeSeries series = lacuna::test::sine(5);
  write(folder / "uniform", trace_input(lacuna::encode_trace(series, lacuna::TracePrecision::float32)));
  series.times[2] += 1e-4;
  write(folder / "uneven", trace_input(lacuna::encode_trace(series, lacuna::TracePrecision::float64)));
}

void write_messages(const fs::path& folder) {
  const lacuna::Trial trial = kSmallRun.made_up_trial(1);
  lacuna::WiredState state;
  state.trials = {{.genome = {0.5}, .commands = trial.commands, .duration = 0.2, .trial = trial, .set_aside_in = 1}};
  state.best = {{.number = 3, .genome = {0.25}, .values = {1.5}, .score = 0.125}};
  const lacuna::WorkerTask task{"rig.toml", "[robot]\n", {"a=1"}, {"b=2"}, {"/opt"}, 2.5, 1000, {"abc"}};
  const std::vector<lacuna::Request> requests = {task,
                                                 lacuna::BeginEstimation{state},
                                                 lacuna::ScoreModelsRequest{{{0.5}, {0.25}}, 0.5},
                                                 lacuna::JudgeTests{{{0.5, 1.0}}},
                                                 lacuna::ScoreOn{state.best[0], state.trials[0], 2},
                                                 lacuna::FindDelays{state.best, state}};
  for (std::size_t i = 0; i < requests.size(); ++i)
    write(folder / ("request-" + std::to_string(i)), '\0' + lacuna::to_bytes(requests[i]));
  write(folder / "scores",
        '\1' + lacuna::to_bytes(std::vector<lacuna::ModelScore>{{.total = 0.5, .trials = {0.5}, .values = {2.0}}}));
  write(folder / "judged", '\2' + lacuna::to_bytes(std::vector<lacuna::JudgedTest>{{0.5, "no", 9}}));
  lacuna::PredictedTrial predicted;
  predicted.prediction = {trial.measured, trial.centre_of_mass};
  write(folder / "predicted", '\3' + lacuna::to_bytes(predicted));
  write(folder / "lost", '\4' + lacuna::to_bytes(lacuna::LostWork{"effect", "was called", 1, true}));
}

void write_plans(const fs::path& folder) {
  const lacuna::TestFolder scratch;
  write(folder / "plan", '\0' + lacuna::text_of_plan(lacuna::test::made_up_plan(scratch.path())));
  write(folder / "sign",
        R"(1{"state": "failed", "machine": "a", "time": "2026-01-01T00:00:00Z", "reason": "no disk"})");
}

/// Messages that no checksum protects, so that a change of a byte is read on.
void write_bags(const fs::path& folder) {
  using namespace std::string_literals;
  lacuna::McapBytes bag;
  bag.schema(1, "robots/msg/State", "ros2msg", "float64 angle\nstring[] name\nfloat32[<=3] pair\nint16 count\n");
  bag.channel(1, 1, "/state", "cdr");
  bag.message(1, 1'000'000'000,
              "\0\1\0\0"s + "\0\0\0\0\0\0\xf0\x3f"s + "\1\0\0\0\2\0\0\0a\0"s + "\0\0"s + "\0\0\0\0"s + "\5\0"s);
  bag.schema(2, "Log", "jsonschema", "{}");
  bag.channel(2, 2, "/log", "json");
  bag.message(2, 1'500'000'000, R"({"name": ["a"], "position": [0.5], "t": {"sec": 1, "nanosec": 2}})");
  write(folder / "plain.mcap", bag.whole());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const fs::path folder = argv[1];
  write_shards(folder / "shard" / "seeds");
  write_traces(folder / "trace" / "seeds");
  write_messages(folder / "message" / "seeds");
  write_plans(folder / "plan" / "seeds");
  write_bags(folder / "rosbag2" / "seeds");
}
