#pragma once

#include "foundation/processes/stop.h"

#include <ext/stdio_filebuf.h>
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace lacuna {

/// Treatment of a symbolic link with the file's name.
enum class Link {
  followed,  ///< for a file that the user named: the link stays, and the file that it points to is written
  replaced   ///< for a name chosen by the program: the target of a link is left alone
};

/// A file that is replaced completely or not at all. Data go into a draft in the same folder; `publish` gives the
/// complete draft, once it is on the disk, the file's name. Until then, and after any failure, the old file stays as it
/// is, and the draft ends with the object. The draft has no name before `publish` (O_TMPFILE), so that a killed process
/// leaves none. Where that is impossible, or during `publish`, a hidden file `.lacuna-...` may be left. The next writer
/// of the same machine in that folder removes it: at once where its process has ended, or after an hour where that is
/// unknown (for a library's draft after a restart of the machine). Permissions of a file that is replaced stay. A name
/// that is not a regular file (/dev/stdout, a pipe) is written to directly.
class WholeFile {
 public:
  /// Throws `Error` where the file cannot be written, and `Interrupted` where `stop` ends the wait for the reader of a
  /// pipe.
  WholeFile(const std::filesystem::path& file, Link link, const Stop& stop = {});
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// A name for the draft, for a library that opens files itself; the library must close the file before `publish`. It
  /// may lock the file. Throws `Error` where no name is possible.
  const std::filesystem::path& named_draft();
  /// Writes the data to the disk. Throws `Error` where they do not fit.
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

/// Treatment of a file with the same name.
enum class Existing { replaced, refused };

/// Writes a whole text in this way.
void write_whole(const std::filesystem::path& file, std::string_view text, Link link,
                 Existing existing = Existing::replaced, const Stop& stop = {});

/// The fault of a name whose symbolic links lead to no file, only to each other.
inline constexpr const char* kCircleOfLinks = "its symbolic links form a circle; remove the link or name another file";

/// The absolute name of the file that a name leads to, which need not exist yet: without links, `.` and `..`.
std::filesystem::path place_of(const std::filesystem::path& file);

/// Whether two names lead to one file, which need not exist yet.
bool are_one_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether a `WholeFile` with followed links would replace an existing file.
bool is_replaceable(const std::filesystem::path& file);

/// Why a file that the user named cannot be written, for a check before long work; nothing if it can. A pipe is waited
/// for as `WholeFile` does.
std::optional<std::string> why_not_writable(const std::filesystem::path& file, const Stop& stop = {});
/// The same for new files in an existing folder.
std::optional<std::string> why_not_writable_into(const std::filesystem::path& folder);

}  // namespace lacuna
