#include "measurement/recording.h"

#include "foundation/address.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/unit.h"
#include "measurement/clocks/clock_check.h"
#include "measurement/trials/controller_plan.h"
#include "measurement/trials/plausibility.h"
#include "measurement/trials/read_tables.h"
#include "measurement/trials/reading_check.h"
#include "measurement/trials/trial_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

namespace lacuna {
namespace {

struct WholeSource {
  RecordingSource source;               ///< the settings of the current file
  RecordingPlan plan;                   ///< the same
  std::vector<std::string> file_names;  ///< names of trials: the file's name, or its path where two have one name
  std::set<std::string> trials_seen;    ///< values of the trial column in all files
  bool has_one_trial = false;           ///< a single trial without a setting for held-out data
};

constexpr std::size_t kFewestToSplit = 40;  ///< samples: a quarter of fewer has too little information

void note_start(const TrialClock& clock, const CsvTable& table, FileReport& report) {
  if (clock.origin == 0.0) return;
  report.note("start", table.lines[clock.rows.front()], [&] {
    return fmt::format("time starts at {:.9g} s in the file; shifted to start at 0 s", clock.origin);
  });
}

/// A given initial value is that at the start of the file, which a range in its middle leaves out.
void note_initial(const WholeSource& whole, const TrialClock& file, const TrialClock& piece, const CsvTable& table,
                  FileReport& report) {
  const bool given = std::any_of(whole.plan.initial.begin(), whole.plan.initial.end(),
                                 [](const InitialValue& value) { return value.knowledge == InitialKnowledge::given; });
  if (!given || piece.rows.front() == file.rows.front()) return;
  report.note("initial", table.lines[piece.rows.front()], [] {
    return std::string(
        "target.initial also gives the state here, in the middle of the recording, because target.time.use starts a "
        "trial");
  });
}

/// A held-out part without used samples is a mistake: in its numbers, the file, or the times to be used.
void check_holdout_ranges(const MeasuredFile& file, const std::vector<TrialClock>& held_out, FileReport& report) {
  for (const TimeRange& range : file.holdout) {
    const bool is_there = std::any_of(held_out.begin(), held_out.end(), [&](const TrialClock& clock) {
      return range.start <= clock.origin + clock.times.back() && range.end >= clock.origin;
    });
    if (is_there) continue;
    report.problem("holdout", 0, [&] {
      return fmt::format(
          "target.recording.holdout from {:.9g} s to {:.9g} s contains no sample that is used; these are times of the "
          "file, within target.time.use",
          range.start, range.end);
    });
  }
}

/// Parts of a file that are separate trials: the used ranges, cut where held-out parts begin and end.
std::vector<ClockPart> parts_of(const TrialClock& clock, const std::vector<TimeRange>& use,
                                const std::vector<TimeRange>& holdout) {
  std::vector<ClockPart> parts;
  for (const TrialClock& piece : cut_to_ranges(clock, use))
    for (ClockPart& part : cut_at_holdout(piece, holdout)) parts.push_back(std::move(part));
  return parts;
}

/// The last quarter of a single trial; nothing if it is too short for that.
std::vector<TimeRange> last_quarter(const TrialClock& clock, const std::vector<TimeRange>& use) {
  const std::vector<TrialClock> pieces = cut_to_ranges(clock, use);
  if (pieces.size() != 1 || pieces.front().times.size() < kFewestToSplit) return {};
  const std::vector<double>& times = pieces.front().times;
  return {{pieces.front().origin + times[times.size() - times.size() / 4], kInfinity}};
}

void note_split(const TimeRange& held_out, int line, FileReport& report) {
  report.note("split", line, [&] {
    return fmt::format(
        "this is the only recording, so its last quarter, from {:.9g} s on, is held out. For another part write "
        "[[target.recording]] with holdout = [[from, to]]; to fit to all of it write holdout = [] in [target]",
        held_out.start);
  });
}

/// A part that continues where another ended starts from its own readings, not from the values given for the file's
/// start.
void forget_given_start(Trial& trial) {
  for (InitialValue& value : trial.initial)
    if (value.knowledge == InitialKnowledge::given) value = {};
}

std::vector<int> lines_of(const TrialClock& clock, const CsvTable& table) {
  std::vector<int> lines;
  for (const std::size_t row : clock.rows) lines.push_back(table.lines[row]);
  return lines;
}

/// The trials of one clock.
void add_trials(const WholeSource& whole, const MeasuredFile& file, const CsvTable& table, const TrialClock& clock,
                const Trial& prototype, FileReport& report, std::vector<TrialClock>& of_holdout,
                std::vector<Trial>& trials) {
  const std::vector<TimeRange> quarter =
      whole.has_one_trial ? last_quarter(clock, whole.source.use) : std::vector<TimeRange>{};
  const std::vector<ClockPart> pieces = parts_of(clock, whole.source.use, quarter.empty() ? file.holdout : quarter);
  if (!quarter.empty()) note_split(quarter.front(), table.lines[pieces.back().clock.rows.front()], report);
  for (const auto& [piece, held_out, goes_on] : pieces) {
    if (held_out) of_holdout.push_back(piece);
    if (piece.times.size() < 2) {
      report.problem("few samples", table.lines[piece.rows.front()], [&] {
        return fmt::format("trial {} has only one sample; a trial needs at least two", prototype.name);
      });
      continue;
    }
    check_intervals(piece, table, whole.source, report);
    if (!goes_on) note_start(piece, table, report);
    if (!goes_on) note_initial(whole, clock, piece, table, report);
    Trial trial = build_trial(whole.plan, whole.source, table, piece, report);
    const auto first = std::find(clock.rows.begin(), clock.rows.end(), piece.rows.front());
    if (first != clock.rows.begin()) take_commands_before(whole.plan, table, *std::prev(first), trial);
    if (goes_on) forget_given_start(trial);
    trial.name = prototype.name;
    if (pieces.size() > 1)
      trial.name += fmt::format(" from {:.4g} s to {:.4g} s", piece.origin, piece.origin + piece.times.back());
    trial.held_out = prototype.held_out || held_out;
    trial.setup = prototype.setup;
    check_values(trial, whole.plan, table.lines[piece.rows.front()], report);
    check_commands(trial, whole.plan, table.lines[piece.rows.front()], report);
    leave_out_false_readings(trial, whole.plan, lines_of(piece, table), piece.origin, report);
    trials.push_back(std::move(trial));
  }
  if (pieces.empty())
    report.problem("use", 0, [&] {
      return fmt::format("target.time.use leaves no sample of trial {}, which covers {:.9g} s to {:.9g} s",
                         prototype.name, clock.origin, clock.origin + clock.times.back());
    });
}

void read_table_into(const CsvTable& table, WholeSource& whole, std::size_t file_index, FileReport& report,
                     std::vector<Trial>& trials) {
  if (table.times.empty()) {
    report.problem("no samples", 0, [] { return std::string("has a header but no samples"); });
    return;
  }
  const std::vector<std::vector<std::size_t>> rows = rows_by_trial(table);
  const MeasuredFile& file = whole.source.files[file_index];
  std::vector<TrialClock> of_holdout;
  for (std::size_t t = 0; t < rows.size(); ++t) {
    Trial prototype;
    prototype.name = whole.file_names[file_index];
    prototype.held_out = file.held_out;
    prototype.setup = file.setup;
    if (!table.trial_names.empty()) {
      const std::string& value = table.trial_names[t];
      prototype.name += "[" + value + "]";
      const auto& holdout = whole.source.holdout_trials;
      prototype.held_out |= std::find(holdout.begin(), holdout.end(), value) != holdout.end();
      whole.trials_seen.insert(value);
    }
    const TrialClock clock = read_clock(table, rows[t], whole.plan.seconds_per_time_unit, report);
    if (!report.has_problems()) add_trials(whole, file, table, clock, prototype, report, of_holdout, trials);
  }
  if (!report.has_problems()) check_holdout_ranges(file, of_holdout, report);
}

/// Runs side by side in one file are read one by one, each with the same notes on the whole file.
void drop_repeated(std::vector<ReadingNote>& notes) {
  std::set<std::tuple<std::string, int, std::string>> seen;
  std::erase_if(notes, [&](const ReadingNote& note) {
    return !seen.insert({note.location.file, note.location.line, note.message}).second;
  });
}

bool is_csv(const MeasuredFile& file, const RecordingFormats* formats) {
  return !formats || !formats->reads(file.path);
}

/// With the run for runs side by side in a file: "pendulum.csv[Run #2]".
std::vector<std::string> names_of_files(const std::vector<MeasuredFile>& files, const RecordingFormats* formats) {
  std::map<std::string, std::set<std::filesystem::path>> of_name;
  for (const MeasuredFile& file : files) of_name[file.path.filename().string()].insert(file.path);
  std::vector<std::string> names;
  for (const MeasuredFile& file : files) {
    const std::string name = file.path.filename().string();
    names.push_back(of_name[name].size() == 1 ? name : file.path.string());
    if (!file.table.empty() && is_csv(file, formats)) names.back() += "[" + file.table + "]";
  }
  return names;
}

/// A file that is both fitted to and held out would make every held-out error look good. A recording may join several
/// tables of a file; runs side by side are separate recordings.
void check_files_differ(const std::vector<MeasuredFile>& files, const RecordingFormats* formats,
                        ProblemList& problems) {
  std::set<std::filesystem::path> before;
  for (const MeasuredFile& file : files) {
    std::set<std::filesystem::path> paths;
    std::set<std::pair<std::filesystem::path, std::string>> tables;
    const auto look = [&](const std::filesystem::path& path, const std::string& table, const SourceLocation& location) {
      std::error_code ignored;
      std::filesystem::path whole = std::filesystem::weakly_canonical(path, ignored);
      if (&path == &file.path && !table.empty() && is_csv(file, formats)) whole += "[" + table + "]";
      paths.insert(whole);
      if (before.contains(whole) || !tables.emplace(whole, table).second)
        problems.add(location,
                     fmt::format("{} is named twice; name it once, for the fit or as held out", path.string()));
    };
    look(file.path, file.table, file.location);
    for (const FurtherFile& further : file.with) look(further.path, further.table, further.location);
    before.merge(paths);
  }
}

bool is_of_joint(const std::string& coordinate, const std::string& joint) {
  return coordinate == joint || coordinate == "joint." + joint || coordinate.starts_with("joint." + joint + ".");
}

/// The used and masked times of a file.
void take_own_ranges(const RecordingSource& source, const MeasuredFile& file, RecordingSource& own) {
  own.use = file.use.empty() ? source.use : file.use;
  own.mask = source.mask;
  own.mask.insert(own.mask.end(), file.mask.begin(), file.mask.end());
}

/// The knowledge about initial states in a file.
std::map<std::string, KnownStart> starts_of(const RecordingSource& source, const MeasuredFile& file) {
  std::map<std::string, KnownStart> starts = file.initial;
  for (const auto& [name, start] : source.initial) {
    const auto [own, is_new] = starts.emplace(name, start);
    if (is_new) continue;
    if (!own->second.states_joint && start.states_joint) {
      own->second.joint = start.joint;
      own->second.states_joint = true;
    }
    if (!own->second.command) own->second.command = start.command;
  }
  return starts;
}

/// Fills in the knowledge about initial states, with defaults for the rest.
void plan_starts(const std::map<std::string, KnownStart>& initial, const std::vector<std::string>& coordinates,
                 RecordingPlan& plan, ProblemList& problems) {
  plan.initial.clear();
  if (std::any_of(initial.begin(), initial.end(), [](const auto& one) { return one.second.states_joint; }))
    plan.initial.resize(coordinates.size());
  plan.commanded_before.assign(plan.commands.size(), std::nan(""));
  std::vector<std::string> actuators;
  for (const PlannedColumn& command : plan.commands) actuators.push_back(command.channel.name);
  for (const auto& [name, start] : initial) {
    bool is_joint = false;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      if (!is_of_joint(coordinates[i], name)) continue;
      if (start.states_joint) plan.initial[i] = start.joint;
      is_joint = true;
    }
    const auto actuator = std::find(actuators.begin(), actuators.end(), name);
    const bool is_actuator = actuator != actuators.end();
    if (start.command && is_actuator)
      plan.commanded_before[static_cast<std::size_t>(actuator - actuators.begin())] = *start.command;
    else if (start.command)
      problems.add(start.location, fmt::format("target.initial.{}.command: target.commands has no actuator `{}`{}; it "
                                               "has {}",
                                               name, name, did_you_mean(name, actuators), listed(actuators)));
    else if (!is_joint && is_actuator)
      problems.add(start.location, fmt::format("target.initial.{} does not give the actuator's state; write its "
                                               "command before the first sample, as in command = 0.0",
                                               name));
    if (!is_joint && (start.states_joint || (!start.command && !is_actuator)))
      problems.add(start.location, fmt::format("target.initial names `{}`{}, but the robot's joint coordinates are {}",
                                               name, did_you_mean("joint." + name, coordinates), listed(coordinates)));
  }
}

void check_holdout(const WholeSource& whole, const std::vector<Trial>& trials, const SourceLocation& location,
                   ProblemList& problems) {
  if (!problems.empty()) return;
  const std::vector<std::string> seen(whole.trials_seen.begin(), whole.trials_seen.end());
  for (const std::string& name : whole.source.holdout_trials)
    if (!whole.trials_seen.contains(name))
      problems.add(location, fmt::format("no file has the held-out trial `{}`{}; the trials are {}", name,
                                         did_you_mean(name, seen), listed(seen)));
  if (std::all_of(trials.begin(), trials.end(), [](const Trial& trial) { return trial.held_out; }))
    problems.add(location, "every trial is held out; leave at least one for the fit");
}

}  // namespace

