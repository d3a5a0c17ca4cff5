#pragma once

#include "measurement/recording.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace lacuna {

/// A hinge with an angle sensor and a torque motor: columns t (s), q (rad), u (N*m).
inline RecordingSource pendulum_source(const std::filesystem::path& file) {
  RecordingSource source;
  source.files = {{.path = file, .location = {"rig.toml", 3, 10}}};
  source.sensors.resize(1);
  source.sensors[0].channel = "angle";
  source.sensors[0].column = "q";
  source.sensors[0].unit = "rad";
  source.sensors[0].location = {"rig.toml", 7, 1};
  source.commands.resize(1);
  source.commands[0].channel = "motor";
  source.commands[0].column = "u";
  source.commands[0].unit = "N*m";
  source.commands[0].location = {"rig.toml", 9, 1};
  return source;
}

inline const std::vector<Channel> kPendulumChannels = {{"angle", "rad"}, {"rate", "rad/s"}};
inline const std::vector<Channel> kPendulumActuators = {{"motor", "N*m"}};

inline Recording read_pendulum(const RecordingSource& source) {
  return read_recording(source, kPendulumChannels, kPendulumActuators, {"joint.hinge"});
}

/// What `read_pendulum` says: the problems, or the notes of a reading that works.
inline std::string complaint_of(const RecordingSource& source) {
  try {
    read_pendulum(source);
  } catch (const BadInput& error) {
    return error.what();
  }
  return {};
}

inline std::string notes_of(const Recording& recording) {
  std::string text;
  for (const ReadingNote& note : recording.notes) text += to_string(note.location) + ": " + note.message + "\n";
  return text;
}

}  // namespace lacuna
