#include "app/commands/commands.h"
#include "app/terminal/output.h"
#include "app/workspace/draft_questions.h"
#include "app/workspace/draft_report.h"
#include "app/workspace/note_sentences.h"
#include "app/workspace/rig_draft.h"
#include "config/robots/robot_reader.h"
#include "config/toml/text_file.h"
#include "config/toml/toml_parser.h"
#include "evaluation/robots/joint_drives.h"
#include "evaluation/recording_files.h"
#include "evaluation/robots/robot_files.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "foundation/recording_folder.h"
#include "foundation/unit.h"
#include "foundation/files/whole_file.h"
#include "measurement/clocks/clock_check.h"
#include "measurement/names/header_names.h"
#include "measurement/guesses/logged_drives.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

struct NewOptions {
  std::filesystem::path experiment;
  std::vector<std::filesystem::path> files;
  std::filesystem::path robot;
  ColumnHints hints;
};

void refuse_existing(const std::filesystem::path& file) {
  if (std::filesystem::exists(std::filesystem::symlink_status(file)))
    throw Error(file.string() + ": already exists and is not overwritten; choose another name or move it away");
}

/// Writes files that must not exist, all or none; what another program wrote meanwhile is left alone.
class NewFiles {
 public:
  void add(const std::filesystem::path& file, const std::string& text) {
    WholeFile& draft = *drafts_.emplace_back(file, std::make_unique<WholeFile>(file, Link::replaced)).second;
    draft.stream() << text;
    draft.finish();
  }
  void publish() {
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      try {
        drafts_[i].second->publish_as_new();
      } catch (...) {
        std::error_code ignored;
        for (std::size_t made = 0; made < i; ++made) std::filesystem::remove(drafts_[made].first, ignored);
        throw;
      }
    }
  }

 private:
  std::vector<std::pair<std::filesystem::path, std::unique_ptr<WholeFile>>> drafts_;
};

/// The plugins, loaded when a file needs them: CSV files and robots in TOML do not.
class FormatPlugins {
 public:
  const PluginCatalog& catalog() {
    if (!catalog_) catalog_ = std::make_unique<PluginCatalog>(plugin_search_path({}));
    return *catalog_;
  }
  /// Null where all files are CSV by their names.
  const RecordingFormats* recording_formats(const std::vector<std::filesystem::path>& files) {
    if (std::all_of(files.begin(), files.end(), [](const auto& file) { return file.extension() == ".csv"; }))
      return nullptr;
    if (!formats_) formats_ = std::make_unique<PluginRecordingFormats>(catalog());
    return formats_.get();
  }

 private:
  std::unique_ptr<const PluginCatalog> catalog_;
  std::unique_ptr<const PluginRecordingFormats> formats_;
};

/// Reads the recordings as guessed. Their problems do not stop the draft; they are returned.
std::string read_recordings(RigDraft& draft, const RecordingFormats* formats) {
  try {
    draft.recording = read_recording(source_of(draft.guess, draft.files), robot_of(draft), formats, when_interrupted());
  } catch (const BadInput& error) {
    return error.what();
  }
  const Eigen::VectorXd& times = draft.recording->trials.front().measured.times;
  draft.interval = median_interval({times.data(), static_cast<std::size_t>(times.size())});
  draft.shortest = std::numeric_limits<double>::infinity();
  for (const Trial& trial : draft.recording->trials)
    draft.shortest = std::min(draft.shortest, trial.measured.times(trial.measured.times.size() - 1));
  return {};
}

/// A robot file of others, with what was guessed, repaired and left out.
RobotSpec read_foreign_robot(const std::filesystem::path& file, FormatPlugins& plugins) {
  Experiment experiment;
  experiment.model.file = file;
  experiment.model.foreign_text = read_text_file(file);
  for (const RobotFileNote& note : read_robot_files(experiment, plugins.catalog()))
    fmt::print(stderr, "{}: {}\n", to_string(note.location), note.text);
  return *experiment.model.declared;
}

/// Refuses an experiment file, which is the file that is named by mistake most often, in one sentence.
RobotSpec read_known_robot(const std::filesystem::path& file, FormatPlugins& plugins) {
  if (file.extension() != ".toml") return read_foreign_robot(file, plugins);
  const std::string text = read_text_file(file);
  const TomlNode tree = parse_toml(text, file.string());
  for (const TomlMember& member : tree.members)
    if (member.name == "experiment" || member.name == "target")
      throw_problem(member.location, fmt::format("--robot names an experiment file, not a robot file: it has [{}]; "
                                                 "name the file that stands under model.file in it",
                                                 member.name));
  return read_robot_text(text, file);
}

