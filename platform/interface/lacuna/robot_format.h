#pragma once

#include <lacuna/robot_spec.h>

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Texts in the folder of a robot file or below it. The host reads them, refuses paths that lead elsewhere, and limits
/// the amount read.
class FilesBeside {
 public:
  virtual ~FilesBeside() = default;

  /// The text of the file `path`, relative to the robot file's folder, "parts/arm.xml". Nothing where no readable file
  /// exists.
  virtual std::optional<std::string> text_of(const std::string& path) const = 0;
};

/// The attachment of the root body.
enum class RobotBase {
  as_written,  ///< as in the file, or as usual in the format
  held,        ///< fixed to the world
  free         ///< it floats
};

/// A robot file of another program, unchanged.
struct RobotText {
  std::string name;  ///< file name without its folder
  std::string text;
  RobotBase base = RobotBase::as_written;
  const FilesBeside* beside = nullptr;  ///< null: no other files
};

/// What the reader did with an element of the file.
enum class RobotRemarkKind {
  guessed,   ///< a value is missing, and a usual one is used
  repaired,  ///< a value is impossible, and the nearest possible one is used
  left_out   ///< the program, or the format, does not support it
};

struct RobotRemark {
  RobotRemarkKind kind = RobotRemarkKind::left_out;
  int line = 0;           ///< from 1; 0: the whole file
  std::string text;       ///< a sentence without a full stop
  std::string file = {};  ///< another file that is part of this one, as in `FilesBeside`; empty: the file
};

/// A problem that makes a file unusable, with its line, from 1; 0: the whole file.
struct RobotFileProblem {
  int line = 0;
  std::string text;       ///< where, what, and what to do
  std::string file = {};  ///< as in a remark
};

/// A robot that was read from a file. With problems the robot is invalid.
struct ReadRobot {
  RobotSpec robot;
  std::vector<RobotRemark> remarks;
  std::vector<RobotFileProblem> problems;
};

/// A robot to be written to a file.
struct RobotToWrite {
  RobotSpec robot;
  std::optional<RobotText> original;  ///< the file of this format from which it was read, whose other content is kept
  std::string comment;                ///< comment lines for the head of the file, without the format's comment marks
};

/// A robot written as text. With problems there is no text.
struct WrittenRobot {
  std::string text;
  std::vector<RobotRemark> remarks;  ///< content that the format does not support; its lines are not used
  std::vector<RobotFileProblem> problems;
};

/// Reads robot files of one format, and may write them: `[model] file = "arm.urdf"`, `lacuna export --urdf`. Const and
/// shared by threads; the same text gives the same robot. Only the given texts are read, and nothing in them is
/// executed.
class RobotFormat {
 public:
  virtual ~RobotFormat() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  /// File endings such as ".urdf". Files with other endings are not read, whatever they contain.
  virtual std::vector<std::string> endings() const = 0;
  /// Whether a text is of this format; used where several formats have the same ending.
  virtual bool is_meant(const std::string& /*text*/) const { return true; }
  virtual ReadRobot read(const RobotText& file) const = 0;
  /// Values that the format supports must be the same numbers when the text is read again. An original keeps its
  /// comments, its order and its other content. By default a format cannot write.
  virtual WrittenRobot write(const RobotToWrite& /*robot*/) const {
    return {{}, {}, {{0, "this format can be read, not written", {}}}};
  }
};

}  // namespace lacuna
