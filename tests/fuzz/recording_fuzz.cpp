// Whatever measured files hold, they are read, guessed at, or refused with problems.
// The first byte says how an experiment describes them; a line "---" separates a trial's two files.

#include "fuzzing.h"
#include "measurement/command_file.h"
#include "measurement/guesses/file_sample.h"
#include "measurement/recording.h"
#include "measurement/rig_guess.h"
#include "support/test_folder.h"

namespace {

using lacuna::fuzz::require;

const std::vector<lacuna::Channel> kSensors = {{"angle", "rad"}, {"rate", "rad/s"}};
const std::vector<lacuna::Channel> kActuators = {{"motor", "N*m"}};

lacuna::ColumnMapping column(const std::string& channel, const std::string& name, const std::string& unit) {
  return {.channel = channel, .column = name, .unit = unit};
}

lacuna::RecordingSource source_of(std::uint8_t how, const std::vector<std::filesystem::path>& files) {
  lacuna::RecordingSource source;
  source.may_split = true;
  source.sensors = {column("angle", "q", "rad")};
  source.commands = {column("motor", "u", "N*m")};
  if ((how & 1U) != 0) source.trial_column = "trial";
  if ((how & 2U) != 0) source.sensors.push_back(column("rate", "v", "deg/s"));
  if ((how & 4U) != 0) source.sensors[0].encoding = {lacuna::EncodingKind::wraps, 4096.0};
  if ((how & 8U) != 0) source.use = {{0.1, 0.5}};
  if ((how & 16U) != 0) source.commands[0].enabled_by = "on";
  if ((how & 32U) != 0) source.commands[0].derivative = true;
  if ((how & 64U) != 0) source.time_unit = "us";
  source.files = {{.path = files[0]}};
  if (files.size() == 1) return source;
  if (!source.trial_column.empty() || (how & 128U) != 0)
    source.files.push_back({.path = files[1], .held_out = true});
  else
    source.files[0].with = {{.path = files[1], .offset = std::nullopt, .between = {-1.0, 1.0}}};
  return source;
}

void require_whole(const lacuna::Recording& recording) {
  require(!recording.trials.empty(), "a recording that is read has trials");
  for (const lacuna::Trial& trial : recording.trials) {
    const lacuna::TimeSeries& measured = trial.measured;
    require(measured.samples.rows() == measured.times.size(), "there is a row a time");
    for (Eigen::Index i = 1; i < measured.times.size(); ++i)
      require(measured.times[i] > measured.times[i - 1], "times grow");
  }
}

std::vector<std::filesystem::path> written(const std::string& text, const lacuna::TestFolder& folder) {
  static const std::string kBetween = "\n---\n";
  const std::size_t end = text.find(kBetween);
  std::vector<std::filesystem::path> files = {folder.write("one.csv", text.substr(0, end))};
  if (end != std::string::npos) files.push_back(folder.write("two.csv", text.substr(end + kBetween.size())));
  return files;
}

void guess(const std::vector<std::filesystem::path>& files) {
  std::vector<lacuna::FileSample> samples;
  for (const std::filesystem::path& file : files) samples.push_back(lacuna::sample_file(file));
  samples = lacuna::samples_of_runs(std::move(samples));
  std::vector<lacuna::GuessedFile> recordings;
  for (const lacuna::FileSample& sample : samples) recordings.push_back({sample.path, sample.run});
  const lacuna::RigGuess rig = lacuna::guess_rig(samples, {});
  std::vector<lacuna::Channel> sensors, actuators;
  for (const lacuna::MatchedColumn& sensor : rig.sensors) sensors.push_back(sensor.channel);
  for (const lacuna::MatchedColumn& command : rig.commands) actuators.push_back(command.channel);
  require_whole(lacuna::read_recording(lacuna::source_of(rig, recordings), sensors, actuators));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const lacuna::TestFolder folder;
  if (size == 0) return 0;
  const auto files = written(lacuna::fuzz::text_of(data + 1, size - 1), folder);
  lacuna::fuzz::is_done(
      [&] { require_whole(lacuna::read_recording(source_of(data[0], files), kSensors, kActuators, {"joint.hinge"})); });
  lacuna::fuzz::is_done([&] { guess(files); });
  lacuna::fuzz::is_done([&] { lacuna::read_command_file(files[0], kActuators); });
  return 0;
}
