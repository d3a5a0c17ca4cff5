#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/target_system.h>
#include <lacuna/time_series.h>

#include "foundation/processes/stop.h"
#include "foundation/recording_source.h"
#include "measurement/csv/file_report.h"
#include "measurement/trials/recording_formats.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

struct Recording {
  std::vector<Trial> trials;  ///< fit trials first, each in file order
  std::vector<ReadingNote> notes;
};

/// Reads the files of a recorded target into trials. `channels` and `actuators` are those of the model's robot with
/// their SI units; mappings to anything else are problems. `coordinates` names the robot's joint coordinates,
/// `joint.hinge` or `joint.wrist.1`, and is only needed where the source gives initial values. Throws `BadInput` with
/// every problem of every file.
///
/// Channels of a trial are in the robot's order, whatever the order of the mappings; channels without a mapping are
/// left out. Commands and measured channels share the file's time stamps, shifted so that a trial starts at 0 s.
/// docs/reference/measurements.md describes the accepted files. Files are CSV or of one of the other `formats`, if
/// there are any. Throws `Interrupted` where `stop` ends the comparison of clocks.
Recording read_recording(const RecordingSource& source, const std::vector<Channel>& channels,
                         const std::vector<Channel>& actuators, const std::vector<std::string>& coordinates = {},
                         const RecordingFormats* formats = nullptr, const Stop& stop = {});

/// The same for a robot.
Recording read_recording(const RecordingSource& source, const RobotSpec& robot,
                         const RecordingFormats* formats = nullptr, const Stop& stop = {});

/// The host's service for targets: reads the source again at each call.
class RecordingReader : public TrialReader {
 public:
  /// `on_note` receives every reading note; it may be empty. `formats` as above, and outlives the reader.
  RecordingReader(RecordingSource source, RobotSpec robot, std::function<void(const ReadingNote&)> on_note = {},
                  const RecordingFormats* formats = nullptr, const Stop& stop = {});
  std::vector<Trial> read() const override;

 private:
  RecordingSource source_;
  RobotSpec robot_;
  std::function<void(const ReadingNote&)> on_note_;
  const RecordingFormats* formats_;
  Stop stop_;
};

}  // namespace lacuna
