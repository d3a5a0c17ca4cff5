#include "measurement/trials/unread_drives.h"

#include "measurement/names/column_words.h"
#include "measurement/names/header_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

bool looks_like_a_drive(const std::string& core) {
  const std::vector<std::string> words = words_of(core);
  return role_in_words(words) == ColumnRole::command;
}

}  // namespace

void note_unread_drives(const RecordingSource& source, const CsvFormat& format, FileReport& report) {
  if (!source.commands.empty() || !source.controllers.empty()) return;
  const std::vector<CoreName> cores = core_names(format.names);
  std::vector<std::string> unread;
  for (std::size_t i = 0; i < cores.size(); ++i) {
    const bool is_read = format.names[i] == source.time_column ||
                         std::any_of(source.sensors.begin(), source.sensors.end(),
                                     [&](const ColumnMapping& sensor) { return sensor.column == format.names[i]; });
    if (!is_read && looks_like_a_drive(cores[i].text)) unread.push_back(format.names[i]);
  }
  if (unread.empty()) return;
  report.note("drives", format.header_line, [&] {
    return fmt::format(
        "no actuator has commands, and {} {} not read; if this drives the rig, the robot needs an actuator and "
        "[target.commands] the column",
        listed(unread), unread.size() == 1 ? "is" : "are");
  });
}

}  // namespace lacuna
