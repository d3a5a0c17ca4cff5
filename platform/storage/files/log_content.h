#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// What tells whether a log belongs to a database: with each commit of ours the row `log` of `schema_text` gets a new
/// random number, beside the one that it had before. The log of a database thus holds the chain of these numbers from
/// the state on which it was begun, and the file the number of that state or of a later one in the log. No copy and no
/// other database has it.
struct LogMark {
  std::string before;  ///< hexadecimal; `kNoMark` where the row was made
  std::string now;
};
inline constexpr std::string_view kNoMark = "00000000000000000000000000000000";
inline constexpr std::string_view kMarkWord = "lacuna-log ";
/// The marks that stand in a page or another stretch of bytes.
std::vector<LogMark> marks_in(std::string_view bytes);

/// The first bytes of a database file, or of its first page: https://sqlite.org/fileformat.html
class FileHeader {
 public:
  static constexpr std::size_t kSize = 108;  ///< with the header of the first page
  explicit FileHeader(std::string_view bytes);

  bool is_database() const;
  std::uint32_t page_size() const;
  std::uint32_t application() const { return number(68); }
  std::uint32_t change_counter() const { return number(24); }
  std::uint32_t schema_counter() const { return number(40); }
  /// Nothing where the file does not say for certain.
  std::optional<std::uint32_t> pages() const;
  /// Whether it has neither tables nor views.
  bool is_blank() const;

 private:
  std::uint32_t number(std::size_t at) const;
  std::array<char, kSize> bytes_{};
};

/// A page in a log.
struct LogFrame {
  std::uint32_t page = 0;             ///< from 1
  std::uint32_t pages_at_commit = 0;  ///< of the database, where a transaction ends here; else 0
  std::string_view content;
};

/// A file `FILE-wal`.
class WriteAheadLog {
 public:
  explicit WriteAheadLog(const std::filesystem::path& file) : file_(file) {}
  /// In the order in which they were written, without those that remain of an earlier use of the file, until `look`
  /// returns false. Returns the pages' size; 0: the file is no log.
  std::uint32_t for_each_frame(const std::function<bool(const LogFrame&)>& look) const;

 private:
  std::filesystem::path file_;
};

/// A file `FILE-journal`: what pages were before a transaction that has not ended.
struct RollbackJournal {
  bool hot = false;  ///< SQLite would play it back
  std::uint32_t page_size = 0;
  std::uint32_t pages = 0;               ///< of the database before
  std::optional<FileHeader> first_page;  ///< as it was before
};
RollbackJournal read_journal(const std::filesystem::path& file);

}  // namespace lacuna
