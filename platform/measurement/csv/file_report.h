#pragma once

#include "foundation/text/problem.h"
#include "foundation/text/problem.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// A finding while reading that is not an error: a documented correct reading, or a doubt.
struct ReadingNote {
  SourceLocation location;
  std::string message;
  bool doubt = false;  ///< the data that were read may be wrong or incomplete
};

/// Messages about one measured file: problems, which make it unusable, notes, and doubts, the notes that every command
/// repeats. Of similar messages the first three are kept, the last of them with "and 312 more like it". Messages are
/// passed as functions, so that a file with a million bad cells does not format a million sentences. Belongs to one
/// thread.
class FileReport {
 public:
  explicit FileReport(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }
  bool has_problems() const { return !problems_.shown.empty(); }

  /// `kind` identifies similar messages; `message` returns the sentence. Line 0: the whole file.
  template <typename Message>
  void problem(const std::string& kind, int line, Message&& message) {
    say(problems_, kind, line, std::forward<Message>(message));
  }
  template <typename Message>
  void note(const std::string& kind, int line, Message&& message) {
    say(notes_, kind, line, std::forward<Message>(message));
  }
  template <typename Message>
  void doubt(const std::string& kind, int line, Message&& message) {
    say(notes_, kind, line, std::forward<Message>(message), true);
  }

  /// Returns the collected messages.
  void move_to(ProblemList& problems, std::vector<ReadingNote>& notes);

 private:
  static constexpr int kShownOfAKind = 3;

  struct Sentence {
    int line = 0;
    std::string text;
    bool doubt = false;
  };
  struct Kind {
    int count = 0;
    std::size_t last_shown = 0;
  };
  struct Collection {
    std::map<std::string, Kind, std::less<>> kinds;
    std::vector<Sentence> shown;
  };

  template <typename Message>
  static void say(Collection& collection, const std::string& kind, int line, Message&& message, bool doubt = false) {
    Kind& seen = collection.kinds[kind];
    if (++seen.count > kShownOfAKind) return;
    seen.last_shown = collection.shown.size();
    collection.shown.push_back({line, message(), doubt});
  }
  static void count_the_rest(Collection& collection);

  std::string file_;
  Collection problems_;
  Collection notes_;
};

/// Text of a user's file for a message: at most 40 characters, nothing unprintable.
std::string excerpt(std::string_view text);

/// "`a`, `b`, `c` and 12 more" for a list of names.
std::string listed(const std::vector<std::string>& names);

}  // namespace lacuna