Recording read_recording(const RecordingSource& source, const std::vector<Channel>& channels,
                         const std::vector<Channel>& actuators, const std::vector<std::string>& coordinates,
                         const RecordingFormats* formats, const Stop& stop) {
  ProblemList problems;
  const SourceLocation location{source.files.empty() ? "" : source.files.front().location.file, 0, 0};
  if (source.files.empty()) problems.add(location, "no recorded files; name at least one in target.files");
  check_files_differ(source.files, formats, problems);
  if (source.sensors.empty()) problems.add(location, "no column is read; assign at least one in target.sensors");
  RecordingPlan plan;
  plan.stop = stop;
  plan.sensors = plan_columns(source.sensors, channels, "sensor channel", problems);
  plan.commands = plan_columns(source.commands, actuators, "actuator", problems);
  for (std::size_t c = 0; c < plan.commands.size(); ++c)
    if (const std::string& column = plan.commands[c].mapping->enabled_by; !column.empty())
      plan.switches.push_back({c, column});
  plan_controllers(source.controllers, channels, actuators, plan, problems);
  plan.seconds_per_time_unit = seconds_per_time_unit(source, problems);
  plan_starts(source.initial, coordinates, plan, problems);

  WholeSource whole{source, plan, names_of_files(source.files, formats), {}};
  whole.has_one_trial = source.may_split && source.files.size() == 1 && !source.files.front().held_out &&
                        source.files.front().holdout.empty();
  Recording recording;
  std::vector<ReadRecording> tables = read_tables(source, plan, formats);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    take_own_ranges(source, source.files[i], whole.source);
    if (!source.files[i].initial.empty())
      plan_starts(starts_of(source, source.files[i]), coordinates, whole.plan, problems);
    else
      whole.plan = plan;
    FileReport& report = tables[i].report;
    if (!tables[i].has_problems()) read_table_into(tables[i].table, whole, i, report, recording.trials);
    report.move_to(problems, recording.notes);
    for (FileReport& further : tables[i].further) further.move_to(problems, recording.notes);
  }
  drop_repeated(recording.notes);
  check_holdout(whole, recording.trials, location, problems);
  problems.throw_if_any();
  std::stable_partition(recording.trials.begin(), recording.trials.end(),
                        [](const Trial& trial) { return !trial.held_out; });
  return recording;
}

Recording read_recording(const RecordingSource& source, const RobotSpec& robot, const RecordingFormats* formats,
                         const Stop& stop) {
  std::vector<std::string> coordinates;
  for (const JointSpec& joint : robot.joints) {
    const int count = coordinate_count(joint.kind);
    for (int i = 1; i <= count; ++i)
      coordinates.push_back("joint." + joint.name + (count > 1 ? "." + std::to_string(i) : ""));
  }
  return read_recording(source, sensor_channels(robot), command_channels(robot), coordinates, formats, stop);
}

RecordingReader::RecordingReader(RecordingSource source, RobotSpec robot,
                                 std::function<void(const ReadingNote&)> on_note, const RecordingFormats* formats,
                                 const Stop& stop)
    : source_(std::move(source)),
      robot_(std::move(robot)),
      on_note_(std::move(on_note)),
      formats_(formats),
      stop_(stop) {}

std::vector<Trial> RecordingReader::read() const {
  const HostCall call;
  Recording recording = read_recording(source_, robot_, formats_, stop_);
  if (on_note_)
    for (const ReadingNote& note : recording.notes) on_note_(note);
  return std::move(recording.trials);
}

}  // namespace lacuna
