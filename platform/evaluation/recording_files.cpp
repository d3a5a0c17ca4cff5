#include "evaluation/recording_files.h"

#include "foundation/processes/guarded_call.h"
#include "foundation/plugins/plugin_call.h"
#include "evaluation/joined_recording.h"
#include "foundation/recording_folder.h"
#include "measurement/csv/measured_text.h"
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace lacuna {
namespace {

constexpr double kSlowestReading = 1e6;  ///< bytes/s that any disk and reader reach

/// A large file gets more time.
double allowed_seconds(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  return unknown ? 0.0 : static_cast<double>(size) / kSlowestReading;
}

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

PluginRecordingFormats::PluginRecordingFormats(const PluginCatalog& catalog) {
  for (const std::string& name : catalog.names<RecordingFormat>()) {
    const RecordingFormat& format = catalog.get<RecordingFormat>(name);
    Known known{catalog.origin<RecordingFormat>(name), &format, {}};
    known.endings = guarded_call(known.origin, "endings", [&] { return format.endings(); });
    formats_.push_back(std::move(known));
  }
}

const PluginRecordingFormats::Known* PluginRecordingFormats::find(const std::filesystem::path& file) const {
  const std::string name = in_lower_case(file.filename().string());
  const Known* found = nullptr;
  std::size_t longest = 0;
  for (const Known& known : formats_)
    for (const std::string& ending : known.endings)
      if (name.ends_with(ending) && ending.size() > longest) {
        found = &known;
        longest = ending.size();
      }
  return found;
}

bool PluginRecordingFormats::reads(const std::filesystem::path& file) const {
  return find(file) != nullptr || is_recording_folder(file);
}

std::vector<std::filesystem::path> PluginRecordingFormats::parts_of(const std::filesystem::path& folder,
                                                                    std::vector<RecordingSentence>& problems) const {
  std::vector<std::filesystem::path> parts;
  std::string others;
  for (const std::filesystem::path& file : files_of_recording(folder)) {
    const std::string reason = why_no_file(file);
    if (find(file) != nullptr && reason.empty()) {
      parts.push_back(file);
    } else if (find(file) != nullptr) {
      problems.push_back({0, fmt::format("its file {}: {}; copy it there, or name one of the files in the folder",
                                         file.filename().string(), reason)});
    } else {
      others += (others.empty() ? "" : ", ") + file.filename().string();
    }
  }
  if (parts.empty() && problems.empty())
    problems.push_back({0, others.empty() ? "has a metadata.yaml, but no recording beside it; copy its .mcap or .db3 "
                                            "files there"
                                          : fmt::format("has no file that can be read as a recording, only {}; unpack "
                                                        "compressed files",
                                                        others)});
  return parts;
}

RecordingContents PluginRecordingFormats::contents(const std::filesystem::path& file) const {
  if (!is_recording_folder(file)) return contents_of_file(file);
  std::vector<std::string> names;
  std::vector<RecordingContents> contents;
  std::vector<RecordingSentence> problems;
  for (const std::filesystem::path& part : parts_of(file, problems)) {
    names.push_back(part.filename().string());
    contents.push_back(contents_of_file(part));
  }
  RecordingContents whole = joined_contents(names, std::move(contents));
  whole.problems.insert(whole.problems.begin(), problems.begin(), problems.end());
  return whole;
}

ReadRows PluginRecordingFormats::read(const std::filesystem::path& file, const std::vector<TableQuery>& queries) const {
  return is_recording_folder(file) ? read_folder(file, queries) : read_file(file, queries);
}

ReadRows PluginRecordingFormats::read_folder(const std::filesystem::path& folder,
                                             const std::vector<TableQuery>& queries) const {
  ReadRows whole;
  whole.tables.resize(queries.size());
  for (const std::filesystem::path& part : parts_of(folder, whole.problems)) {
    const RecordingContents contents = contents_of_file(part);
    std::vector<TableQuery> own;
    for (std::size_t q = 0; q < queries.size(); ++q)
      own.push_back(query_of_part(queries[q], contents, row_count(whole.tables[q])));
    std::vector<TableQuery> asked = own;
    std::erase_if(asked, [](const TableQuery& query) { return query.columns.empty(); });
    ReadRows rows = read_file(part, asked);
    const auto take = [&](const std::vector<RecordingSentence>& from, std::vector<RecordingSentence>& to) {
      for (const RecordingSentence& one : from) to.push_back({0, part.filename().string() + ": " + one.text});
    };
    take(rows.remarks, whole.remarks);
    take(rows.doubts, whole.doubts);
    take(rows.problems, whole.problems);
    if (!whole.problems.empty() || rows.tables.size() != asked.size()) return whole;
    for (std::size_t q = 0, next = 0; q < queries.size(); ++q)
      append_rows(queries[q], own[q], own[q].columns.empty() ? RecordedRows() : rows.tables[next++], whole.tables[q]);
  }
  return whole;
}

RecordingContents PluginRecordingFormats::contents_of_file(const std::filesystem::path& file) const {
  const Known& known = *find(file);
  const CallAllowance allowance(allowed_seconds(file));
  return guarded_call(known.origin, "contents", [&] { return known.format->contents(file.string()); });
}

ReadRows PluginRecordingFormats::read_file(const std::filesystem::path& file,
                                           const std::vector<TableQuery>& queries) const {
  const Known& known = *find(file);
  const CallAllowance allowance(allowed_seconds(file));
  return guarded_call(known.origin, "read", [&] { return known.format->read(file.string(), queries); });
}

}  // namespace lacuna
