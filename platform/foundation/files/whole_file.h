#pragma once

#include <ext/stdio_filebuf.h>
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace lacuna {

/// What becomes of a symbolic link that has the file's name.
enum class Link {
  followed,  ///< of a file that the user named: the link stays, and the file that it points to is written
  replaced   ///< of a name that we chose in a folder: whatever a link there points to is left alone
};

/// A file that is replaced whole or not at all. What is written goes into a draft in the same folder; `publish` gives
/// the complete draft, once it is on the disk, the file's name. Until then, and wherever something fails, the old file
/// stays as it is, and the draft ends with the object. It has no name before `publish` (O_TMPFILE), so that a killed
/// process leaves none; where that cannot be, or in the moment of `publish`, a hidden file `.lacuna-...` is left, which
/// the next one of the same machine that writes into the folder removes: at once where its process has ended, or an
/// hour later where that cannot be told (of a library's draft after the machine was started anew). Permissions of a
/// file that is replaced stay. What a user named and is no regular file (/dev/stdout, a pipe) has nothing to be
/// replaced and is written into directly.
class WholeFile {
 public:
  /// Throws `Error` where nothing can be written there.
  WholeFile(const std::filesystem::path& file, Link link);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// A name of the draft, for a library that opens files itself; whoever holds it closes the file before `publish`.
  /// Nothing keeps the library from locking it. Throws `Error` where it can have none.
  const std::filesystem::path& named_draft();
  /// Brings what was written to the disk. Throws `Error` where it does not fit.
  void finish();
  /// `finish`, and the draft takes the file's place.
  void publish();
  /// The same, but throws `Error` where there is a regular file of that name, which is left alone.
  void publish_as_new();

 private:
  void name_draft(const std::string& kind);
  bool give_name(const std::filesystem::path& name);
  bool rename_draft(const std::filesystem::path& name);

  const std::filesystem::path file_;    ///< as it was named, for messages
  const std::filesystem::path target_;  ///< what is written
  const bool direct_;
  std::filesystem::path draft_;  ///< empty: it has no name
  std::optional<__gnu_cxx::stdio_filebuf<char>> buffer_;
  std::ostream stream_;
};

/// What becomes of a file that has the name already.
enum class Existing { replaced, refused };

/// Writes a whole text so.
void write_whole(const std::filesystem::path& file, std::string_view text, Link link,
                 Existing existing = Existing::replaced);

/// What is wrong with a name whose symbolic links lead to no file, only to each other.
inline constexpr const char* kCircleOfLinks = "its symbolic links form a circle; remove the link or name another file";

/// The absolute name of the file that a name leads to, which need not be there yet: without links, `.` and `..`.
std::filesystem::path place_of(const std::filesystem::path& file);

/// Whether two names lead to one file, which need not be there yet.
bool are_one_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether a file is there whose place a `WholeFile` with followed links would take.
bool is_replaceable(const std::filesystem::path& file);

/// Why a file that the user named could not be written, for a check before long work; nothing if it can.
std::optional<std::string> why_not_writable(const std::filesystem::path& file);
/// The same for new files in a folder that is there.
std::optional<std::string> why_not_writable_into(const std::filesystem::path& folder);

}  // namespace lacuna
