#pragma once

#include "loading/plugin_catalog.h"
#include "measurement/trials/recording_formats.h"

#include <string>
#include <vector>

namespace lacuna {

/// The recording formats of a catalog, which outlives it. The ending of a file's name decides; the longest match
/// counts. A folder that is a recording (foundation/recording_folder.h) is read as one file: its files in order.
class PluginRecordingFormats : public RecordingFormats {
 public:
  explicit PluginRecordingFormats(const PluginCatalog& catalog);

  bool reads(const std::filesystem::path& file) const override;
  /// Both throw `ComponentError` where the plugin fails.
  RecordingContents contents(const std::filesystem::path& file) const override;
  ReadRows read(const std::filesystem::path& file, const std::vector<TableQuery>& queries) const override;

 private:
  struct Known {
    ComponentOrigin origin;
    const RecordingFormat* format = nullptr;
    std::vector<std::string> endings;
  };
  const Known* find(const std::filesystem::path& file) const;
  RecordingContents contents_of_file(const std::filesystem::path& file) const;
  ReadRows read_file(const std::filesystem::path& file, const std::vector<TableQuery>& queries) const;
  /// The files of a recording's folder that a format reads, and why others that belong to it cannot be.
  std::vector<std::filesystem::path> parts_of(const std::filesystem::path& folder,
                                              std::vector<RecordingSentence>& problems) const;
  ReadRows read_folder(const std::filesystem::path& folder, const std::vector<TableQuery>& queries) const;

  std::vector<Known> formats_;
};

}  // namespace lacuna
