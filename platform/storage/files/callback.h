#pragma once

namespace lacuna {

/// Work that SQLite calls back. An exception must not pass through SQLite, which would leave statements open behind it:
/// where one is thrown, this is not 0, which ends the statement with SQLITE_ABORT.
template <class Work>
int called_back(const Work& work) noexcept {
  try {
    work();
    return 0;
  } catch (...) {
    return 1;
  }
}

}  // namespace lacuna
