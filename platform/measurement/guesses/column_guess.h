#pragma once

#include "measurement/names/column_role.h"
#include "measurement/guesses/file_sample.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A point that a video was searched for: its x and y go round a circle, as a point on a hinged body does.
struct GuessedTrack {
  std::string other;                    ///< the column of y
  double pivot_x = 0.0, pivot_y = 0.0;  ///< m, the circle's centre
  double radius = 0.0, scatter = 0.0;   ///< m; root mean square distance from the circle
};

/// Where the angle of a track is taken to be zero, rad from x towards y: hanging down, with y up.
inline constexpr double kHangingDown = -1.5707963267948966;

struct GuessedColumn {
  std::string name;
  ColumnRole role = ColumnRole::other;
  std::string unit;    ///< in the notation of foundation/unit.h; empty: not known
  std::string joint;   ///< what in the name tells joints apart: "1" in `q1`, "elbow" in `elbow_angle_deg`; often empty
  std::string reason;  ///< why this role, half a sentence
  bool of_velocity = false;  ///< its words speak of a velocity; of a reference: the velocity is what it wants
  bool of_effort = false;    ///< a torque or a force, by its unit or its words
  bool of_voltage = false;   ///< a voltage, by its unit or its words
  bool in_si = false;        ///< its unit is not known, but it is SI
  bool named_by_user = false;
  std::optional<GuessedTrack> track = {};  ///< of the column of x: it is an angle together with y
  bool in_track = false;                   ///< y of such a point
  bool passed_over = false;                ///< the user named others for what it seemed to be
};

/// Columns that the user named; the rest is guessed.
struct ColumnHints {
  std::string time;
  std::vector<std::string> positions, velocities, commands;
};

/// Guesses every column of a file, in its order, from names, units in names or in a row of units, and
/// values: the time column rises, and of two positions that go together the one that lags was measured and the
/// other is its reference. Where a file has the columns of several runs side by side, those of the first are taken;
/// of a quantity in two units one. A column that a hint names and the file does not have is an `Error`.
std::vector<GuessedColumn> guess_columns(const FileSample& sample, const ColumnHints& hints);

}  // namespace lacuna
