#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// Calls `work(index)` for every index below `count` in a child process and tells how each ended:
/// empty where it returned, else what ended the child, as in "is ended by signal 7 (Bus error)" or
/// "takes longer than 10 s". One child does all; only after a death does another one go on
/// with the next index, so that the usual price is one fork. The child prints nothing and leaves no core file.
///
/// Call it before the process has threads: the child of a threaded process may hang in a lock that
/// one of them held (the time limit then ends it).
std::vector<std::string> survive_in_child(std::size_t count, const std::function<void(std::size_t index)>& work,
                                          unsigned seconds_each = 10);

}  // namespace lacuna
