#pragma once

#include "measurement/names/column_role.h"
#include "measurement/guesses/file_sample.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A point tracked in a video: its x and y lie on a circle, as for a point on a hinged body.
struct GuessedTrack {
  std::string other;                    ///< the column of y
  double pivot_x = 0.0, pivot_y = 0.0;  ///< m, the circle's centre
  double radius = 0.0, scatter = 0.0;   ///< m; root mean square distance from the circle
};

/// Direction in which the angle of a track is zero, rad from x towards y: hanging down, with y up.
inline constexpr double kHangingDown = -1.5707963267948966;

struct GuessedColumn {
  std::string name;
  ColumnRole role = ColumnRole::other;
  std::string unit;  ///< in the notation of foundation/unit.h; empty: not known
  /// Part of the name that distinguishes joints: "1" in `q1`, "elbow" in `elbow_angle_deg`; often empty.
  std::string joint;
  std::string reason;        ///< reason for this role, half a sentence
  bool of_velocity = false;  ///< its words mean a velocity; for a reference: a velocity setpoint
  bool of_effort = false;    ///< a torque or a force, by its unit or its words
  bool of_voltage = false;   ///< a voltage, by its unit or its words
  bool in_si = false;        ///< its unit is not known, SI is assumed
  bool named_by_user = false;
  std::optional<GuessedTrack> track = {};  ///< of the column of x: an angle together with y
  bool in_track = false;                   ///< y of such a point
  bool passed_over = false;                ///< the user named other columns for its apparent role
};

/// Columns that the user named; the rest is guessed.
struct ColumnHints {
  std::string time;
  std::vector<std::string> positions, velocities, commands;
};

/// Guesses the role of every column of a file, in its order, from names, units in names or in a row of units, and
/// values: the time column increases, and of two related positions the one that lags is measured and the other its
/// reference. Of several runs side by side the first is used; of a quantity in two units, one column. A column named by
/// a hint but missing in the file is an `Error`.
std::vector<GuessedColumn> guess_columns(const FileSample& sample, const ColumnHints& hints);

}  // namespace lacuna
