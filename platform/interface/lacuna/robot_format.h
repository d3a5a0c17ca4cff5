#pragma once

#include <lacuna/robot_spec.h>

#include <string>
#include <vector>

namespace lacuna {

/// A robot file of others as it stands.
struct RobotText {
  std::string name;  ///< of the file, without its folder
  std::string text;
};

/// What a reader of robot files did with something that stands there.
enum class RobotRemarkKind {
  guessed,   ///< it is not written, and something usual is taken
  repaired,  ///< what is written cannot be, and the nearest that can is taken
  left_out   ///< the program has no place for it
};

struct RobotRemark {
  RobotRemarkKind kind = RobotRemarkKind::left_out;
  int line = 0;      ///< from 1; 0: the whole file
  std::string text;  ///< a sentence without its end
};

/// What makes a file unusable, with its line, from 1; 0: the whole file.
struct RobotFileProblem {
  int line = 0;
  std::string text;  ///< where, what, and what to do
};

/// A robot file, read. Of one with problems the robot means nothing.
struct ReadRobot {
  RobotSpec robot;
  std::vector<RobotRemark> remarks;
  std::vector<RobotFileProblem> problems;
};

/// Reads robot files of one format: `[model] file = "arm.urdf"`. Const and shared by threads; the same text gives the
/// same robot. No file but the given text is opened, and nothing of it is executed.
class RobotFormat {
 public:
  virtual ~RobotFormat() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  /// Endings of such files, ".urdf". A file of another ending is none, whatever is in it.
  virtual std::vector<std::string> endings() const = 0;
  virtual ReadRobot read(const RobotText& file) const = 0;
};

}  // namespace lacuna
