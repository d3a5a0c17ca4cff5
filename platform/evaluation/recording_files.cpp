#include "evaluation/recording_files.h"

#include "foundation/processes/guarded_call.h"
#include "foundation/plugins/plugin_call.h"

#include <algorithm>
#include <cctype>

namespace lacuna {
namespace {

constexpr double kSlowestReading = 1e6;  ///< bytes/s that a disk and a reader may take in any case

/// A large file may take its time.
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

bool PluginRecordingFormats::reads(const std::filesystem::path& file) const { return find(file) != nullptr; }

RecordingContents PluginRecordingFormats::contents(const std::filesystem::path& file) const {
  const Known& known = *find(file);
  const CallAllowance allowance(allowed_seconds(file));
  return guarded_call(known.origin, "contents", [&] { return known.format->contents(file.string()); });
}

ReadRows PluginRecordingFormats::read(const std::filesystem::path& file, const std::vector<TableQuery>& queries) const {
  const Known& known = *find(file);
  const CallAllowance allowance(allowed_seconds(file));
  return guarded_call(known.origin, "read", [&] { return known.format->read(file.string(), queries); });
}

}  // namespace lacuna
