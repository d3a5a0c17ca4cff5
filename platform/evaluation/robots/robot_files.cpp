#include "evaluation/robots/robot_files.h"

#include "evaluation/robots/files_beside.h"
#include "evaluation/robots/held_joints.h"
#include "evaluation/robots/joint_drives.h"
#include "foundation/digest.h"
#include "foundation/processes/guarded_call.h"

#include <lacuna/robot_format.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

/// A format, and its name in the catalog.
struct NamedFormat {
  std::string name;
  const RobotFormat* format = nullptr;
  std::vector<std::string> endings;
};

std::vector<NamedFormat> formats_of(const PluginCatalog& catalog) {
  std::vector<NamedFormat> formats;
  for (const std::string& name : catalog.names<RobotFormat>()) {
    const RobotFormat& format = catalog.get<RobotFormat>(name);
    formats.push_back(
        {name, &format, guarded_call(catalog.origin<RobotFormat>(name), "endings", [&] { return format.endings(); })});
  }
  return formats;
}

/// Of several formats with the ending, the one that recognises the text; the first, if none does.
const NamedFormat& format_for(const std::filesystem::path& file, const std::string& text, const PluginCatalog& catalog,
                              const std::vector<NamedFormat>& formats) {
  std::vector<std::string> known = {".toml"};
  std::vector<const NamedFormat*> possible;
  for (const NamedFormat& format : formats) {
    if (std::any_of(format.endings.begin(), format.endings.end(),
                    [&](const std::string& ending) { return file.string().ends_with(ending); }))
      possible.push_back(&format);
    known.insert(known.end(), format.endings.begin(), format.endings.end());
  }
  for (const NamedFormat* format : possible)
    if (possible.size() > 1 && guarded_call(catalog.origin<RobotFormat>(format->name), "is_meant",
                                            [&] { return format->format->is_meant(text); }))
      return *format;
  if (!possible.empty()) return *possible.front();
  if (file.extension() == ".xacro")
    throw_problem({file.string(), 0, 0}, "is a xacro file, from which a URDF is made; type xacro " +
                                             file.filename().string() + " > " + file.stem().stem().string() +
                                             ".urdf and name that");
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  throw_problem(
      {file.string(), 0, 0},
      fmt::format("cannot be read as a robot file: its name ends with none of {}; give it the ending of its format (of "
                  "xacro write: xacro arm.xacro -o arm.urdf), and name recordings in target.files or by --from",
                  fmt::join(known, ", ")));
}

const char* word_of(RobotRemarkKind kind) {
  switch (kind) {
    case RobotRemarkKind::guessed: return "guessed";
    case RobotRemarkKind::repaired: return "repaired";
    case RobotRemarkKind::left_out: return "left out";
  }
  return "";
}

RobotFileNote note_on(const SourceLocation& location, const RobotRemark& remark) {
  RobotFileNote note;
  note.location = location;
  note.text = fmt::format("{}: {}", word_of(remark.kind), remark.text);
  return note;
}

/// Place of a remark or problem in a file, or in one that it includes.
SourceLocation place_of(const std::filesystem::path& robot_file, const std::string& part, int line) {
  const std::filesystem::path file = part.empty() ? robot_file : robot_file.parent_path() / part;
  return {file.string(), line, 0};
}

/// The digest of a file that includes others covers all of their texts.
void take_parts(const FolderOfRobot& folder, ModelSection& section) {
  std::string digests = section.file_digest;
  for (const auto& [file, text] : folder.read_files()) {
    section.parts.push_back(file);
    digests += sha256(text);
  }
  if (!section.parts.empty()) section.file_digest = sha256(digests);
}

void read_one(ModelSection& section, const PluginCatalog& catalog, const std::vector<NamedFormat>& formats,
              std::vector<RobotFileNote>& notes, ProblemList& problems) {
  const NamedFormat& format = format_for(section.file, *section.foreign_text, catalog, formats);
  const FolderOfRobot folder(section.file);
  const RobotText text{section.file.filename().string(), *section.foreign_text, section.base, &folder};
  ReadRobot read =
      guarded_call(catalog.origin<RobotFormat>(format.name), "read", [&] { return format.format->read(text); });
  for (const RobotFileProblem& problem : read.problems)
    problems.add(place_of(section.file, problem.file, problem.line), problem.text);
  for (const RobotRemark& remark : read.remarks)
    notes.push_back(note_on(place_of(section.file, remark.file, remark.line), remark));
  section.declared = std::move(read.robot);
  section.foreign_text.reset();
  take_parts(folder, section);
}

/// Model and target often have one file.
void take_over(const ModelSection& from, ModelSection& section) {
  section.declared = from.declared;
  section.file_digest = from.file_digest;
  section.parts = from.parts;
  section.foreign_text.reset();
}

void read_foreign(const std::vector<ModelSection*>& foreign, const PluginCatalog& catalog,
                  std::vector<RobotFileNote>& notes, ProblemList& problems) {
  const std::vector<NamedFormat> formats = formats_of(catalog);
  const std::string first_digest = foreign.front()->file_digest;
  for (ModelSection* section : foreign) {
    ModelSection& first = *foreign.front();
    if (section == &first || section->file_digest != first_digest || section->base != first.base ||
        section->file != first.file)
      read_one(*section, catalog, formats, notes, problems);
    else
      take_over(first, *section);
  }
}

/// Only foreign formats have these settings.
void refuse_base(const Experiment& experiment, const ModelSection& section, const std::string& key,
                 ProblemList& problems) {
  if (section.base != RobotBase::as_written && section.declared && !section.foreign_text)
    problems.add(experiment.where(key + ".base"),
                 "is for robots in URDF or MJCF; in a TOML robot, a body that is not the child of a joint floats");
  if (!section.drive.empty() && section.declared && !section.foreign_text)
    problems.add(experiment.where(key + ".actuator_kinds"),
                 "is for robots in URDF or MJCF; in a TOML robot write the kind of the actuator, as in kind = "
                 "\"position_servo\"");
}

}  // namespace

std::string robot_format_of(const std::filesystem::path& file, const std::string& text, const PluginCatalog& catalog) {
  return format_for(file, text, catalog, formats_of(catalog)).name;
}

std::vector<RobotFileNote> read_robot_files(Experiment& experiment, const PluginCatalog& catalog) {
  std::vector<RobotFileNote> notes;
  std::vector<ModelSection*> foreign;
  ProblemList problems;
  const std::pair<ModelSection*, const char*> sections[] = {{&experiment.model, "model"},
                                                            {&experiment.target.simulated.system, "target"}};
  for (const auto& [section, key] : sections) {
    refuse_base(experiment, *section, key, problems);
    if (section->foreign_text) foreign.push_back(section);
  }
  if (!foreign.empty()) read_foreign(foreign, catalog, notes, problems);
  for (const auto& [section, key] : sections)
    if (section->declared && !section->held.empty())
      hold_joints(*section->declared, experiment, *section, key, problems);
  for (const auto& [section, key] : sections)
    if (section->declared && !section->drive.empty())
      set_drives(*section->declared, experiment, *section, key, problems);
  problems.throw_if_any();
  return notes;
}

}  // namespace lacuna
