#pragma once

#include <lacuna/robot_spec.h>

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Texts that lie in the folder of a robot file or below it. The host reads them, refuses paths that lead elsewhere,
/// and limits how much is read.
class FilesBeside {
 public:
  virtual ~FilesBeside() = default;

  /// Of the file that `path` names, from the robot file's folder on, "parts/arm.xml". Nothing where there is none that
  /// may be read.
  virtual std::optional<std::string> text_of(const std::string& path) const = 0;
};

/// What becomes of the body that everything hangs on.
enum class RobotBase {
  as_written,  ///< what the file says, or what is usual in the format
  held,        ///< the world holds it
  free         ///< it floats
};

/// A robot file of others as it stands.
struct RobotText {
  std::string name;  ///< of the file, without its folder
  std::string text;
  RobotBase base = RobotBase::as_written;
  const FilesBeside* beside = nullptr;  ///< null: there are no others
};

/// What a reader of robot files did with something that stands there.
enum class RobotRemarkKind {
  guessed,   ///< it is not written, and something usual is taken
  repaired,  ///< what is written cannot be, and the nearest that can is taken
  left_out   ///< the program, or the format, has no place for it
};

struct RobotRemark {
  RobotRemarkKind kind = RobotRemarkKind::left_out;
  int line = 0;           ///< from 1; 0: the whole file
  std::string text;       ///< a sentence without its end
  std::string file = {};  ///< one that lies beside the file and is part of it, as `FilesBeside` has it; empty: the file
};

/// What makes a file unusable, with its line, from 1; 0: the whole file.
struct RobotFileProblem {
  int line = 0;
  std::string text;       ///< where, what, and what to do
  std::string file = {};  ///< as of a remark
};

/// A robot file, read. Of one with problems the robot means nothing.
struct ReadRobot {
  RobotSpec robot;
  std::vector<RobotRemark> remarks;
  std::vector<RobotFileProblem> problems;
};

/// A robot that is to become a file.
struct RobotToWrite {
  RobotSpec robot;
  std::optional<RobotText> original;  ///< a file of this format that it was read from, and whose rest is to stay
  std::string comment;                ///< for the head of the file, in lines; the format's own marks come to it
};

/// A robot file, made. With problems there is no text.
struct WrittenRobot {
  std::string text;
  std::vector<RobotRemark> remarks;  ///< what the format has no place for; lines do not count
  std::vector<RobotFileProblem> problems;
};

/// Reads robot files of one format, and may write them: `[model] file = "arm.urdf"`, `lacuna export --urdf`. Const and
/// shared by threads; the same text gives the same robot. No file but the given texts is opened, and nothing of them is
/// executed.
class RobotFormat {
 public:
  virtual ~RobotFormat() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  /// Endings of such files, ".urdf". A file of another ending is none, whatever is in it.
  virtual std::vector<std::string> endings() const = 0;
  /// Whether a text with such an ending is meant to be of this format; asked where several formats have the ending.
  virtual bool is_meant(const std::string& /*text*/) const { return true; }
  virtual ReadRobot read(const RobotText& file) const = 0;
  /// Values that the format has a place for are to come back, when the text is read, as the same numbers. An original
  /// keeps its comments, its order and what models have no place for. By default a format cannot write.
  virtual WrittenRobot write(const RobotToWrite& /*robot*/) const {
    return {{}, {}, {{0, "this format can be read, not written", {}}}};
  }
};

}  // namespace lacuna