/// Columns as the runs call them.
ColumnHints without_runs(ColumnHints hints) {
  const auto shorten = [](std::string& name) { name = name_and_run(name).text; };
  shorten(hints.time);
  for (auto* names : {&hints.positions, &hints.velocities, &hints.commands})
    for (std::string& name : *names) shorten(name);
  return hints;
}

/// A robot file of others says seldom what was commanded; the recordings do.
void settle_drive(const FileSample& sample, const ColumnHints& hints, RigDraft& draft) {
  draft.drive = logged_drive(sample, hints, *draft.known_robot);
  if (!draft.drive) return;
  for (ActuatorSpec& actuator : draft.known_robot->actuators) set_drive(actuator, *draft.drive);
}

RigDraft make_draft(const NewOptions& options, FormatPlugins& plugins) {
  RigDraft draft;
  draft.experiment = options.experiment;
  draft.robot = options.robot;
  if (options.robot.empty())
    draft.robot = draft.experiment.parent_path() / (draft.experiment.stem().string() + "-robot.toml");
  else
    draft.known_robot = read_known_robot(options.robot, plugins);
  std::vector<FileSample> samples;
  for (const std::filesystem::path& file : options.files)
    samples.push_back(sample_file(file, plugins.recording_formats(options.files)));
  samples = samples_of_runs(std::move(samples));
  for (const FileSample& sample : samples) draft.files.push_back({sample.path, sample.run});
  const ColumnHints hints = samples.front().run.empty() ? options.hints : without_runs(options.hints);
  if (draft.known_robot && draft.robot.extension() != ".toml") settle_drive(samples.front(), hints, draft);
  draft.guess = draft.known_robot ? guess_rig(samples, hints, *draft.known_robot) : guess_rig(samples, hints);
  draft.first_file = std::move(samples.front());
  return draft;
}

void make_new(const NewOptions& options) {
  refuse_existing(options.experiment);
  check_output(options.experiment.string());
  FormatPlugins plugins;
  RigDraft draft = make_draft(options, plugins);
  const bool writes_robot = !draft.known_robot;
  if (writes_robot) refuse_existing(draft.robot);
  const std::string problems = read_recordings(draft, plugins.recording_formats(options.files));
  std::string experiment = experiment_text(draft);
  std::string robot = writes_robot ? robot_text(draft) : "";
  if (asks_at_terminal()) {
    print_guesses(draft);
    ask_for_blanks(draft, experiment, robot);
  }
  NewFiles files;
  if (writes_robot) files.add(draft.robot, robot);
  files.add(draft.experiment, experiment);
  files.publish();

  std::printf("%s%s written from %s\n", plain_text(draft.experiment.string()).c_str(),
              writes_robot ? (" and " + plain_text(draft.robot.string())).c_str() : "",
              counted(draft.files.size(), "recording").c_str());
  if (!asks_at_terminal()) print_guesses(draft);
  if (draft.recording)
    for (const std::string& sentence : note_sentences(draft.recording->notes))
      std::printf("note  %s\n", sentence.c_str());
  if (!problems.empty())
    std::printf("correct these in the recordings, or state them in the experiment file\n%s\n", problems.c_str());
  const std::string blank = '"' + std::string(kBlank);
  if (robot.find(blank) != robot.npos || experiment.find(blank) != experiment.npos) std::printf("fill in\n");
  print_blanks(draft.experiment, experiment);
  if (writes_robot) print_blanks(draft.robot, robot);
  std::printf("then  lacuna check %s\n", shell_word(draft.experiment.string()).c_str());
}

}  // namespace

void add_new_command(CLI::App& program) {
  auto options = std::make_shared<NewOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("new", "Draft an experiment file and a robot file from recordings");
  command->add_option("experiment", options->experiment, "Experiment file to write (TOML)")
      ->required()
      ->option_text("FILE");
  command
      ->add_option("--from", options->files,
                   "Recordings: data files or ROS 2 bag folders (required); with two or more, the last one is held out")
      ->required()
      ->option_text("FILE ...");
  command
      ->add_option("--robot", options->robot, "Existing robot file; columns are matched with its sensors and actuators")
      ->option_text("FILE");
  command->add_option("--time", options->hints.time, "Column of time (default: guessed)")->option_text("COLUMN");
  command
      ->add_option("--position", options->hints.positions,
                   "Column of a joint position (default: guessed); may be repeated")
      ->allow_extra_args(false)
      ->option_text("COLUMN");
  command
      ->add_option("--velocity", options->hints.velocities,
                   "Column of a joint velocity (default: guessed); may be repeated")
      ->allow_extra_args(false)
      ->option_text("COLUMN");
  command->add_option("--command", options->hints.commands, "Column of a command (default: guessed); may be repeated")
      ->allow_extra_args(false)
      ->option_text("COLUMN");
  command->callback([options] {
    for (std::filesystem::path& file : options->files) file = without_last_slash(file);
    make_new(*options);
  });
}

}  // namespace lacuna
