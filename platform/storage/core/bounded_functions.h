#pragma once

struct sqlite3;

namespace lacuna {

/// Puts functions of our own in the place of those of SQLite whose time grows with the product of two lengths, which
/// nothing could interrupt: `instr` and `replace` find the same in a time that grows with the sum, `trim`, `ltrim` and
/// `rtrim` take at most `kMostTrimmed` characters to be taken away. `printf` and `format` refuse at once to repeat a
/// character (`%.*c`) more often than a text may be long; SQLite's own count to the end first.
void add_bounded_functions(sqlite3* handle);
inline constexpr int kMostTrimmed = 64;

}  // namespace lacuna
