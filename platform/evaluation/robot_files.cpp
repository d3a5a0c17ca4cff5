#include "evaluation/robot_files.h"

#include "foundation/guarded_call.h"

#include <lacuna/robot_format.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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
  for (const PluginListing& listing : catalog.list()) {
    if (listing.kind != ComponentKind<RobotFormat>::noun) continue;
    const RobotFormat& format = catalog.get<RobotFormat>(listing.name);
    formats.push_back({listing.name, &format, guarded_call(catalog.origin<RobotFormat>(listing.name), "endings", [&] {
                         return format.endings();
                       })});
  }
  return formats;
}

const NamedFormat& format_for(const std::filesystem::path& file, const std::vector<NamedFormat>& formats) {
  std::vector<std::string> known = {".toml"};
  for (const NamedFormat& format : formats) {
    if (std::any_of(format.endings.begin(), format.endings.end(),
                    [&](const std::string& ending) { return file.string().ends_with(ending); }))
      return format;
    known.insert(known.end(), format.endings.begin(), format.endings.end());
  }
  throw_problem({file.string(), 0, 0}, fmt::format("is no robot file that can be read: its name ends with none of {}",
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

RobotFileNote note_on(const std::string& file, const RobotRemark& remark) {
  RobotFileNote note;
  note.location = {file, remark.line, 0};
  note.text = fmt::format("{}: {}", word_of(remark.kind), remark.text);
  return note;
}

void read_one(ModelSection& section, const PluginCatalog& catalog, const std::vector<NamedFormat>& formats,
              std::vector<RobotFileNote>& notes, ProblemList& problems) {
  const NamedFormat& format = format_for(section.file, formats);
  const std::string file = section.file.string();
  const RobotText text{section.file.filename().string(), *section.foreign_text};
  ReadRobot read =
      guarded_call(catalog.origin<RobotFormat>(format.name), "read", [&] { return format.format->read(text); });
  for (const RobotFileProblem& problem : read.problems) problems.add({file, problem.line, 0}, problem.text);
  for (const RobotRemark& remark : read.remarks)
    notes.push_back(note_on(file, remark));
  section.declared = std::move(read.robot);
  section.foreign_text.reset();
}

/// Model and target often have one file.
void take_over(const ModelSection& from, ModelSection& section) {
  section.declared = from.declared;
  section.foreign_text.reset();
}

}  // namespace

std::vector<RobotFileNote> read_robot_files(Experiment& experiment, const PluginCatalog& catalog) {
  std::vector<RobotFileNote> notes;
  std::vector<ModelSection*> foreign;
  for (ModelSection* section : {&experiment.model, &experiment.target.simulated.system})
    if (section->foreign_text) foreign.push_back(section);
  if (foreign.empty()) return notes;
  const std::vector<NamedFormat> formats = formats_of(catalog);
  ProblemList problems;
  for (ModelSection* section : foreign) {
    ModelSection& first = *foreign.front();
    if (section == &first || section->file_digest != first.file_digest)
      read_one(*section, catalog, formats, notes, problems);
    else
      take_over(first, *section);
  }
  problems.throw_if_any();
  return notes;
}

}  // namespace lacuna
